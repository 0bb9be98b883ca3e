#include "paper/checks/conclusion_checks.h"

#include <algorithm>

namespace tribolog::paper {

Checks check_conclusions(const PapersJoint& joint) {
  const LoopPoint& chosen = joint.point('B');
  const LoopTrace& trace = joint.calibration.hysteresis.traces.at(0);
  const double largest_z = *std::max_element(trace.z_rad.begin(), trace.z_rad.end());
  const double truth = joint.true_mass_kg();
  const auto share_off = [&](const char* estimator) {
    const SurrogateMass* mass = joint.calibration.masses.find(estimator);
    return mass != nullptr ? 100 * (mass->mass_kg.value / truth - 1) : NAN;
  };
  return {
      in_words("The torque should be measured “while dropping the robot arms down”: the arm at B",
               Origin::printed, "drops",
               joint.oscillation_speed_rad_s(chosen.t_s) < 0 ? "drops" : "rises"),
      vanishing(
          "“The value of asperities z(t) equals to the zero” there: z as a share of its largest",
          chosen.z_rad / largest_z, 2e-5, "", "read on a straight line between samples"),
      law_value("What is left of friction in B: error of its mass", 0, share_off("B"), 1, "%",
                "a single point keeps σ₁ dz/dt + σ₂ ω and the instant it is read at"),
      law_value("No a priori knowledge is needed, and no z(t): error of the mid-line's mass", 0,
                share_off("midline"), 0.01, "%", "what the program promises")};
}

}  // namespace tribolog::paper
