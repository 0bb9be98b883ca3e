#include "base/requirements.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace tribolog {

namespace {

void refuse(double value, const char* what, const char* unit, const char* rule) {
  throw std::invalid_argument(fmt::format("{} {}{}{} is not allowed; it must be {}", what, value,
                                          *unit ? " " : "", unit, rule));
}

}  // namespace

void require_positive(double value, const char* what, const char* unit) {
  if (!std::isfinite(value) || value <= 0) refuse(value, what, unit, "> 0");
}

void require_not_negative(double value, const char* what, const char* unit) {
  if (!std::isfinite(value) || value < 0) refuse(value, what, unit, ">= 0");
}

void require_not_above(double value, const char* lower, double bound, const char* upper,
                       const char* unit) {
  if (value <= bound) return;
  throw std::invalid_argument(fmt::format("{} {} {} exceeds {} {} {}; it must not be larger", lower,
                                          value, unit, upper, bound, unit));
}

}  // namespace tribolog
