#include "friction/friction_model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "base/requirements.h"
#include "base/statement.h"

namespace tribolog::friction {

// Elements of Maxwell-slip models.

// Element j slips at the deflection x_j = j/count xs. The curve's slope between two slips is the
// sum of the stiffnesses of those that still stick.
std::vector<MaxwellElement> maxwell_elements(double stiffness_Nm_rad, double static_Nm, int count) {
  require_positive(stiffness_Nm_rad, "stiffness", "N·m/rad");
  require_positive(static_Nm, "static torque", "N·m");
  if (count < 1) {
    throw Refusal({"maxwell_slip.number_below_one", {{"elements", count}}});
  }
  const double last = (2 - 1.0 / count) * static_Nm / stiffness_Nm_rad;
  const auto virgin = [&](int j) {
    const double left = 1 - static_cast<double>(j) / count;
    return static_Nm * (1 - left * left);
  };
  const double piece = last / count;
  std::vector<MaxwellElement> elements;
  for (int j = 1; j <= count; ++j) {
    const double slope = (virgin(j) - virgin(j - 1)) / piece;
    const double next = j == count ? 0.0 : (virgin(j + 1) - virgin(j)) / piece;
    const double stiffness = slope - next;
    elements.push_back({stiffness, stiffness * piece * j / static_Nm});
  }
  return elements;
}

void require_maxwell_elements(const std::vector<MaxwellElement>& elements) {
  if (elements.empty()) throw Refusal({"maxwell_slip.no_element"});
  double sum = 0;
  for (const MaxwellElement& one : elements) {
    require_positive(one.stiffness_Nm_rad, Code{"parameter.element_stiffness"}, "N·m/rad");
    require_positive(one.share, Code{"parameter.element_share"}, "");
    sum += one.share;
  }
  constexpr double rounding = 1e-9;
  if (!(std::abs(sum - 1) < rounding)) {
    throw Refusal({"maxwell_slip.shares_not_one", {{"sum", sum}}});
  }
}

// Parameters by name.

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

SteadyFriction::SteadyFriction(std::shared_ptr<const DynamicFriction> model)
    : model_(std::move(model)) {
  if (!model_) throw std::invalid_argument("no model");
}

}  // namespace tribolog::friction
