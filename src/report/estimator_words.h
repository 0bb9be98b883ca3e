#pragma once
// Estimators in words.

#include <string>

#include "method/hysteresis/estimator.h"

namespace tribolog::report {

/// What the estimator is, in words: "z = 0 while the arm rises".
std::string meaning_of(method::hysteresis::Estimator estimator);

}  // namespace tribolog::report
