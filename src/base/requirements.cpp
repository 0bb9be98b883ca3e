#include "base/requirements.h"

#include <cmath>

namespace tribolog {

namespace {

[[noreturn]] void refuse(double value, const ParameterName& what, const char* unit, Code rule,
                         Code rule_of_number) {
  if (*unit == '\0') throw Refusal({rule_of_number, {what.stated_as("what"), {"value", value}}});
  throw Refusal({rule, {what.stated_as("what"), {"value", value}, {"unit", unit}}});
}

}  // namespace

StatedValue ParameterName::stated_as(std::string_view value) const {
  return words_.empty() ? StatedValue(value, name_) : StatedValue(value, Statement(words_));
}

void require_positive(double value, const ParameterName& what, const char* unit) {
  if (std::isfinite(value) && value > 0) return;
  refuse(value, what, unit, "requirement.positive", "requirement.positive_number");
}

void require_not_negative(double value, const ParameterName& what, const char* unit) {
  if (std::isfinite(value) && value >= 0) return;
  refuse(value, what, unit, "requirement.not_negative", "requirement.not_negative_number");
}

void require_not_above(double value, const ParameterName& lower, double bound,
                       const ParameterName& upper, const char* unit) {
  if (value <= bound) return;
  throw Refusal({"requirement.not_above",
                 {lower.stated_as("lower"),
                  {"value", value},
                  upper.stated_as("upper"),
                  {"bound", bound},
                  {"unit", unit}}});
}

}  // namespace tribolog
