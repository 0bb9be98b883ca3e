#include "joint/quantity.h"

#include <cstddef>
#include <string_view>
#include <utility>

#include "base/enum_text.h"

namespace tribolog::joint {
namespace {

constexpr EnumTexts<Quantity> units("rad", "N·m", "kg", "N·m", "N·m/rad", "N·m·s/rad", "kg·m²",
                                    "N·m", "rad/s", "N·m·s/rad", "");

}  // namespace

std::string to_string(Quantity quantity) { return own_name(quantity); }

std::optional<Quantity> quantity_of(const std::string& key) {
  return own_names<Quantity>.find(key);
}

std::string unit_of(Quantity quantity, TorqueUnit torque) {
  const std::string unit(units.of(quantity));
  return torque == TorqueUnit::ampere ? in_amperes(unit) : unit;
}

std::string in_amperes(std::string text) {
  using Units = std::pair<std::string_view, std::string_view>;
  constexpr std::string_view per_ampere = "/A";
  for (const auto& [torque, current] : {Units{"N·m", "A"}, Units{"kg·m²", "A·s²/rad"}}) {
    for (std::size_t at = text.find(torque); at != std::string::npos; at = text.find(torque, at)) {
      const bool is_constant =
          std::string_view(text).substr(at + torque.size()).starts_with(per_ampere);
      if (!is_constant) text.replace(at, torque.size(), current);
      at += is_constant ? torque.size() : current.size();
    }
  }
  return text;
}

}  // namespace tribolog::joint
