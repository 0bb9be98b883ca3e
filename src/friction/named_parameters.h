#pragma once
// Parameters of a friction model by name: as files state them and listings show them.
//
// A model's Parameters say once, in by_name(), what each of their members is called in a file. What
// reads, writes or lists parameters goes by that and knows no model.

#include <cstdint>
#include <initializer_list>
#include <string>
#include <variant>
#include <vector>

#include "friction/maxwell_slip.h"

namespace tribolog::friction {

/// A physical number, a count, or the elements of a Maxwell-slip model.
using ParameterValue = std::variant<double, std::uint64_t, std::vector<MaxwellElement>>;

struct NamedParameter {
  std::string key;   ///< With its unit: "attraction_Nm_s".
  bool has_usual{};  ///< The literature has a usual value, which `value` is unless stated.
  ParameterValue value;
  friend bool operator==(const NamedParameter&, const NamedParameter&) = default;
};
using NamedParameters = std::vector<NamedParameter>;

/// Where a model's Parameters keep one of them.
struct ParameterSlot {
  const char* key;
  std::variant<double*, std::uint64_t*, std::vector<MaxwellElement>*> place;
  bool has_usual{false};
};
using ParameterSlots = std::vector<ParameterSlot>;

/// One list after the other.
ParameterSlots joined(std::initializer_list<ParameterSlots> parts);

NamedParameters values_of(const ParameterSlots& slots);

/// Of a model's Parameters.
template <class Parameters>
NamedParameters named(Parameters parameters) {
  return values_of(parameters.by_name());
}

/// Puts each value into the slot of its key.
/// @throw Refusal for a key or a kind of value that the slots do not have.
void set_values(const ParameterSlots& slots, const NamedParameters& values);

// What every friction model has, with memory or without: a name and named parameters.

class FrictionModel {
 public:
  virtual ~FrictionModel() = default;
  /// As files say it: "gms".
  [[nodiscard]] virtual std::string name() const = 0;
  /// As files state them, in the header's order.
  [[nodiscard]] virtual NamedParameters named_parameters() const = 0;
};

}  // namespace tribolog::friction
