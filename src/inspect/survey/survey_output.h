#pragma once
// A survey of a log for people and for programs.

#include <string>
#include <vector>

#include "inspect/survey/log_survey.h"

namespace tribolog::inspect::survey {

// Surveys as a person reads them: what `tribolog inspect` prints.

/// A block for each log; logs with the same columns share one, with a row for each. Fits into 100
/// places; control characters of a log are made visible.
/// @param joint whose motion the rows tell; empty: the one that moves most.
std::string survey_text(const std::vector<LogSurvey>& logs, const std::string& joint = "");

// Surveys as JSON: what `tribolog inspect --json` writes.

/// All of the surveys, in SI but for the columns' own ranges, which are in the log's unit.
/// @param manifest the proposed one; empty: none could be proposed.
std::string survey_json(const std::vector<LogSurvey>& logs, const std::string& manifest);

}  // namespace tribolog::inspect::survey
