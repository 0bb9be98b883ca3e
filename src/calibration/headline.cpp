#include "calibration/headline.h"

#include <cmath>

#include "base/requirements.h"

namespace tribolog::calibration {

namespace {

using method::hysteresis::LuGreParameterName;

HeadlineQuantity of_loops(const method::hysteresis::LuGreFit& fit, LuGreParameterName name) {
  HeadlineQuantity out;
  for (const method::hysteresis::LuGreParameter& parameter : fit.parameters) {
    if (parameter.name != name) continue;
    out.estimate = parameter.estimate;
    if (!parameter.estimate) out.why_not = parameter.why_not;
  }
  return out;
}

CurveHeadline headline_without_model(const Calibration& c) {
  CurveHeadline out;
  if (c.lugre && c.lugre->converged && c.lugre->shown(LuGreParameterName::coulomb_torque)) {
    out.source = HeadlineSource::loops;
    out.coulomb_Nm = of_loops(*c.lugre, LuGreParameterName::coulomb_torque);
    out.stribeck_speed_rad_s = of_loops(*c.lugre, LuGreParameterName::stribeck_speed);
    out.viscous_Nms_rad = of_loops(*c.lugre, LuGreParameterName::viscous);
    return out;
  }
  const Statement& why = c.friction.stage.reason;
  out.stribeck_speed_rad_s.why_not = why.empty() ? Statement{"verdict.no_stribeck_model"} : why;
  if (c.rough.coulomb_Nm || c.rough.viscous_Nms_rad) {
    out.source = HeadlineSource::sweep;
    out.coulomb_Nm.estimate = c.rough.coulomb_Nm;
    out.viscous_Nms_rad.estimate = c.rough.viscous_Nms_rad;
  }
  return out;
}

}  // namespace

CurveHeadline curve_headline(const Calibration& c) {
  const auto* coulomb = c.model.find(joint::Quantity::coulomb_torque);
  const auto* viscous = c.model.find(joint::Quantity::viscous_coefficient);
  if (coulomb == nullptr || viscous == nullptr) return headline_without_model(c);
  CurveHeadline out;
  out.source = HeadlineSource::model;
  out.coulomb_Nm = {coulomb->as_estimate(), {}};
  out.viscous_Nms_rad = {viscous->as_estimate(), {}};
  out.stribeck_speed_rad_s.estimate = c.model.law.stribeck_speed_rad_s;
  if (!c.model.law.has_dip()) {
    out.stribeck_speed_rad_s.why_not = {"cause.stribeck_not_shown",
                                        {{"slowest_rad_s", c.model.law.slowest_rad_s}}};
  }
  return out;
}

namespace {

double relative_half_width(const statistics::Estimate& e) {
  return e.half_width() / std::abs(e.value);
}

}  // namespace

InertiaHeadline inertia_headline(const Calibration& c) {
  std::optional<statistics::Estimate> loops;
  if (c.lugre) loops = c.lugre->shown(LuGreParameterName::inertia);
  if (const auto* model = c.model.find(joint::Quantity::inertia)) {
    constexpr double widest_known = 1;
    const statistics::Estimate of_model = model->as_estimate();
    const double width = relative_half_width(of_model);
    // Of another contact than LuGre's the loops' inertia is none.
    const bool is_lugre =
        loops && present(c.lugre->misfit_share()) < method::hysteresis::lugre_misfit;
    if (is_lugre && relative_half_width(*loops) < width) return {InertiaSource::loops, loops};
    return width < widest_known ? InertiaHeadline{InertiaSource::model, of_model}
                                : InertiaHeadline{};
  }
  const std::optional<statistics::Estimate>& sweep = c.rough.inertia_kgm2;
  if (sweep) return {InertiaSource::sweep, sweep};
  return loops ? InertiaHeadline{InertiaSource::loops, loops} : InertiaHeadline{};
}

}  // namespace tribolog::calibration
