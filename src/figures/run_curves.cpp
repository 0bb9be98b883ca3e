#include "figures/run_curves.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "figures/estimator_style.h"
#include "figures/plot_data.h"
#include "wording/number_text.h"
#include "wording/shaft.h"

namespace tribolog::figures {
namespace {

constexpr double bin_px = 14.0;  // a bin's marker, on which the reference's still leaves a ring
constexpr int reference_points = 200;

std::vector<double> speeds_of(const ViscousCurvesResult& viscous) {
  std::vector<double> speeds;
  for (const ConstantSpeedRun& run : viscous.runs) speeds.push_back(run.speed_rad_s);
  return speeds;
}

/// The two sides of zero speed, as predicates over runs.
bool on_side(double speed, bool positive) { return positive ? speed > 0.0 : speed < 0.0; }

}  // namespace

void add_run_curve(render::Panel& panel, const ViscousCurvesResult& viscous,
                   const std::string& estimator, const std::string& label,
                   const std::vector<double>& values, const AxisScale& scale) {
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
    render::Series series = line(labelled ? "" : label, std::move(x), std::move(y), {});
    apply(estimator_style(estimator), series);
    if (viscous.from_sweep) {
      series.style = render::LineStyle::none;

      series.marker = render::Marker::circle;
      if (estimator != "reference") series.marker_size_px = bin_px;
    }

    labelled = add_visible(panel, std::move(series)) || labelled;
  }
}

void add_reference(render::Panel& panel, const Calibration& calibration, const AxisScale& scale) {
  const auto& analytic = calibration.manifest.reference;
  const std::string label = reference_label(calibration);
  if (calibration.quality.reference != "analytic" || !analytic) {
    add_run_curve(panel, calibration.viscous, "reference", label, calibration.quality.reference_Nm,
                  scale);
    return;
  }
  const Extent speeds = extent_of(speeds_of(calibration.viscous));
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
    render::Series series = line(labelled ? "" : label, std::move(x), std::move(y), {});
    apply(estimator_style("reference"), series);
    labelled = add_visible(panel, std::move(series)) || labelled;
    if (speeds.low > 0.0 || speeds.high < 0.0) break;
  }
}

std::string reference_label(const Calibration& calibration) {
  if (calibration.quality.reference != "direction_difference") {
    return "reference: " + reference_words(calibration.quality.reference);
  }
  const std::string speed = speed_symbol(calibration.manifest);
  return "reference: (T(+" + speed + ") − T(−" + speed + ")) / 2";
}

std::string reference_words(const std::string& reference) {
  if (reference == "analytic") return "analytic curve";
  if (reference == "direction_difference") return "half the difference of the directions";
  return reference.empty() ? "none" : reference;
}

std::string candidate_words(const Calibration& calibration, const std::string& estimator) {
  const SurrogateMass* mass = calibration.masses.find(estimator);
  if (mass == nullptr) return estimator_words(estimator);
  return fmt::format("{} ({})", estimator_words(estimator),
                     rounded(mass->mass_kg, AxisScale{1.0, "kg"}));
}

}  // namespace tribolog::figures
