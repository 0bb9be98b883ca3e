#pragma once
// What a PostgreSQL server answers: values, and errors in their place.

#include <string>
#include <vector>

#include <libpq-fe.h>

#include "archive/sql/sql_connection.h"

namespace tribolog::archive::postgres {

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

// Values as PostgreSQL sends and takes them, in its binary form: a number comes back to the last
// bit, and bytes need no escapes.

/// The parameters of one statement as PQexecParams() takes them. Lives as long as the values.
class PostgresParameters {
 public:
  explicit PostgresParameters(const std::vector<sql::Value>& values);

  [[nodiscard]] int count() const { return static_cast<int>(types_.size()); }
  [[nodiscard]] const Oid* types() const { return types_.data(); }
  [[nodiscard]] const char* const* values() const { return pointers_.data(); }
  [[nodiscard]] const int* lengths() const { return lengths_.data(); }
  [[nodiscard]] const int* formats() const { return formats_.data(); }

 private:
  void add(Oid type, const std::string& bytes);

  std::vector<std::string> numbers_;
  std::vector<Oid> types_;
  std::vector<const char*> pointers_;
  std::vector<int> lengths_;
  std::vector<int> formats_;
};

/// One field of a binary result: BIGINT, DOUBLE PRECISION, TEXT or BYTEA.
/// @throw std::logic_error: another type, which no table of an archive has.
sql::Value field_of(const PGresult* result, int row, int column);

}  // namespace tribolog::archive::postgres
