#pragma once
// Surveys as JSON: what `tribolog inspect --json` writes.

#include <string>
#include <vector>

#include "inspect/survey/log_survey.h"

namespace tribolog::inspect::survey {

/// All of the surveys, in SI but for the columns' own ranges, which are in the log's unit.
/// @param manifest the proposed one; empty: none could be proposed.
std::string survey_json(const std::vector<LogSurvey>& logs, const std::string& manifest);

}  // namespace tribolog::inspect::survey
