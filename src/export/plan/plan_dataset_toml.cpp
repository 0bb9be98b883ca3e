#include "export/plan/plan_dataset_toml.h"

#include <fmt/format.h>

#include "ingest/manifest/toml_text.h"
#include "plan/simulated_plan.h"

namespace tribolog {

std::string plan_dataset_toml(const ExperimentPlan& plan) {
  const JointFacts& f = plan.joint.facts;
  std::string text = fmt::format(
      "# The log that is recorded while the joint follows setpoints.csv: name it {} or correct\n"
      "# the name below. Its clock starts with the set points; where it does not, every from_s "
      "and\n"
      "# to_s shifts by the difference. Columns and units are to be corrected to the log's own.\n"
      "schema = \"tribolog-dataset-1\"\n\n[robot]\nname = {}\n",
      planned_log_name, toml_text(f.robot));
  if (!f.serial.empty()) text += fmt::format("serial = {}\n", toml_text(f.serial));
  text += fmt::format("\n[joint]\nname = {}\ngear_ratio = {}\n", toml_text(f.joint),
                      toml_number(f.gear_ratio));
  text += fmt::format(
      "\n[effort]  # what the log's effort is: correct it if it is not this\n"
      "kind = \"{}\"\nside = \"{}\"\n",
      to_string(f.effort_kind), to_string(f.effort_side));
  if (f.torque_constant_Nm_A) {
    text += fmt::format("torque_constant_Nm_A = {}\n", toml_number(*f.torque_constant_Nm_A));
  }
  const bool is_current = f.effort_kind == EffortKind::motor_current;
  text += fmt::format(
      "\n[columns]\ntime = {{name = \"t_s\", unit = \"s\"}}\n"
      "angle = {{name = \"q_rad\", unit = \"rad\"}}\n"
      "speed = {{name = \"dq_rad_s\", unit = \"rad/s\"}}  # leave out where there is none\n"
      "effort = {{name = \"{}\", unit = \"{}\"}}\n",
      is_current ? "current_A" : "torque_Nm", is_current ? "A" : "Nm");
  for (const PlannedSegment& s : plan.segments) {
    if (!s.role) continue;
    text += fmt::format(
        "\n[[recording]]\nrole = \"{}\"\nfile = {}\nfrom_s = {}\nto_s = {}\n"
        "note = {}\n",
        to_string(*s.role), toml_text(planned_log_name), toml_number(s.from_s), toml_number(s.to_s),
        toml_text(s.name));
  }
  return text;
}

}  // namespace tribolog
