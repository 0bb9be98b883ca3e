#include "figures/run_curves.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/enum_text.h"
#include "base/requirements.h"
#include "figures/estimator_style.h"
#include "figures/report_figure.h"
#include "wording/labels.h"
#include "wording/number_text.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::figures {

namespace {

using method::selection::CurveReference;
using wording::tr;

constexpr int reference_points = 200;

std::vector<double> speeds_of(const method::viscous::ViscousCurvesResult& viscous) {
  std::vector<double> speeds;
  for (const method::viscous::ConstantSpeedRun& run : viscous.runs)
    speeds.push_back(run.speed_rad_s);
  return speeds;
}

/// The two sides of zero speed, as predicates over runs.
bool on_side(double speed, bool positive) { return positive ? speed > 0.0 : speed < 0.0; }

}  // namespace

void add_run_curve(render::figure::Panel& panel,
                   const method::viscous::ViscousCurvesResult& viscous, const SeriesStyle& style,
                   const std::string& label, const std::vector<double>& values,
                   const wording::AxisScale& scale) {
  const std::vector<double> speeds = speeds_of(viscous);
  const std::size_t size = std::min(speeds.size(), values.size());
  bool labelled = false;
  for (const bool positive : {false, true}) {
    std::vector<double> x;
    std::vector<double> y;
    for (std::size_t i = 0; i < size; ++i) {
      if (!on_side(speeds[i], positive) || !std::isfinite(values[i])) continue;
      x.push_back(speeds[i]);
      y.push_back(scale(values[i]));
    }
    render::figure::Series series = line(labelled ? "" : label, std::move(x), std::move(y), {});
    apply(style, series);
    if (viscous.from_sweep) {
      series.style = render::figure::LineStyle::none;
      series.marker = render::figure::Marker::circle;
      series.marker_size_px = style.bin_px;
    }
    labelled = add_visible(panel, std::move(series)) || labelled;
  }
}

void add_reference(render::figure::Panel& panel, const calibration::Calibration& calibration,
                   const wording::AxisScale& scale) {
  const auto& analytic = calibration.manifest.reference;
  const std::string label = reference_label(calibration);
  if (calibration.quality.reference != CurveReference::analytic || !analytic) {
    add_run_curve(panel, calibration.viscous, reference_style, label,
                  calibration.quality.reference_Nm, scale);
    return;
  }
  const wording::Extent speeds = wording::extent_of(speeds_of(calibration.viscous));
  bool labelled = false;
  for (const double end : {speeds.low, speeds.high}) {
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i <= reference_points && end != 0.0; ++i) {
      // Dense near standstill, where the curve bends; first at a thousandth of the end.
      const double share = std::pow(1e-3, 1.0 - static_cast<double>(i) / reference_points);
      x.push_back(end * share);
      y.push_back(scale(analytic->torque_Nm(end * share)));
    }
    render::figure::Series series = line(labelled ? "" : label, std::move(x), std::move(y), {});
    apply(reference_style, series);
    labelled = add_visible(panel, std::move(series)) || labelled;
    if (speeds.low > 0.0 || speeds.high < 0.0) break;
  }
}

std::string reference_label(const calibration::Calibration& calibration) {
  if (calibration.quality.reference != CurveReference::direction_difference) {
    return tr("reference: {reference}",
              {{"reference", reference_words(calibration.quality.reference)}});
  }
  return tr("reference: (T(+{speed}) − T(−{speed})) / 2",
            {{"speed", wording::speed_symbol(calibration.manifest)}});
}

std::string reference_words(CurveReference reference) {
  return wording::words_for("curve_reference", own_name(reference));
}

std::string candidate_words(const calibration::Calibration& calibration,
                            method::hysteresis::Estimator estimator) {
  const method::hysteresis::SurrogateMass* mass = calibration.masses.find(estimator);
  if (mass == nullptr) return estimator_words(estimator);
  if (mass->mass_kg.value == 0.0) return tr("no gravity");
  return fmt::format("{} ({})", estimator_words(estimator),
                     wording::rounded(mass->mass_kg, wording::AxisScale{1.0, "kg"}));
}

namespace {

constexpr double marker_share = 0.012;  // half a marker, of the axis: shorter bars hide in it
constexpr double under_px = 6.0;  // the reference lies under the fitted laws and shows beside them
constexpr int line_points = 60;   // a straight law is bent on a logarithmic axis

/// A curve folded: size over size of speed, one direction.
render::figure::Series folded(const method::viscous::ViscousCurvesResult& viscous,
                              const std::vector<double>& friction_Nm, bool forward,
                              const wording::AxisScale& scale) {
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = 0; i < std::min(viscous.runs.size(), friction_Nm.size()); ++i) {
    const double speed = viscous.runs[i].speed_rad_s;
    if ((speed > 0.0) != forward || speed == 0.0 || !std::isfinite(friction_Nm[i])) continue;
    // Signed along the motion: friction of the wrong sign shows as negative.
    x.push_back(std::abs(speed));
    y.push_back(scale(friction_Nm[i] * (forward ? 1.0 : -1.0)));
  }
  return line("", std::move(x), std::move(y), {});
}

/// The two directions, strong for the recommended candidate.
render::figure::Colour colour_of(bool forward, bool recommended) {
  if (recommended) return forward ? rising_colour : falling_colour;
  return forward ? render::figure::palette::sky_blue : render::figure::palette::orange;
}

}  // namespace

