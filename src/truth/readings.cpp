#include "truth/readings.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "base/enum_text.h"
#include "calibration/headline.h"

namespace tribolog::truth {
namespace {

using method::hysteresis::LuGreParameterName;

class Reader {
 public:
  void add(ReadingName name, ReadingKind quantity, const statistics::Estimate& estimate) {
    if (std::isfinite(estimate.value)) all_.push_back({name, quantity, estimate});
  }
  void add(ReadingName name, ReadingKind quantity,
           const std::optional<statistics::Estimate>& estimate) {
    if (estimate) add(name, quantity, *estimate);
  }
  std::vector<Reading> all() { return std::move(all_); }

 private:
  std::vector<Reading> all_;
};

void read_masses(const calibration::Calibration& c, std::initializer_list<ReadingName> names,
                 Reader& out) {
  for (const ReadingName name : names) {
    if (const method::hysteresis::SurrogateMass* mass =
            c.masses.find(calibration::estimator_of(name))) {
      out.add(name, ReadingKind::gravity, mass->gravity_Nm);
    }
  }
}

/// A and B of the steady loop, with the interval of their mean over the cycles.
void read_steady_points(const calibration::Calibration& c, Reader& out) {
  for (const method::hysteresis::LoopPoint& point : c.hysteresis.steady_points) {
    const bool is_a = point.name == method::hysteresis::Estimator::A;
    if (!is_a && point.name != method::hysteresis::Estimator::B) continue;
    const double cosine = c.q_peak_rad ? std::cos(point.q_rad - c.q_peak_rad->value) : 1.0;
    out.add(is_a ? ReadingName::A_steady : ReadingName::B_steady, ReadingKind::gravity,
            statistics::scaled({point.torque_Nm,
                                point.torque_low_Nm,
                                point.torque_high_Nm,
                                {"interval.scatter_of_cycles"}},
                               1 / cosine));
  }
}

void read_loop_fit(const method::hysteresis::LuGreFit& fit, Reader& out) {
  if (!fit.converged) return;
  out.add(ReadingName::fit, ReadingKind::gravity, fit.gravity_Nm);
  out.add(ReadingName::bristle_stiffness, ReadingKind::stiffness,
          fit.shown(LuGreParameterName::bristle_stiffness));
  out.add(ReadingName::static_torque, ReadingKind::static_torque,
          fit.shown(LuGreParameterName::static_torque));
}

void read_curve(const calibration::Calibration& c, Reader& out) {
  const calibration::CurveHeadline headline = calibration::curve_headline(c);
  const auto& w = c.friction.waiboer;
  const bool has_waiboer = w && w->converged;
  const bool is_of_waiboer = has_waiboer && runs_follow_waiboer(c);
  if (headline.source != calibration::HeadlineSource::sweep &&
      headline.source != calibration::HeadlineSource::loops) {
    out.add(ReadingName::coulomb, ReadingKind::coulomb, headline.coulomb_Nm.estimate);
    out.add(ReadingName::viscous, ReadingKind::viscous, headline.viscous_Nms_rad.estimate);
  }
  if (has_waiboer) {
    out.add(ReadingName::asperity_torque, ReadingKind::asperity_torque, w->asperity_torque_Nm);
  }
  out.add(ReadingName::stribeck_speed, ReadingKind::stribeck_speed,
          is_of_waiboer ? w->stribeck_speed_rad_s : headline.stribeck_speed_rad_s.estimate);
  if (has_waiboer) {
    out.add(ReadingName::stribeck_power, ReadingKind::stribeck_power, w->stribeck_power);
    out.add(ReadingName::viscous_coefficient, ReadingKind::viscous_factor, w->viscous_coefficient);
    out.add(ReadingName::viscous_power, ReadingKind::viscous_power, w->viscous_power);
  }
}

}  // namespace

std::string unit_of(ReadingKind quantity) {
  constexpr EnumTexts<ReadingKind> units("N·m", "rad", "N·m/rad", "N·m", "N·m", "N·m", "N·m·s/rad",
                                         "N·m", "rad/s", "", "N·m·(s/rad)^(1−δ_v)", "");
  return std::string(units.of(quantity));
}

std::vector<Reading> readings_of(const calibration::Calibration& c) {
  Reader out;
  using enum ReadingName;
  read_masses(c, {A, B, C, D, E, F}, out);
  read_steady_points(c, out);
  read_masses(c, {AB, CD, EF, midline, model}, out);
  if (c.lugre) read_loop_fit(*c.lugre, out);
  out.add(ReadingName::q_peak, ReadingKind::peak_angle, c.q_peak_rad);
  if (c.rough.found)
    out.add(ReadingName::sweep_friction, ReadingKind::sweep_friction, c.rough.coulomb_Nm);
  read_curve(c, out);
  return out.all();
}

const Reading* find_reading(const std::vector<Reading>& readings, ReadingName name) {
  const auto it = std::find_if(readings.begin(), readings.end(),
                               [&](const Reading& r) { return r.name == name; });
  return it == readings.end() ? nullptr : &*it;
}

bool runs_follow_waiboer(const calibration::Calibration& c) {
  return method::viscous::waiboer_of(c.friction.waiboer) &&
         (c.model.law.carries_waiboer() || c.model.law.empty());
}

bool is_single_point(ReadingName name) { return name <= ReadingName::B_steady; }

}  // namespace tribolog::truth
