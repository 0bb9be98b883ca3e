// Figures 15 to 17: hysteresis of torque, deflection and its rate.

#include <algorithm>

#include "paper/checks/figure_checks.h"
#include "paper/drawings/printed_paper.h"

namespace tribolog::paper {
namespace {

const LoopTrace& trace_of(const PapersJoint& joint) {
  return joint.calibration.hysteresis.traces.at(0);
}

/// Part of the first turn, as shares of its period.
struct Window {
  double from;
  double to;
};

/// A point against the largest or smallest sample of that part of the first turn.
Check is_extreme(const PapersJoint& joint, char name, const std::vector<double>& signal,
                 Window window, bool is_largest, double read, const char* what, const char* unit) {
  const double period_s = 1 / joint.calibration.hysteresis.oscillations.at(0).frequency_Hz;
  const std::vector<double>& t = trace_of(joint).t_s;
  double extreme = is_largest ? -INFINITY : INFINITY;
  for (std::size_t i = 0; i < signal.size(); ++i) {
    if (t[i] < window.from * period_s || t[i] > window.to * period_s) continue;
    extreme = is_largest ? std::max(extreme, signal[i]) : std::min(extreme, signal[i]);
  }
  constexpr double share = 1e-4;
  return law_value(std::string(1, name) + ": " + what, extreme, read, share * std::abs(extreme),
                   unit, "the extreme may lie between two samples");
}

}  // namespace

Checks check_torque_loop(const PapersJoint& joint) {
  Checks out;
  for (const printed::TorqueRow& row : printed::table_2) {
    out.push_back(printed_value(std::string("Torque at ") + row.point, row.torque_Nm, 3,
                                joint.point(row.point).torque_Nm,
                                reconstruction_share * row.torque_Nm, "N·m", reconstruction));
  }
  const auto mean_of = [&](char one, char other) {
    const auto& steady = joint.calibration.hysteresis.steady_points;
    double sum = 0;
    for (const LoopPoint& p : steady) sum += p.name == one || p.name == other ? p.torque_Nm / 2 : 0;
    return sum;
  };
  const double truth = joint.true_gravity_Nm();
  for (const char* pair : {"AB", "CD", "EF"}) {
    out.push_back(law_value(
        std::string("Steady loop, mean of ") + pair[0] + " and " + pair[1] + ": gravity alone",
        truth, mean_of(pair[0], pair[1]), 1e-4 * truth, "N·m", "what the program promises"));
  }
  return out;
}

Checks check_deflection_loop(const PapersJoint& joint) {
  const LoopTrace& trace = trace_of(joint);
  const double largest = *std::max_element(trace.z_rad.begin(), trace.z_rad.end());
  /// On a straight line between samples 1 ms apart.
  const double zero = 2e-5 * largest;
  const char* between = "read on a straight line between samples";
  return {vanishing("A: z = 0 while the arm rises", joint.point('A').z_rad, zero, "rad", between),
          vanishing("B: z = 0 while the arm drops", joint.point('B').z_rad, zero, "rad", between),
          is_extreme(joint, 'C', trace.z_rad, {0, 0.5}, true, joint.point('C').z_rad, "largest z",
                     "rad"),
          is_extreme(joint, 'D', trace.z_rad, {0.5, 1}, false, joint.point('D').z_rad, "smallest z",
                     "rad"),
          in_words("Sign of dz/dt at A and B", Origin::law, "+ −",
                   std::string(joint.point('A').dz_rad_s > 0 ? "+" : "−") + " " +
                       (joint.point('B').dz_rad_s > 0 ? "+" : "−"))};
}

Checks check_rate_loop(const PapersJoint& joint) {
  const LoopTrace& trace = trace_of(joint);
  return {is_extreme(joint, 'F', trace.dz_rad_s, {0.25, 0.75}, false, joint.point('F').dz_rad_s,
                     "smallest dz/dt", "rad/s"),
          is_extreme(joint, 'E', trace.dz_rad_s, {0.75, 1.25}, true, joint.point('E').dz_rad_s,
                     "largest dz/dt after the first quarter", "rad/s"),
          in_words("E: sign of z, while dz/dt is largest", Origin::law, "−",
                   joint.point('E').z_rad < 0 ? "−" : "+"),
          in_words("F: sign of z, while dz/dt is smallest", Origin::law, "+",
                   joint.point('F').z_rad < 0 ? "−" : "+")};
}

}  // namespace tribolog::paper