void add_folded_curve(render::figure::Panel& panel, const calibration::Calibration& calibration,
                      std::optional<method::hysteresis::Estimator> estimator,
                      const wording::AxisScale& scale, bool recommended) {
  const method::viscous::ViscousCurve* curve = calibration.viscous.find(estimator);
  if (curve == nullptr) return;
  const std::string who = candidate_words(calibration, curve->estimator);
  for (const bool forward : {true, false}) {
    render::figure::Series series = folded(calibration.viscous, curve->friction_Nm, forward, scale);
    series.label = forward ? tr("{candidate}, forward", {{"candidate", who}})
                           : tr("{candidate}, backward", {{"candidate", who}});
    series.colour = colour_of(forward, recommended);
    series.style = render::figure::LineStyle::none;
    // Small on large: where the directions agree, both are seen.
    if (recommended) {
      series.marker = forward ? render::figure::Marker::circle : render::figure::Marker::diamond;
      series.marker_size_px = forward ? 23.0 : 10.0;
    } else {
      series.marker = forward ? render::figure::Marker::plus : render::figure::Marker::cross;
      series.marker_size_px = 12.0;
    }
    add_visible(panel, std::move(series));
  }
  if (!recommended) return;
  wording::Extent sizes;
  for (const double friction : curve->friction_Nm) sizes.add(std::abs(friction));
  const double span = sizes.span();
  for (std::size_t i = 0; i < std::min(calibration.viscous.runs.size(), curve->friction_Nm.size());
       ++i) {
    const method::viscous::ConstantSpeedRun& run = calibration.viscous.runs[i];
    const double size = curve->friction_Nm[i] * (run.speed_rad_s > 0.0 ? 1.0 : -1.0);
    const double half = run.torque_half_width_Nm;
    if (!std::isfinite(size) || !(half > marker_share * span) || !std::isfinite(half)) continue;
    panel.error_bars.push_back({std::abs(run.speed_rad_s), scale(size - half), scale(size + half),
                                colour_of(run.speed_rad_s > 0.0, true)});
  }
}

void add_folded_reference(render::figure::Panel& panel, const calibration::Calibration& calibration,
                          const wording::Extent& speeds, const wording::AxisScale& scale) {
  const auto& analytic = calibration.manifest.reference;
  render::figure::Series series;
  if (calibration.quality.reference == CurveReference::analytic && analytic && speeds.low > 0.0) {
    for (int i = 0; i <= line_points; ++i) {
      const double share = static_cast<double>(i) / line_points;
      const double speed = speeds.low * std::pow(speeds.high / speeds.low, share);
      series.x.push_back(speed);
      series.y.push_back(scale(analytic->torque_Nm(speed)));
    }
  } else {
    series = folded(calibration.viscous, calibration.quality.reference_Nm, true, scale);
  }
  apply(reference_style, series);
  series.width_px = under_px;
  if (calibration.viscous.from_sweep) {
    series.style = render::figure::LineStyle::none;
    series.marker = render::figure::Marker::plus;
    series.marker_size_px = 10.0;
  }
  series.label = reference_label(calibration);
  add_visible(panel, std::move(series));
}

void add_fitted_laws(render::figure::Panel& panel, const calibration::Calibration& calibration,
                     const wording::AxisScale& scale) {
  const method::model::ModelLaw& law = calibration.model.law;
  if (law.empty()) return;
  const std::vector<double> speeds = law.speeds_rad_s(line_points);
  if (const auto waiboer = method::viscous::waiboer_of(calibration.friction.waiboer)) {
    std::vector<double> torques;
    for (const double speed : speeds) torques.push_back(waiboer->magnitude_Nm(speed));
    add_visible(panel, line(tr("Waiboer's law, fitted"), speeds, shown(torques, scale),
                            render::figure::palette::purple, 3.0, render::figure::LineStyle::dash));
  }
  add_visible(panel, line(tr("model: {law}", {{"law", described(law)}}), speeds,
                          shown(law.friction_Nm(speeds), scale), render::figure::palette::green,
                          3.0, render::figure::LineStyle::dash_dot));
}

std::vector<double> left_by_law(const calibration::Calibration& calibration,
                                const method::viscous::ViscousCurve& curve) {
  const std::vector<method::viscous::ConstantSpeedRun>& runs = calibration.viscous.runs;
  std::vector<double> left_Nm = curve.friction_Nm;
  for (std::size_t i = 0; i < std::min(left_Nm.size(), runs.size()); ++i) {
    const double speed = runs[i].speed_rad_s;
    left_Nm[i] -= std::copysign(calibration.model.law.friction_Nm(std::abs(speed)), speed);
  }
  return left_Nm;
}

void add_residuals(render::figure::Panel& panel, const calibration::Calibration& calibration,
                   const std::vector<double>& left_Nm, const wording::AxisScale& scale) {
  for (const bool forward : {true, false}) {
    render::figure::Series series = folded(calibration.viscous, left_Nm, forward, scale);
    series.label = forward ? tr("forward") : tr("backward");
    series.colour = colour_of(forward, true);
    series.style = render::figure::LineStyle::none;
    series.marker = forward ? render::figure::Marker::circle : render::figure::Marker::diamond;
    series.marker_size_px = forward ? 20.0 : 9.0;
    add_visible(panel, std::move(series));
  }
}

}  // namespace tribolog::figures
