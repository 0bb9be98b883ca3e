#pragma once
// A value of a table, and rows of them.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/error.h"
#include "base/utf8.h"

namespace tribolog::archive::sql {

/// Bytes that are no text.
struct Blob {
  std::string bytes;
  bool operator==(const Blob&) const = default;
};

class Value {
 public:
  Value() = default;  ///< NULL
  Value(std::int64_t number) : value_(number) {}
  Value(double number) : value_(number) {}
  Value(std::string text) : value_(std::move(text)) {}
  Value(const char* text) : value_(std::string(text)) {}
  Value(Blob blob) : value_(std::move(blob)) {}
  /// NULL where absent.
  Value(const std::optional<double>& number) {
    if (number) value_ = *number;
  }

  [[nodiscard]] bool is_null() const { return std::holds_alternative<std::monostate>(value_); }
  /// @throw ArchiveError if it is none, as in a damaged archive; so do the next ones.
  [[nodiscard]] std::int64_t integer() const { return as<std::int64_t>("a whole number"); }
  /// Also of an integer.
  [[nodiscard]] double number() const {
    const auto* whole = std::get_if<std::int64_t>(&value_);
    return whole != nullptr ? static_cast<double>(*whole) : as<double>("a number");
  }
  [[nodiscard]] std::optional<double> number_if_any() const {
    return is_null() ? std::nullopt : std::optional(number());
  }
  [[nodiscard]] const std::string& text() const { return as<std::string>("a text"); }
  [[nodiscard]] const std::string& bytes() const { return as<Blob>("a document's bytes").bytes; }

  [[nodiscard]] const auto& content() const { return value_; }
  bool operator==(const Value&) const = default;

 private:
  template <class Type>
  [[nodiscard]] const Type& as(const char* what) const {
    if (const auto* content = std::get_if<Type>(&value_)) return *content;
    throw ArchiveError(std::string("the archive is damaged (another value stands where ") + what +
                       " belongs); it is left as it is; restore a backup");
  }

  std::variant<std::monostate, std::int64_t, double, std::string, Blob> value_;
};

using Row = std::vector<Value>;
using Rows = std::vector<Row>;

// Which texts an archive keeps.

/// SQLite would keep any bytes, PostgreSQL refuses some: both take UTF-8 without the character NUL.
inline bool is_kept_text(std::string_view text) {
  return text.find('\0') == std::string_view::npos && !first_broken_utf8(text);
}

// A database behind a plain interface: an SQLite file or a PostgreSQL server.
//
// Statements are written once for both: parameters are $1, $2, ... in the order of their first
// occurrence, and nothing is used that one of them lacks. All values are bound, none is part of a
// statement's text.

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

}  // namespace tribolog::archive::sql
