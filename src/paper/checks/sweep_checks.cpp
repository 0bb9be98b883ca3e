// Figures 11, 13 and 14: the sweeps that find the angle of the mass centre.

#include <algorithm>

#include "base/present.h"
#include "joint/degrees.h"
#include "paper/checks/figure_checks.h"
#include "paper/drawings/printed_paper.h"

namespace tribolog::paper {
namespace {}  // namespace

Checks check_sweep_motion(const PapersJoint& joint) {
  const Scenario& s = joint.scenario;
  const Recording& log = joint.recording(Role::rough_sweep);
  const std::vector<bool>& used = joint.calibration.rough.used.at(0);
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
  return {
      law_value("Motor speed of the samples used: n times 2°/s", planned,
                std::abs(fastest - planned) > std::abs(slowest - planned) ? fastest : slowest,
                1e-9 * planned, "rad/s", "the one farthest off"),
      vanishing("“In uniform motion friction takes a constant value”: its change over the sweep",
                most_friction - least_friction, 1e-9, "N·m", "rounding")};
}

Checks check_rough_peak(const PapersJoint& joint) {
  const CogSweepResult& rough = joint.calibration.rough;
  return {
      printed_value("Angle of the largest torque", -printed::rough_angle_deg, 0,
                    rough.argmax_rad * degrees_per_rad, 1, "°", "print gives whole degrees, cut"),
      printed_value("The same against the precise angle", -printed::precise_angle_deg, 5,
                    rough.argmax_rad * degrees_per_rad, 0.001, "°",
                    "half a sample at 2°/s and 1 kHz"),
      printed_value("By least squares over the whole sweep", -printed::precise_angle_deg, 5,
                    rough.q_peak_rad.value * degrees_per_rad, 0.006, "°",
                    "10⁻⁴ rad, what the program promises of a rough sweep")};
}

Checks check_precise_peak(const PapersJoint& joint) {
  const CogSweepResult& precise = joint.calibration.precise;
  return {printed_value("Angle of the largest torque", -printed::precise_angle_deg, 5,
                        precise.argmax_rad * degrees_per_rad, 1e-4, "°",
                        "a sample at 0.1°/s and 1 kHz"),
          printed_value("By least squares", -printed::precise_angle_deg, 5,
                        precise.q_peak_rad.value * degrees_per_rad, 1e-5, "°",
                        "the last printed place"),
          printed_value("q_c = −q_peak", printed::precise_angle_rad, 5, -precise.q_peak_rad.value,
                        1e-5, "rad", "print cuts after five decimals")};
}

}  // namespace tribolog::paper
