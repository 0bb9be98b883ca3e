#pragma once
// A log beside the CSV of the same data.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "base/input_file.h"
#include "ingest/log/log_table.h"
#include "ingest/text/csv_reader.h"

namespace tribolog::test {

inline const ingest::log::LogTable& table_of(const std::vector<ingest::log::LogTable>& tables,
                                             std::string_view group) {
  const auto found =
      std::find_if(tables.begin(), tables.end(),
                   [&](const ingest::log::LogTable& table) { return table.group == group; });
  if (found == tables.end()) throw std::runtime_error("no table " + std::string(group));
  return *found;
}

/// The same columns in any order, with the same numbers to the last bit, and the same gaps. Times
/// agree to a picosecond: in a CSV they are decimal.
inline void expect_as_in_csv(const ingest::log::LogTable& table, const std::string& path) {
  const ingest::text::CsvTable csv = ingest::text::read_csv(read_file(path), path, {});
  EXPECT_EQ(table.refusal, "");
  ASSERT_EQ(table.rows, csv.rows);
  ASSERT_EQ(table.columns.size(), csv.columns.size()) << path;
  for (const ingest::log::LogColumn& wanted : csv.columns) {
    SCOPED_TRACE(path + ", column " + wanted.header.full);
    const auto found =
        std::find_if(table.columns.begin(), table.columns.end(), [&](const auto& one) {
          return one.header.name == wanted.header.full || one.header.full == wanted.header.full;
        });
    ASSERT_NE(found, table.columns.end());
    const bool is_time = wanted.header.name.ends_with("time");
    ASSERT_EQ(found->values.size(), csv.rows);
    for (std::size_t row = 0; row < csv.rows; ++row) {
      const double value = found->values[row];
      if (std::isnan(wanted.values[row])) {
        ASSERT_TRUE(std::isnan(value)) << "row " << row;
      } else {
        ASSERT_NEAR(value, wanted.values[row], is_time ? 1e-12 : 0) << "row " << row;
      }
    }
  }
}

}  // namespace tribolog::test
