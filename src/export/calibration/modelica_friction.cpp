#include "export/calibration/modelica_friction.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/present.h"
#include "calibration/gear_side.h"
#include "export/calibration/comment_lines.h"
#include "export/calibration/friction_table.h"
#include "export/calibration/simulator_number.h"
#include "export/calibration/xml_text.h"

namespace tribolog::archive {

std::string modelica_friction(const ArchivedJoint& joint, const SimulatorOptions& options) {
  const Facts& f = joint.entry.facts;
  const bool at_motor = options.side == Side::motor;
  refuse_doubtful(joint, "viscous_curve", options.doubtful_too);
  FrictionTable table = friction_table(joint);
  if (table.rows.empty()) {
    throw UsageError(joint.entry.id.substr(0, shown_digits) + ": not exported: " + table.source);
  }
  if (!at_motor) table = at_joint(table, f.gear_ratio);
  const std::string source = table.source;

  std::vector<std::string> lines = comment_lines(joint);
  lines.push_back(fmt::format("tau_pos: friction [N·m] against speed [rad/s] at the {}{}. From {}.",
                              to_string(options.side),
                              at_motor ? ", as archived" : ": archived torques × n, speeds / n",
                              source));
  for (const char* const name : {"coulomb_torque", "viscous_coefficient"}) {
    const Quantity* const quantity = joint.found(name);
    if (quantity != nullptr) lines.push_back(estimate_line(*quantity, f.gear_ratio, options.side));
  }
  double peak = 1;
  std::string why_not;
  const Quantity* const break_away =
      if_usable(joint, "break_away_torque", options.doubtful_too, why_not);
  if (break_away != nullptr) {
    const double static_Nm =
        at_motor ? present(break_away->estimate).value : at_joint(*break_away, f.gear_ratio).value;
    peak = std::max(peak, static_Nm / table.rows.front().friction_Nm);
    lines.push_back("peak: break-away torque by the torque of the first row, at least 1. " +
                    estimate_line(*break_away, f.gear_ratio, options.side));
  } else {
    lines.push_back("peak is 1: " + why_not);
  }

  std::string text;
  for (const std::string& line : lines) text += "// " + one_line(line) + "\n";
  text += fmt::format(
      "model JointFriction \"Friction of a joint as identified, at the {}\"\n"
      "  extends Modelica.Mechanics.Rotational.Components.BearingFriction(\n"
      "    peak = {},\n"
      "    tau_pos = [\n",
      to_string(options.side), shortest(peak));
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    text += "      " + shortest(table.rows[k].speed_rad_s) + ", " +
            shortest(table.rows[k].friction_Nm) + (k + 1 < table.rows.size() ? ";\n" : "]);\n");
  }
  return text + "end JointFriction;\n";
}

}  // namespace tribolog::archive
