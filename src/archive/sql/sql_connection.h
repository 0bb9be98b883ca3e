#pragma once
// A database behind a plain interface: an SQLite file or a PostgreSQL server.
//
// Statements are written once for both: parameters are $1, $2, ... in the order of their first
// occurrence, and nothing is used that one of them lacks. All values are bound, none is part of a
// statement's text.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "archive/sql/sql_value.h"

namespace tribolog::sql {

/// What the two write differently.
enum class Dialect { sqlite, postgres };

enum class Access { read, write };

/// How long a statement waits for another process before it gives up.
inline constexpr int usual_wait_ms = 5000;

class Connection {
 public:
  Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  virtual ~Connection() = default;

  [[nodiscard]] virtual Dialect dialect() const = 0;
  /// For messages: the file, or the server without a password.
  [[nodiscard]] virtual const std::string& name() const = 0;

  /// One statement. @return the rows it gives.
  /// @throw ArchiveError: damaged, locked for longer than the time to wait, or the connection is
  ///        lost. @throw OutputError: read-only, or the disk is full; nothing was changed.
  virtual Rows run(const std::string& statement, const std::vector<Value>& parameters) = 0;
  Rows run(const std::string& statement) { return run(statement, {}); }

  /// Several statements without parameters: a schema.
  virtual void run_script(const std::string& statements) = 0;

  /// Runs `work` as one transaction: all of it is kept, on the disk, when this returns, or none of
  /// it where `work` throws or the machine fails. Writers wait for each other.
  virtual void write(const std::function<void()>& work) = 0;

  /// Runs `work` on one state of the database, whatever others write meanwhile.
  virtual void read(const std::function<void()>& work) = 0;
};

}  // namespace tribolog::sql
