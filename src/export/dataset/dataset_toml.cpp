#include "export/dataset/dataset_toml.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "ingest/manifest/toml_text.h"

namespace tribolog {
namespace {

std::string toml_value(double value) { return toml_number(value); }

std::string toml_value(std::uint64_t value) { return fmt::format("{}", value); }

std::string toml_value(const std::vector<MaxwellElement>& elements) {
  std::string text = "[";
  for (const MaxwellElement& one : elements) {
    text += fmt::format("\n  {{stiffness_Nm_rad = {}, share = {}}},",
                        toml_number(one.stiffness_Nm_rad), toml_number(one.share));
  }
  return text += "\n]";
}

std::string reference(const StaticFriction* friction) {
  if (friction == nullptr) {
    return "\n# No known curve: the simulated friction depends on the rest before the motion "
           "too.\n";
  }
  std::string text = "\n# The friction that was simulated: sweeps and runs at constant speed.\n";
  text += fmt::format("[reference.{}]\n", friction->name());
  for (const NamedParameter& one : friction->named_parameters()) {
    const auto value = [](const auto& known) { return toml_value(known); };
    text += fmt::format("{} = {}\n", one.key, std::visit(value, one.value));
  }
  return text;
}

constexpr const char* speed_column = R"(speed = {name = "dq_rad_s", unit = "rad/s"})";

/// Columns that not every recording has.
std::string own_columns(const Recording& recording, bool speed_is_common) {
  std::string columns;
  const auto add = [&](bool is_there, const char* column) {
    if (!is_there) return;
    if (!columns.empty()) columns += ", ";
    columns += column;
  };
  add(!recording.dq_rad_s.empty() && !speed_is_common, speed_column);
  add(!recording.z_rad.empty(), R"(bristle = {name = "z_rad", unit = "rad"})");
  add(!recording.dz_rad_s.empty(), R"(bristle_rate = {name = "dz_rad_s", unit = "rad/s"})");
  return columns;
}

}  // namespace

std::string description_beside(const Scenario& scenario) {
  return std::filesystem::path(scenario.robot_description).filename().string();
}

std::string dataset_toml(const Scenario& scenario, const std::vector<Recording>& recordings) {
  std::string text = "schema = \"tribolog-dataset-1\"\n\n[robot]\n";
  text += fmt::format("name = {}\n", toml_text(scenario.robot));
  if (!scenario.serial.empty()) text += fmt::format("serial = {}\n", toml_text(scenario.serial));
  if (!scenario.robot_description.empty()) {
    text += fmt::format("description = {}\n", toml_text(description_beside(scenario)));
  }
  text += fmt::format("note = {}\n", toml_text("simulated: " + scenario.name));
  text += fmt::format("\n[joint]\nname = {}\ngear_ratio = {}\n", toml_text(scenario.joint),
                      toml_number(scenario.gear_ratio));
  const bool is_current = scenario.log.torque_constant_Nm_A > 0;
  text += fmt::format("\n[effort]\nkind = \"{}\"\nside = \"motor\"\n",
                      is_current ? "motor_current" : "motor_torque");
  if (is_current) {
    text +=
        fmt::format("torque_constant_Nm_A = {}\n", toml_number(scenario.log.torque_constant_Nm_A));
  }
  text += fmt::format("\n[surrogate]\ndistance_m = {}\ngravity_m_s2 = {}\n",
                      toml_number(scenario.surrogate_distance_m),
                      toml_number(scenario.load.gravity_m_s2()));
  text +=
      "\n[columns]\n"
      "time = {name = \"t_s\", unit = \"s\"}\n"
      "angle = {name = \"q_rad\", unit = \"rad\", side = \"joint\"}\n"
      "effort = ";
  text +=
      is_current ? "{name = \"i_A\", unit = \"A\"}\n" : "{name = \"torque_Nm\", unit = \"Nm\"}\n";
  const bool speed_is_common =
      std::all_of(recordings.begin(), recordings.end(),
                  [](const Recording& recording) { return !recording.dq_rad_s.empty(); });
  if (speed_is_common) text += fmt::format("{}\n", speed_column);
  text += reference(scenario.known_curve().get());
  for (const Recording& recording : recordings) {
    text += fmt::format("\n[[recording]]\nrole = \"{}\"\nfile = {}\n", to_string(recording.role),
                        toml_text(recording.name));
    const std::string columns = own_columns(recording, speed_is_common);
    if (!columns.empty()) text += fmt::format("columns = {{{}}}\n", columns);
  }
  return text;
}

}  // namespace tribolog
