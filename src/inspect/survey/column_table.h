#pragma once
// Columns of a log, or of logs that look alike, as a table for the console.

#include <string>
#include <vector>

#include "inspect/survey/log_survey.h"

namespace tribolog {

/// @param tables at least one, all of the same columns: ranges are those over all of them.
std::string columns_text(const std::vector<const TableSurvey*>& tables);

}  // namespace tribolog
