// Figures 11, 13 and 14: the sweeps that find the angle of the mass centre.

#include <algorithm>

#include "base/requirements.h"
#include "joint/degrees.h"
#include "paper/checks/check.h"
#include "paper/checks/loop_torques.h"
#include "paper/drawings/printed_paper.h"
#include "paper/scenes/scene_words.h"
#include "wording/tr.h"

namespace tribolog::paper::checks {

namespace {

using method::hysteresis::Estimator;
using wording::tr;

}  // namespace

Checks check_sweep_motion(const PapersJoint& joint) {
  const simulate::Scenario& s = joint.scenario;
  const joint::Recording& log = joint.recording(joint::Role::rough_sweep);
  const std::vector<bool>& used = joint.calibration.curves.rough.used.at(0);
  double slowest = INFINITY;
  double fastest = 0;
  double least_friction = INFINITY;
  double most_friction = 0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (!used[i]) continue;
    const double speed = std::abs(s.gear_ratio * log.dq_rad_s[i]);
    slowest = std::min(slowest, speed);
    fastest = std::max(fastest, speed);
    const double friction =
        std::abs(log.torque_Nm[i] - s.load.torque_Nm(log.q_rad[i]) / s.gear_ratio);
    least_friction = std::min(least_friction, friction);
    most_friction = std::max(most_friction, friction);
  }
  const double planned = s.gear_ratio * present(s.rough_sweep).speed_rad_s;
  return {other_way(tr("Motor speed of the samples used: n times 2°/s"), planned,
                    std::abs(fastest - planned) > std::abs(slowest - planned) ? fastest : slowest,
                    1e-9 * planned, "rad/s", tr("the one farthest off")),
          printed_value(
              tr("“In uniform motion friction takes a constant value”: its change over the sweep"),
              0, 3, most_friction - least_friction, drawings::last_place / 2, "N·m",
              tr("half of the last place of the printed torques"))};
}

Checks check_rough_peak(const PapersJoint& joint) {
  const method::gravity::CogSweepResult& rough = joint.calibration.rough;
  const double found_deg = rough.argmax_rad * joint::degrees_per_rad;
  const double truth_deg = joint.scenario.load.q_peak_rad() * joint::degrees_per_rad;
  return {printed_value(tr("Angle of the largest torque"), -drawings::rough_angle_deg, 0, found_deg,
                        1, "°", tr("print gives whole degrees, cut")),
          printed_value(tr("The same as q_c"), drawings::rough_angle_rad, 3, -rough.argmax_rad,
                        joint::rad_per_degree, "rad", tr("one degree, as above")),
          other_way(tr("Angle of the largest torque against that of the simulated load"), truth_deg,
                    found_deg, 0.001, "°", tr("half a sample at 2°/s and 1 kHz")),
          other_way(tr("By least squares over the whole sweep against the same"), truth_deg,
                    rough.q_peak_rad.value * joint::degrees_per_rad, 0.006, "°",
                    tr("10⁻⁴ rad, what the program promises of a rough sweep"))};
}

Checks check_precise_peak(const PapersJoint& joint) {
  const method::gravity::CogSweepResult& precise = joint.calibration.precise;
  return {printed_value(tr("Angle of the largest torque"), -drawings::precise_angle_deg, 5,
                        precise.argmax_rad * joint::degrees_per_rad, 1e-4, "°",
                        tr("a sample at 0.1°/s and 1 kHz")),
          printed_value(tr("The same as q_c"), drawings::precise_angle_rad, 5, -precise.argmax_rad,
                        1e-5, "rad", tr("print cuts after five decimals")),
          other_way(tr("By least squares against the angle of the simulated load"),
                    joint.scenario.load.q_peak_rad() * joint::degrees_per_rad,
                    precise.q_peak_rad.value * joint::degrees_per_rad, 1e-5, "°",
                    tr("10⁻⁷ rad, what the program promises of a precise sweep"))};
}

// Figures 15 to 17: hysteresis of torque, deflection and its rate.

namespace {

const method::hysteresis::LoopTrace& trace_of(const PapersJoint& joint) {
  return joint.calibration.curves.loops.at(0);
}

/// Part of the first turn, as shares of its period.
struct Window {
  double from;
  double to;
};

/// A point against the largest or smallest sample of that part of the first turn.
Check is_extreme(const PapersJoint& joint, const std::vector<double>& signal, Window window,
                 bool is_largest, double read, std::string what, const char* unit) {
  const double period_s = 1 / joint.calibration.hysteresis.oscillations.at(0).frequency_Hz;
  const std::vector<double>& t = trace_of(joint).t_s;
  double extreme = is_largest ? -INFINITY : INFINITY;
  for (std::size_t i = 0; i < signal.size(); ++i) {
    if (t[i] < window.from * period_s || t[i] > window.to * period_s) continue;
    extreme = is_largest ? std::max(extreme, signal[i]) : std::min(extreme, signal[i]);
  }
  constexpr double share = 1e-4;
  return other_way(std::move(what), extreme, read, share * std::abs(extreme), unit,
                   tr("the extreme may lie between two samples"));
}

}  // namespace

