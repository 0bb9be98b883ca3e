// Equations (12) and (14): surrogate mass, and the corrected angle.

#include <algorithm>
#include <numbers>

#include "base/present.h"
#include "paper/checks/equation_checks.h"
#include "paper/checks/solved_bristle.h"
#include "paper/drawings/printed_paper.h"
#include "paper/scenes/test_numbers.h"

namespace tribolog::paper {

Checks check_equation_12(const PapersJoint& joint) {
  double apart = 0;
  for (const printed::TorqueRow& row : printed::table_2) {
    apart = std::max(apart, std::abs(printed::mass_of_torque_kg(row.torque_Nm) - row.mass_kg));
  }
  const GravityLoad& load = joint.scenario.load;
  const double truth = load.mass_kg() * load.distance_m() / printed::distance_m;
  const SurrogateMass* midline = joint.calibration.masses.find("midline");
  Checks out{
      vanishing("All six rows of table 2, mass from torque: largest difference from print", apart,
                printed::rounding_kg(), "kg", "rounding of printed torque and mass"),
      reconstructed_value("Surrogate mass of the joint's gravity torque", 79.1679, 4,
                          surrogate_mass_kg(joint.true_gravity_Nm(), joint.scenario.gear_ratio,
                                            printed::distance_m, load.gravity_m_s2(), 1.0),
                          5e-5, "kg", "digits of the method's number"),
      law_value("The same torque at every angle: its m r by that of the arm", 1.0,
                present(scenes::stated_numbers(joint.robot).surrogate_mass_kg).value *
                    printed::distance_m / (load.mass_kg() * load.distance_m()),
                1e-12, "", "rounding")};
  if (midline != nullptr) {
    out.push_back(law_value("Mid-line of the loop, an estimate that friction does not enter", truth,
                            midline->mass_kg.value, 1e-4 * truth, "kg",
                            "what the program promises"));
  }
  return out;
}

Checks check_equation_14(const PapersJoint& joint) {
  const OscillationExperiment& e = present(joint.scenario.oscillation);
  const double t_B = solved_time_of_B_s(joint);
  const double q_3 = e.amplitude_rad * std::sin(2 * std::numbers::pi * e.frequency_Hz * t_B);
  const double q_c = -joint.scenario.load.q_peak_rad();
  const SelectionResult& selection = joint.calibration.selection;
  const double found = selection.q_c_corrected_rad.value_or(std::nan(""));
  return {law_value("q_c,f = q_c − q₃ with q₃ where CVODE's z(t) is zero while the arm drops",
                    q_c - q_3, found, 1e-7, "rad", "q_peak is identified to 10⁻⁷ rad"),
          law_value("The angle q₃ that is taken off", q_3,
                    selection.q_c_rad ? selection.q_c_rad->value - found : std::nan(""), 1e-8,
                    "rad", "read between samples 1 ms apart"),
          in_words("Sign: less than q_c, “less of the value”", Origin::printed, "less",
                   found < q_c ? "less" : "not less")};
}

}  // namespace tribolog::paper
