#include "truth/truth_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/parallel_for.h"
#include "joint/degrees.h"
#include "statistics/order_statistics.h"
#include "truth/identified_joint.h"

namespace tribolog::truth {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A deviation below this is of no consequence, however narrow the interval.
double what_matters(const Reading& put_in) {
  constexpr double angle_rad = 1e-4;  // costs 5e-9 of the gravity torque
  constexpr double share = 1e-3;
  constexpr double curve_share = 1e-2;  // parameters of a curve, whose errors cancel within it
  switch (put_in.quantity) {
    case ReadingKind::peak_angle:
      return angle_rad;
    case ReadingKind::gravity:
    case ReadingKind::static_torque:
    case ReadingKind::sweep_friction:
      return share * std::abs(put_in.estimate.value);
    default:
      break;
  }
  return curve_share * std::abs(put_in.estimate.value);
}

calibration::ReturnedQuantity returned(const Reading& put_in,
                                       const std::vector<std::vector<Reading>>& runs) {
  calibration::ReturnedQuantity q;
  q.name = put_in.name;
  q.unit = unit_of(put_in.quantity);
  q.put_in = put_in.estimate.value;
  q.came_back = q.scatter = q.half_width = nan;
  std::vector<double> values;
  double widths = 0;
  std::size_t good = 0;
  for (const std::vector<Reading>& readings : runs) {
    const Reading* back = find_reading(readings, put_in.name);
    if (back == nullptr) continue;
    const statistics::Estimate& e = back->estimate;
    const bool inside = e.low <= q.put_in && q.put_in <= e.high;
    const double off = e.value - q.put_in;
    values.push_back(e.value);
    widths += e.half_width();
    q.inside += inside ? 1 : 0;
    good += inside || std::abs(off) <= what_matters(put_in) ? 1 : 0;
    if (e.half_width() > 0) q.in_half_widths.push_back(off / e.half_width());
  }
  q.found = values.size();
  q.comes_back = 2 * q.found >= runs.size() && 2 * good >= q.found && q.found > 0;
  if (values.empty()) return q;
  const auto n = static_cast<double>(values.size());
  q.half_width = widths / n;
  q.came_back = 0;
  for (const double value : values) q.came_back += value / n;
  if (values.size() < 2) return q;
  double squares = 0;
  for (const double value : values) squares += std::pow(value - q.came_back, 2);
  q.scatter = std::sqrt(squares / (n - 1));
  return q;
}

Statement finding_of(const calibration::ReturnedQuantity& q, std::size_t runs) {
  const Statement name(Code::of("reading." + to_string(q.name)));
  if (q.found == 0) {
    return {"truth.not_found", {{"reading", name}, {"runs", runs}}};
  }
  const bool is_angle = q.unit == "rad";
  const double scale = is_angle ? joint::degrees_per_rad : 1;
  return {"truth.does_not_come_back",
          {{"reading", name},
           {"put_in", scale * q.put_in},
           {"unit", is_angle ? "deg" : q.unit},
           {"came_back", scale * q.came_back},
           {"inside", q.inside},
           {"runs", runs}}};
}

double standard_deviation(const std::vector<simulate::Noise::Ripple>& ripple) {
  double variance = 0;
  for (const simulate::Noise::Ripple& one : ripple)
    variance += one.amplitude_Nm * one.amplitude_Nm / 2;
  return std::sqrt(variance);
}

/// What each simulation's identification found.
std::vector<std::vector<Reading>> simulated_readings(const IdentifiedJoint& joint,
                                                     const PlainIdentification& identify,
                                                     const TruthCheckOptions& options) {
  std::vector<std::vector<Reading>> runs(options.runs);
  parallel_for(
      options.runs,
      [&](std::size_t run) {
        runs[run] = readings_of(identify(with_noise(joint, options.seed, run), options.seed + run));
      },
      options.threads);
  return runs;
}

calibration::TruthCheckResult compared(const IdentifiedJoint& joint,
                                       const std::vector<std::vector<Reading>>& runs,
                                       const TruthCheckOptions& options) {
  calibration::TruthCheckResult out;
  out.runs = options.runs;
  out.seed = options.seed;
  out.left_out = joint.left_out;
  out.ripple_Nm = standard_deviation(joint.ripple);
  if (!joint.dataset.recordings.empty()) {
    out.white_Nm = statistics::median(joint.white_Nm);
    out.torque_step_Nm = statistics::median(joint.torque_step_Nm);
  }
  for (const Reading& put_in : joint.put_in) {
    out.quantities.push_back(returned(put_in, runs));
    const calibration::ReturnedQuantity& last = out.quantities.back();
    if (!last.comes_back) out.findings.push_back({last.name, finding_of(last, options.runs)});
  }
  return out;
}

}  // namespace

calibration::TruthCheckResult check_known_truth(const IdentifiedJoint& joint,
                                                const PlainIdentification& identify,
                                                const TruthCheckOptions& options) {
  return compared(joint, simulated_readings(joint, identify, options), options);
}

calibration::TruthCheckResult check_known_truth(const joint::Dataset& dataset,
                                                const calibration::Calibration& calibration,
                                                const PlainIdentification& identify,
                                                const TruthCheckOptions& options) {
  const IdentifiedJoint joint = identified_joint(dataset, calibration);
  return check_known_truth(joint, identify, options);
}

}  // namespace tribolog::truth
