#pragma once
// Logs in Parquet (https://parquet.apache.org/docs/file-format/), as pandas, polars, Spark and
// LeRobot write them.
//
// Flat columns, structures ("a.b") and lists of numbers, in every encoding and every codec of the
// format but LZO. Only what the schema needs is read: columns of bytes, images say, are passed
// over. A page's CRC is checked where it has one. Memory: the tables and one column's pages of one
// group of rows.

#include <string>
#include <string_view>
#include <vector>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::parquet {

/// The one table of a Parquet file. Nulls, NaN and what is infinite are gaps; timestamps are ISO
/// times, dates and times of day are read as such; texts are times or words. A list with as many
/// numbers in each row gives the columns name_0, name_1, ...; in a data set of LeRobot they are
/// named as its meta/info.json says, see lerobot_set.h. What is not read is left out with the
/// reason: maps, lists of lists, lists of varying length, bytes.
/// @throw InputError: the file cannot be read, is cut off, damaged or encrypted, is compressed by
///        what is not read or whose library is missing, or holds no rows of numbers.
std::vector<log::LogTable> read_parquet(const std::string& path);

/// The same of a file's bytes. @param file its name, for messages; no data set is looked for.
std::vector<log::LogTable> parse_parquet(std::string_view bytes, const std::string& file);

}  // namespace tribolog::ingest::parquet
