#pragma once
// Surveys as a person reads them: what `tribolog inspect` prints.

#include <string>
#include <vector>

#include "inspect/survey/log_survey.h"

namespace tribolog::inspect::survey {

/// A block for each log; logs with the same columns share one, with a row for each. Fits into 100
/// places; control characters of a log are made visible.
/// @param joint whose motion the rows tell; empty: the one that moves most.
std::string survey_text(const std::vector<LogSurvey>& logs, const std::string& joint = "");

}  // namespace tribolog::inspect::survey
