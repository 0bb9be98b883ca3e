#pragma once
// What a PostgreSQL server answers instead of a result, sorted by what the user does about it.

#include <string>

namespace tribolog::sql {

struct PostgresFailure {
  std::string state;    ///< SQLSTATE; empty where no server answered.
  std::string message;  ///< Of the server or of libpq.
  bool is_connected{};
  bool was_writing{};
};

/// One line: what libpq spreads over several.
std::string in_one_line(const std::string& message);

/// @param name of the archive, without a password. @param wait_ms that was waited for others.
/// @throw always. OutputError: read-only, no right to write, no space. ArchiveError: locked,
///        damaged, not there any more. UsageError: text that no database keeps.
[[noreturn]] void fail(const PostgresFailure& failure, const std::string& name, int wait_ms);

}  // namespace tribolog::sql