Checks check_torque_loop(const PapersJoint& joint) {
  Checks out = check_loop_torques(joint);
  const auto mean_of = [&](Estimator one, Estimator other) {
    const auto& steady = joint.calibration.hysteresis.steady_points;
    double sum = 0;
    for (const method::hysteresis::LoopPoint& p : steady)
      sum += p.name == one || p.name == other ? p.torque_Nm / 2 : 0;
    return sum;
  };
  const double truth = joint.true_gravity_Nm();
  for (const Estimator pair : method::hysteresis::pair_means) {
    const auto [first, second] = present(points_of_pair(pair));
    out.push_back(other_way(tr("Steady loop, mean of {first} and {second}: gravity alone",
                               {{"first", to_string(first)}, {"second", to_string(second)}}),
                            truth, mean_of(first, second), 1e-4 * truth, "N·m",
                            tr("what the program promises")));
  }
  return out;
}

Checks check_deflection_loop(const PapersJoint& joint) {
  const method::hysteresis::LoopTrace& trace = trace_of(joint);
  return {is_extreme(joint, trace.z_rad, {0, 0.5}, true, joint.point(Estimator::C).z_rad,
                     tr("{point}: largest z", {{"point", "C"}}), "rad"),
          is_extreme(joint, trace.z_rad, {0.5, 1}, false, joint.point(Estimator::D).z_rad,
                     tr("{point}: smallest z", {{"point", "D"}}), "rad"),
          by_name(tr("Sign of dz/dt at A and B"), Kind::independent, "+ −",
                  std::string(joint.point(Estimator::A).dz_rad_s > 0 ? "+" : "−") + " " +
                      (joint.point(Estimator::B).dz_rad_s > 0 ? "+" : "−"))};
}

Checks check_rate_loop(const PapersJoint& joint) {
  const method::hysteresis::LoopTrace& trace = trace_of(joint);
  return {
      is_extreme(joint, trace.dz_rad_s, {0.25, 0.75}, false, joint.point(Estimator::F).dz_rad_s,
                 tr("{point}: smallest dz/dt", {{"point", "F"}}), "rad/s"),
      is_extreme(joint, trace.dz_rad_s, {0.75, 1.25}, true, joint.point(Estimator::E).dz_rad_s,
                 tr("{point}: largest dz/dt after the first quarter", {{"point", "E"}}), "rad/s"),
      by_name(tr("E: sign of z, while dz/dt is largest"), Kind::independent, "−",
              joint.point(Estimator::E).z_rad < 0 ? "−" : "+"),
      by_name(tr("F: sign of z, while dz/dt is smallest"), Kind::independent, "+",
              joint.point(Estimator::F).z_rad < 0 ? "−" : "+")};
}

// Figures 9, 10 and 12: the arm in space.

namespace {

constexpr double rounding_m = 1e-12;

}  // namespace

Checks check_robot(const PapersJoint& joint) {
  const robot::JointUnderTest& arm = joint.robot.under_test;
  return {vanishing(tr("Its axis is level, as eq. (9) needs: vertical part of its direction"),
                    arm.axis().z(), rounding_m, "", tr("rounding"))};
}

Checks check_mass_model(const PapersJoint& joint) {
  const robot::JointUnderTest& arm = joint.robot.under_test;
  const scenes::TestNumbers drawn = scenes::stated_numbers(joint.robot);
  const Eigen::Vector3d towards = arm.towards_mass(0, present(drawn.q_peak_rad).value);
  const double q_c = std::atan2(towards.z(), towards.dot(arm.level()));
  const scenes::DrivenMass mass = present(drawn.mass);
  return {other_way(tr("q_c, elevation of the mass centre as drawn at q = 0"),
                    -joint.scenario.load.q_peak_rad(), q_c, 1e-9, "rad", tr("rounding")),
          other_way(tr("The mass centre's distance as drawn: r"), joint.scenario.load.distance_m(),
                    mass.distance_m, rounding_m, "m", tr("rounding")),
          other_way(tr("The surrogate's distance as drawn: r (printed as 500 m)"),
                    joint.scenario.surrogate_distance_m, drawn.surrogate_distance_m, rounding_m,
                    "m", tr("rounding")),
          other_way(tr("Surrogate at its distance against mass at its own: its m r relative to "
                       "that of the arm"),
                    1,
                    present(drawn.surrogate_mass_kg).value * drawn.surrogate_distance_m /
                        (mass.mass_kg * mass.distance_m),
                    rounding_m, "", tr("rounding"))};
}

Checks check_motion_range(const PapersJoint& joint) {
  const robot::JointUnderTest& arm = joint.robot.under_test;
  const scenes::TestNumbers drawn = scenes::stated_numbers(joint.robot);
  const robot::AngleRange range = present(drawn.range);
  const double at = -drawings::precise_angle_deg * joint::rad_per_degree;
  const simulate::SweepExperiment& sweep = present(joint.scenario.rough_sweep);
  return {other_way(tr("The mass centre is level at −22.23187°: its height over the axis"), 0,
                    present(drawn.mass).distance_m *
                        arm.towards_mass(at, present(drawn.q_peak_rad).value).z(),
                    1e-9, "m", tr("the printed angle's rounding")),
          other_way(tr("The drawn range begins where the rough sweep does"),
                    sweep.from_rad * joint::degrees_per_rad,
                    range.lowest_rad * joint::degrees_per_rad, 1e-9, "°", tr("rounding")),
          other_way(tr("and ends where it ends"), sweep.to_rad * joint::degrees_per_rad,
                    range.highest_rad * joint::degrees_per_rad, 1e-9, "°", tr("rounding")),
          in_words(tr("The gravity peak lies within it"), Kind::independent,
                   at > range.lowest_rad && at < range.highest_rad, tr("within"), tr("outside"))};
}

}  // namespace tribolog::paper::checks
