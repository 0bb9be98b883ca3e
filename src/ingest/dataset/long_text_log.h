#pragma once
// Text logs in long format: each row is one signal's reading, "0.1,q,0.5".

#include <optional>
#include <string>
#include <vector>

#include "ingest/log/log_table.h"
#include "ingest/text/csv_dialect.h"
#include "ingest/text/csv_reader.h"

namespace tribolog::ingest::dataset {

/// The first rows of a text log with all columns that can be read; nothing where they are refused:
/// what is wrong with them the reader of the whole log says.
std::optional<text::CsvTable> first_rows_of_text(const std::string& path,
                                                 const text::TextLogRules& rules);

/// Tables with a column for each signal, by the rules of arrays::spread_signals().
/// @param first_rows by which the format is recognised.
/// @param wanted columns: a log that has them as they stand is read as it stands. May be empty.
/// @return nothing for a log in another format, and for one that is refused: what is wrong with it
/// the reader of text logs says.
/// @throw InputError: the file cannot be read.
std::optional<std::vector<log::LogTable>> read_long_text(
    const std::string& path, const std::optional<text::CsvTable>& first_rows,
    const std::vector<log::WantedColumn>& wanted, const text::TextLogRules& rules);

}  // namespace tribolog::ingest::dataset
