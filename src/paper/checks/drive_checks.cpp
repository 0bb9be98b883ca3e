// Equations (8) to (11) and (13): what the motor's torque is made of.

#include <algorithm>

#include "base/requirements.h"
#include "joint/degrees.h"
#include "paper/checks/check.h"
#include "paper/drawings/paper_drawings.h"
#include "paper/drawings/printed_paper.h"
#include "wording/tr.h"

namespace tribolog::paper::checks {
namespace {

using wording::tr;
using wording::tr_count;

/// Largest |deviation(run)| over the plateaus of constant speed.
template <class Deviation>
double largest_over_runs(const PapersJoint& joint, Deviation deviation) {
  double largest = 0;
  for (const method::viscous::ConstantSpeedRun& run : joint.calibration.viscous.runs) {
    largest = larger_size(largest, deviation(run));
  }
  return largest;
}

std::int64_t plateaus_of(const PapersJoint& joint) {
  return static_cast<std::int64_t>(joint.calibration.viscous.runs.size());
}

}  // namespace

Checks check_equation_8(const PapersJoint& joint) {
  const simulate::Scenario& s = joint.scenario;
  const double n = s.gear_ratio;
  const joint::Recording& log = joint.recording(joint::Role::oscillation);
  double apart = 0;
  double drawn_apart = 0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const double speed = joint.oscillation_speed_rad_s(log.t_s[i]);
    const double acceleration = joint.oscillation_acceleration_rad_s2(log.t_s[i]);
    const double friction = bristles_of(s).torque_Nm(log.z_rad[i], log.dz_rad_s[i], speed);
    const double arm = s.arm_inertia_kgm2 * acceleration / n + s.load.torque_Nm(log.q_rad[i]);
    const double left = n * (log.torque_Nm[i] - s.motor_inertia_kgm2 * acceleration - friction);
    apart = larger_size(apart, left - arm);
    const drawings::SignalGraph graph =
        drawings::drive_graph({n, s.motor_inertia_kgm2, [friction](double) { return friction; }});
    const double drawn = drawings::evaluate(graph, {{"motor torque", log.torque_Nm[i]},
                                                    {"motor speed", speed},
                                                    {"motor acceleration", acceleration}})
                             .at("arm torque");
    drawn_apart = larger_size(drawn_apart, drawn - arm);
  }
  return {vanishing(
              tr("n (T − J φ̈ − T_f) minus I q̈ + m g r cos(q + q_c), over the oscillation: largest"),
              apart, n * log_rounding_Nm, "N·m", tr(rounding_of_log)),
          vanishing(tr("The same through the block diagram of figure 6"), drawn_apart,
                    n * log_rounding_Nm, "N·m", tr(rounding_of_log))};
}

Checks check_equation_9(const PapersJoint& joint) {
  const joint::GravityLoad& load = joint.scenario.load;
  const robot::JointUnderTest& arm = joint.robot.under_test;
  const double q_c = drawings::precise_angle_deg * joint::rad_per_degree;
  double apart = 0;
  const robot::AngleRange range = present(joint.robot.range);
  for (double q = range.lowest_rad; q <= range.highest_rad; q += joint::rad_per_degree / 4) {
    const double printed =
        load.mass_kg() * load.gravity_m_s2() * load.distance_m() * std::cos(q_c + q);
    apart = larger_size(apart, arm.holding_torque_Nm(q, present(joint.robot.load)) - printed);
  }
  return {vanishing(tr("Equation against lever and weight of the arm in space (figure 12), "
                       "over its range of motion: largest difference"),
                    apart, 1e-9, "N·m", tr("rounding")),
          known_value(tr("Largest torque at the arm, m g r"), 388.318571, 6, load.amplitude_Nm(),
                      1e-5, "N·m", tr("digits of G/n"))};
}

/// The plateaus' means of the cosine are about the angle that was identified, to 10⁻⁶ rad.
constexpr double of_angle_Nm = 2e-8;
constexpr const char* found_angle = wording::to_translate("q_peak is identified to 10⁻⁶ rad");

Checks check_equation_10(const PapersJoint& joint) {
  const simulate::Scenario& s = joint.scenario;
  const std::int64_t plateaus = plateaus_of(joint);
  return {vanishing(tr_count(plateaus,
                             "n (T − T_f) minus m g r cos(q + q_c), over {plateaus} plateau of "
                             "constant speed: largest",
                             "n (T − T_f) minus m g r cos(q + q_c), over {plateaus} plateaus of "
                             "constant speed: largest",
                             {{"plateaus", plateaus}}),
                    largest_over_runs(joint,
                                      [&](const method::viscous::ConstantSpeedRun& run) {
                                        const double friction =
                                            s.sliding->torque_Nm(run.speed_rad_s);
                                        return s.gear_ratio * (run.torque_Nm - friction) -
                                               s.load.amplitude_Nm() * run.mean_cos;
                                      }),
                    s.gear_ratio * of_angle_Nm, "N·m", tr(found_angle))};
}

Checks check_equation_11(const PapersJoint& joint) {
  const simulate::Scenario& s = joint.scenario;
  const std::int64_t plateaus = plateaus_of(joint);
  return {vanishing(tr_count(plateaus,
                             "T − m g r cos(q + q_c) / n minus the analytic T_f, over {plateaus} "
                             "plateau of constant speed: largest",
                             "T − m g r cos(q + q_c) / n minus the analytic T_f, over {plateaus} "
                             "plateaus of constant speed: largest",
                             {{"plateaus", plateaus}}),
                    largest_over_runs(joint,
                                      [&](const method::viscous::ConstantSpeedRun& run) {
                                        const double gravity = joint.true_gravity_Nm();
                                        return run.torque_Nm - gravity * run.mean_cos -
                                               s.sliding->torque_Nm(run.speed_rad_s);
                                      }),
                    of_angle_Nm, "N·m", tr(found_angle))};
}

Checks check_equation_13(const PapersJoint& joint) {
  const simulate::Scenario& s = joint.scenario;
  const method::gravity::CogSweepResult& rough = joint.calibration.rough;
  const double speed = s.gear_ratio * present(s.rough_sweep).speed_rad_s;
  const double expected = s.sliding->torque_Nm(speed) + joint.true_gravity_Nm();
  return {other_way(tr("Largest torque of the rough sweep: T_f + m g r / n"), expected,
                    rough.argmax_torque_Nm, 1e-7, "N·m", tr("the peak lies between two samples")),
          other_way(tr("Its part m g r / n, separated from friction by the two directions"),
                    joint.true_gravity_Nm(), rough.gravity_Nm.value, 1e-5, "N·m",
                    tr("what the program promises"))};
}

}  // namespace tribolog::paper::checks
