#include "calibration/archived_calibration.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "base/enum_text.h"
#include "base/requirements.h"
#include "calibration/friction_speeds.h"
#include "joint/dataset.h"

namespace tribolog::calibration {

std::string to_string(Review::Decision decision) { return own_name(decision); }

Review::Decision decision_of(const std::string& word) {
  return own_names<Review::Decision>.find(word).value_or(Review::Decision::rejected);
}

// Either side of the gear.

std::string without_side(const std::string& words) {
  constexpr std::string_view side = " at the motor";
  return words.ends_with(side) ? words.substr(0, words.size() - side.size()) : words;
}

joint::TorqueUnit torque_unit_of(const std::vector<Quantity>& quantities) {
  using enum joint::TorqueUnit;
  const bool is_ampere = std::any_of(quantities.begin(), quantities.end(), [](const Quantity& q) {
    const std::optional<joint::Quantity> known = joint::quantity_of(q.name);
    return known && q.unit != joint::unit_of(*known, newton_metre) &&
           q.unit == joint::unit_of(*known, ampere);
  });
  return is_ampere ? ampere : newton_metre;
}

std::optional<int> gear_power(const std::string& quantity) {
  const std::optional<joint::Quantity> sought = joint::quantity_of(quantity);
  std::optional<int> power;
  for (const joint::LimitedQuantity& known : joint::limited_quantities()) {
    if (known.quantity != sought) continue;
    if (!power || known.gear_power != 0) power = known.gear_power;
  }
  return power;
}

std::vector<SidedQuantity> on_both_sides(const std::vector<Quantity>& quantities,
                                         double gear_ratio) {
  std::vector<SidedQuantity> all;
  for (const Quantity& quantity : quantities) {
    if (quantity.unit.empty() || speed_of_friction(quantity.name)) continue;
    const std::optional<int> power = gear_power(quantity.name);
    if (power == 0) {
      all.push_back({quantity, joint::Side::joint, 0});
      continue;
    }
    Quantity joint = quantity;
    joint.words = without_side(joint.words);
    all.push_back({joint, joint::Side::motor, 0});
    if (!power) continue;
    if (joint.estimate) joint.estimate = at_joint(quantity, gear_ratio);
    all.push_back({joint, joint::Side::joint, *power});
  }
  return all;
}

statistics::Estimate at_joint(const Quantity& quantity, double gear_ratio) {
  const int power = gear_power(quantity.name).value_or(0);
  return statistics::scaled(present(quantity.estimate), std::pow(gear_ratio, power));
}

std::string conversion_words(int power) {
  if (power == 0) return "as archived";
  std::string words = power > 0 ? "archived × n" : "archived / n";
  if (std::abs(power) == 2) words += "²";
  return words;
}

}  // namespace tribolog::calibration
