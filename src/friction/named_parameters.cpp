#include "friction/named_parameters.h"

#include <algorithm>
#include <type_traits>

#include "base/statement.h"

namespace tribolog::friction {

ParameterSlots joined(std::initializer_list<ParameterSlots> parts) {
  ParameterSlots all;
  for (const ParameterSlots& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

NamedParameters values_of(const ParameterSlots& slots) {
  NamedParameters values;
  for (const ParameterSlot& slot : slots) {
    values.push_back(
        {slot.key, slot.has_usual,
         std::visit([](const auto* place) { return ParameterValue(*place); }, slot.place)});
  }
  return values;
}

void set_values(const ParameterSlots& slots, const NamedParameters& values) {
  for (const NamedParameter& one : values) {
    const auto slot = std::find_if(slots.begin(), slots.end(),
                                   [&](const ParameterSlot& s) { return one.key == s.key; });
    if (slot == slots.end()) {
      throw Refusal({"friction.no_such_parameter", {{"parameter", one.key}}});
    }
    std::visit(
        [&](auto* place) {
          using Value = std::remove_pointer_t<decltype(place)>;
          const auto* value = std::get_if<Value>(&one.value);
          if (value == nullptr) {
            throw Refusal({"friction.parameter_of_another_kind", {{"parameter", one.key}}});
          }
          *place = *value;
        },
        slot->place);
  }
}

}  // namespace tribolog::friction
