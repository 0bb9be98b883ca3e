#include "exports/results/archived_joint.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "base/requirements.h"
#include "base/shown_text.h"
#include "calibration/archived_calibration.h"
#include "wording/visible_text.h"

namespace tribolog::exports::results {

const calibration::Quantity* ArchivedJoint::found(joint::Quantity quantity) const {
  const std::string name = to_string(quantity);
  for (const calibration::Quantity& one : quantities) {
    if (one.name == name && one.estimate) return &one;
  }
  return nullptr;
}

bool ArchivedJoint::is_in_amperes() const {
  return calibration::torque_unit_of(quantities) == joint::TorqueUnit::ampere;
}

std::string shortest(double number) {
  std::string text;
  append_number(text, number);
  return text;
}

std::string one_line(const std::string& text) {
  std::string line = wording::visible_text(text);
  std::replace_if(line.begin(), line.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  return line;
}

std::vector<std::string> comment_lines(const ArchivedJoint& joint) {
  const calibration::Facts& f = joint.entry.facts;
  std::vector<std::string> lines;
  const auto add = [&](const char* name, const std::string& text) {
    if (!text.empty()) lines.push_back(one_line(fmt::format("{}: {}", name, text)));
  };
  const auto number = [](const std::optional<double>& value, const char* unit) {
    return value ? fmt::format("{:.6g} {}", *value, unit) : "";
  };
  lines.push_back("Identified by tribolog " + one_line(f.tool_version) +
                  (joint.is_archived ? ", from its archive." : "."));
  add("Robot", f.of.robot);
  add("Serial", f.of.serial);
  add("Joint", f.of.joint);
  add(f.time_is_stated ? "Measured" : "Identified, date of the measurement not stated",
      f.measured_at);
  add("Calibration", joint.entry.id);
  add("Temperature", number(f.temperature_C, "°C"));
  add("Payload", f.payload);
  add("Payload mass", number(f.payload_kg, "kg"));
  add("Verdict", calibration::to_string(f.verdict) + ": " + f.sentence);
  lines.push_back(fmt::format("Gear ratio n = motor angle / joint angle = {:.10g}", f.gear_ratio));
  if (joint.is_in_amperes()) {
    lines.emplace_back(
        "The torque constant was not stated: torques, and all that is made of them, are numbers of "
        "amperes. Times the torque constant they are those of newton metres.");
  }
  const std::string torque =
      unit_of(joint::Quantity::gravity_torque, calibration::torque_unit_of(joint.quantities));
  lines.push_back(
      "Kept are SI units (rad, " + torque +
      ", kg, s) on the motor's side of the gear. At the joint: "
      "torque × n; speed and angle / n; stiffness, damping, viscous coefficient and inertia × n². "
      "The angle of the centre of gravity and the surrogate mass are of the joint.");
  return lines;
}

std::string estimate_line(const calibration::Quantity& quantity, double gear_ratio,
                          joint::Side side) {
  const bool at_motor = side == joint::Side::motor;
  const statistics::Estimate e =
      at_motor ? present(quantity.estimate) : calibration::at_joint(quantity, gear_ratio);
  const int power = at_motor ? 0 : calibration::gear_power(quantity.name).value_or(0);
  return one_line(fmt::format("{} at the {}: {:.6g} {} (95 %: {:.6g} to {:.6g}), {}; {}",
                              calibration::without_side(quantity.words), joint::to_string(side),
                              e.value, quantity.unit, e.low, e.high,
                              calibration::to_string(quantity.verdict),
                              calibration::conversion_words(power)));
}

}  // namespace tribolog::exports::results
