#include "history/same_conditions.h"

#include <algorithm>
#include <cmath>

namespace tribolog::history {
namespace {

bool alike(double a, double b) {
  constexpr double rounding = 1e-9;
  return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
}

bool alike(const std::optional<double>& a, const std::optional<double>& b) {
  return a.has_value() == b.has_value() && (!a || alike(*a, *b));
}

}  // namespace

bool has_same_gear(const archive::Facts& a, const archive::Facts& b) {
  return alike(a.gear_ratio, b.gear_ratio);
}

bool has_same_payload(const archive::Facts& a, const archive::Facts& b) {
  return a.payload == b.payload && alike(a.payload_kg, b.payload_kg) &&
         alike(a.payload_distance_m, b.payload_distance_m);
}

}  // namespace tribolog::history
