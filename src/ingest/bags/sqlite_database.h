#pragma once
// An SQLite file that is only read, behind a plain interface.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace tribolog {

/// Owner of an open database. Nothing is written, no lock is taken, and no file beside it is read.
class SqliteDatabase {
 public:
  /// @throw InputError naming the file: it cannot be opened, or is damaged.
  explicit SqliteDatabase(const std::string& path);

  [[nodiscard]] bool has_table(const std::string& name);
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  friend class SqliteRows;
  [[noreturn]] void refuse() const;

  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::string path_;
  std::unique_ptr<sqlite3, Close> database_;
};

/// The rows that a query gives, one after the other. Columns count from 0.
class SqliteRows {
 public:
  /// @throw InputError: the database is damaged or lacks what the query asks for.
  SqliteRows(SqliteDatabase& database, const std::string& query);

  /// @return false after the last row. @throw InputError: the database is damaged.
  bool next();
  [[nodiscard]] std::int64_t integer(int column);
  [[nodiscard]] std::string text(int column);
  /// Valid until the next call of next().
  [[nodiscard]] std::string_view blob(int column);

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  SqliteDatabase& database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

}  // namespace tribolog
