#include "ingest/manifest/voltage.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/closest_match.h"

namespace tribolog {
namespace {

constexpr std::array<std::string_view, 8> kinds = {
    "motor_voltage", "voltage", "input_voltage", "pwm", "motor_pwm", "duty", "duty_cycle", "PWM"};
constexpr std::array<std::string_view, 8> units = {"V",   "mV",  "kV",   "%",
                                                   "PWM", "pwm", "duty", "percent"};

[[noreturn]] void refuse(const TomlTable& table, const char* key, const std::string& found) {
  table.refuse(key, {"a voltage or duty cycle is no torque", in_quotes(found),
                     "the motor's present current with its torque constant, or a torque",
                     "how much of a voltage becomes torque depends on the speed; record the "
                     "current, or state effort.kind = \"none\" and leave the column out to have "
                     "the motion checked alone"});
}

}  // namespace

void refuse_voltage_kind(const TomlTable& effort) {
  if (!effort.has("kind")) return;
  const std::string kind = effort.text("kind");
  if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) refuse(effort, "kind", kind);
}

void refuse_voltage_unit(const TomlTable& column) {
  if (!column.has("unit")) return;
  const std::string unit = column.text("unit");
  if (std::find(units.begin(), units.end(), unit) != units.end()) refuse(column, "unit", unit);
}

}  // namespace tribolog
