#pragma once
// Which texts an archive takes.

#include <vector>

#include "archive/sql/sql_value.h"
#include "calibration/archived_calibration.h"

namespace tribolog::archive {

/// @throw UsageError for a text that is not sql::is_kept_text().
void refuse_unkept_texts(const std::vector<sql::Value>& values);
void refuse_unkept_texts(const NewCalibration& calibration);

}  // namespace tribolog::archive
