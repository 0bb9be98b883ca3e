#include "paper/checks/table_checks.h"

#include "friction/catalogue.h"
#include "paper/drawings/printed_paper.h"

namespace tribolog::paper {
Checks check_table_1() {
  const ContactParameters ours;
  const double values[] = {ours.stiffness_Nm_rad, ours.damping_Nms_rad, ours.viscous_Nms_rad,
                           ours.static_Nm,        ours.coulomb_Nm,      ours.stribeck_speed_rad_s};
  Checks out;
  std::size_t i = 0;
  for (const printed::ContactRow& row : printed::table_1) {
    const bool is_misprint = row.printed != row.meant;
    Check check = is_misprint
                      ? law_value(std::string(row.symbol) + ", as the cited source has it",
                                  row.meant, values[i], 1e-12 * row.meant, row.unit,
                                  "rounding; the printed value is a misprint, see the errata")
                      : printed_value(row.symbol, row.meant, row.meant < 0.01 ? 3 : 1, values[i], 0,
                                      row.unit, "");
    out.push_back(check);
    ++i;
  }
  return out;
}

Checks check_table_2(const PapersJoint& joint) {
  Checks out;
  constexpr int places = 3;
  for (const printed::TorqueRow& row : printed::table_2) {
    out.push_back(printed_value(std::string("T at ") + row.point + ", simulated joint",
                                row.torque_Nm, places, joint.point(row.point).torque_Nm,
                                reconstruction_share * row.torque_Nm, "N·m", reconstruction));
  }
  for (const printed::TorqueRow& row : printed::table_2) {
    out.push_back(printed_value(std::string("Mass ") + row.point + " from the printed torque",
                                row.mass_kg, places, printed::mass_of_torque_kg(row.torque_Nm),
                                printed::rounding_kg(), "kg",
                                "rounding of printed torque and mass"));
  }
  for (const printed::TorqueRow& row : printed::table_2) {
    const SurrogateMass* ours = joint.calibration.masses.find(std::string(1, row.point));
    out.push_back(printed_value(std::string("Mass ") + row.point + ", simulated joint", row.mass_kg,
                                places, ours != nullptr ? ours->mass_kg.value : std::nan(""),
                                reconstruction_share * row.mass_kg, "kg", reconstruction));
  }
  return out;
}

}  // namespace tribolog::paper
