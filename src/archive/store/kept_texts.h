#pragma once
// Which texts an archive takes.

#include <vector>

#include "archive/archived_calibration.h"
#include "archive/sql/sql_value.h"

namespace tribolog::archive {

/// SQLite would keep any bytes, PostgreSQL refuses some: both take UTF-8 without the character NUL.
/// @throw UsageError for any other text.
void refuse_unkept_texts(const std::vector<sql::Value>& values);
void refuse_unkept_texts(const NewCalibration& calibration);

}  // namespace tribolog::archive
