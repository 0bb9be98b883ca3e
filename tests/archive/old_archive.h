#pragma once
// An archive that an older program wrote.

#include <string>

#include "archive/sql/databases.h"
#include "base/input_file.h"

namespace tribolog::test {

/// The last link of its chain, as `archive verify` of that program told it.
inline const std::string head_of_schema_2 =
    "3c0cc2225e99291fb85105f079300ad515e2eecbf227c752d7558789c805b852";

/// Two calibrations; the first with report, inputs and a review.
inline void make_archive_of_schema_2(const std::string& path) {
  const std::string script =
      read_file(std::string(TRIBOLOG_SOURCE_DIR) + "/tests/data/archive_schema_2.sql");
  archive::sql::create_sqlite(path,
                              [&](archive::sql::Connection& made) { made.run_script(script); });
}

}  // namespace tribolog::test
