// Figures 9, 10 and 12: the arm in space.

#include <algorithm>

#include "base/present.h"
#include "joint/degrees.h"
#include "paper/checks/figure_checks.h"
#include "paper/drawings/printed_paper.h"
#include "paper/scenes/test_numbers.h"

namespace tribolog::paper {
namespace {

constexpr double rounding_m = 1e-12;

}  // namespace

Checks check_robot(const PapersJoint& joint) {
  const JointUnderTest& arm = joint.robot.under_test;
  return {in_words("The robot", Origin::printed, "FANUC AM100iB", arm.arm().name()),
          in_words("The joint under test", Origin::printed, "3", arm.joint().name),
          vanishing("Its axis is level, as eq. (9) needs: vertical part of its direction",
                    arm.axis().z(), rounding_m, "", "rounding")};
}

Checks check_mass_model(const PapersJoint& joint) {
  const JointUnderTest& arm = joint.robot.under_test;
  const scenes::TestNumbers drawn = scenes::stated_numbers(joint.robot);
  const Eigen::Vector3d towards = arm.towards_mass(0, present(drawn.q_peak_rad).value);
  const double q_c = std::atan2(towards.z(), towards.dot(arm.level()));
  const scenes::DrivenMass mass = present(drawn.mass);
  return {
      printed_value("q_c, elevation of the mass centre as drawn at q = 0",
                    printed::precise_angle_rad, 5, q_c, 1e-5, "rad",
                    "print cuts after five decimals"),
      law_value("The mass centre's distance as drawn: r", joint.scenario.load.distance_m(),
                mass.distance_m, rounding_m, "m", "rounding"),
      printed_value("The surrogate's distance as drawn: r (printed as 500 m)", printed::distance_m,
                    1, drawn.surrogate_distance_m, rounding_m, "m", "rounding"),
      law_value("Surrogate at its distance against mass at its own: its m r by that of the arm", 1,
                present(drawn.surrogate_mass_kg).value * drawn.surrogate_distance_m /
                    (mass.mass_kg * mass.distance_m),
                rounding_m, "", "rounding")};
}

Checks check_motion_range(const PapersJoint& joint) {
  const JointUnderTest& arm = joint.robot.under_test;
  const scenes::TestNumbers drawn = scenes::stated_numbers(joint.robot);
  const AngleRange range = present(drawn.range);
  const double at = -printed::precise_angle_deg * rad_per_degree;
  const SweepExperiment& sweep = present(joint.scenario.rough_sweep);
  return {law_value("The mass centre is level at −22.23187°: its height over the axis", 0,
                    present(drawn.mass).distance_m *
                        arm.towards_mass(at, present(drawn.q_peak_rad).value).z(),
                    1e-9, "m", "the printed angle's rounding"),
          law_value("The drawn range begins where the rough sweep does",
                    sweep.from_rad * degrees_per_rad, range.lowest_rad * degrees_per_rad, 1e-9, "°",
                    "rounding"),
          law_value("and ends where it ends", sweep.to_rad * degrees_per_rad,
                    range.highest_rad * degrees_per_rad, 1e-9, "°", "rounding"),
          in_words("The gravity peak lies within it", Origin::printed, "within",
                   at > range.lowest_rad && at < range.highest_rad ? "within" : "outside")};
}

}  // namespace tribolog::paper
