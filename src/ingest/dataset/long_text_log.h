#pragma once
// Text logs in long format: each row is one signal's reading, "0.1,q,0.5".

#include <optional>
#include <string>
#include <vector>

#include "ingest/log/log_table.h"
#include "ingest/text/csv_dialect.h"

namespace tribolog::ingest::dataset {

/// Tables with a column for each signal, by the rules of arrays::spread_signals(). Of the log its
/// first rows alone are looked at where it is in no such format.
/// @param wanted columns: a log that has them as they stand is read as it stands. May be empty.
/// @return nothing for a log in another format, and for one that is refused: what is wrong with it
/// the reader of text logs says.
/// @throw InputError: the file cannot be read.
std::optional<std::vector<log::LogTable>> read_long_text(
    const std::string& path, const std::vector<log::WantedColumn>& wanted,
    const text::TextLogRules& rules);

}  // namespace tribolog::ingest::dataset
