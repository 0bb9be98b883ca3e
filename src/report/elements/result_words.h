#pragma once
// What a result is called wherever a page names it.

#include <string>

#include "calibration/calibration.h"
#include "report/elements/elements.h"

namespace tribolog::report::elements {

Outcome outcome_of(calibration::Verdict verdict);
Outcome outcome_of(statistics::StageState state);
/// "doubtful"
std::string verdict_in_words(calibration::Verdict verdict);
/// In capitals, as the word of a page's outcome: "DOUBTFUL".
std::string verdict_heading(calibration::Verdict verdict);
/// "20 %", "< 1 %"
std::string share_in_words(double share);
/// A recording's path without its folders, which are in the provenance.
std::string log_name(const std::string& recording);
/// What tables call the estimators: "Mid-line", "Point B".
std::string estimator_name(method::hysteresis::Estimator estimator);
/// What the estimator is: "z = 0 while the arm rises".
std::string meaning_of(method::hysteresis::Estimator estimator);

}  // namespace tribolog::report::elements
