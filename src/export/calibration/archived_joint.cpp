#include "export/calibration/archived_joint.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "base/requirements.h"
#include "calibration/gear_side.h"
#include "wording/visible_text.h"

namespace tribolog::archive {

const Quantity* ArchivedJoint::found(std::string_view name) const {
  for (const Quantity& quantity : quantities) {
    if (quantity.name == name && quantity.estimate) return &quantity;
  }
  return nullptr;
}

std::string one_line(const std::string& text) {
  std::string line = report::visible_text(text);
  std::replace_if(line.begin(), line.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  return line;
}

std::vector<std::string> comment_lines(const ArchivedJoint& joint) {
  const Facts& f = joint.entry.facts;
  std::vector<std::string> lines;
  const auto add = [&](const char* name, const std::string& text) {
    if (!text.empty()) lines.push_back(one_line(fmt::format("{}: {}", name, text)));
  };
  const auto number = [](const std::optional<double>& value, const char* unit) {
    return value ? fmt::format("{:.6g} {}", *value, unit) : "";
  };
  lines.push_back("Identified by tribolog " + one_line(f.tool_version) + ", from its archive.");
  add("Robot", f.of.robot);
  add("Serial", f.of.serial);
  add("Joint", f.of.joint);
  add(f.time_is_stated ? "Measured" : "Identified, date of the measurement not stated",
      f.measured_at);
  add("Calibration", joint.entry.id);
  add("Temperature", number(f.temperature_C, "°C"));
  add("Payload", f.payload);
  add("Payload mass", number(f.payload_kg, "kg"));
  add("Verdict", tribolog::to_string(f.verdict) + ": " + f.sentence);
  lines.push_back(fmt::format("Gear ratio n = motor angle / joint angle = {:.10g}", f.gear_ratio));
  lines.push_back(
      "Archived are SI units (rad, N·m, kg, s) on the motor's side of the gear. At the joint: "
      "torque × n; speed and angle / n; stiffness, damping, viscous coefficient and inertia × n². "
      "The angle of the centre of gravity and the surrogate mass are of the joint.");
  return lines;
}

std::string estimate_line(const Quantity& quantity, double gear_ratio, Side side) {
  const bool at_motor = side == Side::motor;
  const Estimate e = at_motor ? present(quantity.estimate) : at_joint(quantity, gear_ratio);
  const int power = at_motor ? 0 : gear_power(quantity.name).value_or(0);
  return one_line(fmt::format("{} at the {}: {:.6g} {} (95 %: {:.6g} to {:.6g}), {}; {}",
                              without_side(quantity.words), to_string(side), e.value, quantity.unit,
                              e.low, e.high, tribolog::to_string(quantity.verdict),
                              conversion_words(power)));
}

}  // namespace tribolog::archive
