#pragma once
// What every friction model has, with memory or without: a name and named parameters.

#include <string>

#include "friction/named_parameters.h"

namespace tribolog {

class FrictionModel {
 public:
  virtual ~FrictionModel() = default;
  /// As files say it: "gms".
  [[nodiscard]] virtual std::string name() const = 0;
  /// As files state them, in the header's order.
  [[nodiscard]] virtual NamedParameters named_parameters() const = 0;
};

}  // namespace tribolog
