#pragma once
// Springs in parallel, each with a slider of its own: hysteresis with non-local memory.

#include <vector>

namespace tribolog::friction {

/// One spring and slider.
struct MaxwellElement {
  double stiffness_Nm_rad{};  ///< > 0
  double share{};             ///< Of the whole torque at which it slips, > 0; all add up to 1.
  friend bool operator==(const MaxwellElement&, const MaxwellElement&) = default;
};

/// Elements that slip one after the other on the first loading, at equal distances: the virgin
/// curve is the polygon through points of T(x) = Ts (1 - (1 - x/xs)^2).
/// @param stiffness_Nm_rad of all together before the first slip, > 0
/// @param static_Nm torque at which the last one slips, > 0
/// @throw Refusal stating the value and the rule.
std::vector<MaxwellElement> maxwell_elements(double stiffness_Nm_rad, double static_Nm, int count);

/// @throw Refusal if there is none, a value is not > 0 or the shares do not add up.
void require_maxwell_elements(const std::vector<MaxwellElement>& elements);

}  // namespace tribolog::friction
