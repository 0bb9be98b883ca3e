#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <new>

#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <unistd.h>

#include "archive/sql/databases.h"
#include "archive/sql/sql_connection.h"
#include "base/early_end.h"
#include "base/error.h"
#include "base/file_descriptor.h"
#include "base/output_place.h"

namespace tribolog::archive::sql {
namespace {

struct CloseDatabase {
  void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
};
struct FinishStatement {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Statement = std::unique_ptr<sqlite3_stmt, FinishStatement>;

constexpr std::size_t longest_message = 400;

std::string shown(const std::string& path) { return printable(path, longest_path); }

/// What the user does about it.
[[noreturn]] void fail(int status, const std::string& message, const std::string& path,
                       int wait_ms) {
  const std::string file = shown(path) + ": ";
  switch (status & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw ArchiveError(
          fmt::format("{}the archive is locked by another process, for more than "
                      "{} s; nothing was changed",
                      file, 1e-3 * wait_ms));
    case SQLITE_NOTADB:
      throw ArchiveError(file + "is no archive (no SQLite file); it is left as it is");
    case SQLITE_CORRUPT:
    case SQLITE_ERROR:  // statements are right: what they name is missing, or of another format
    case SQLITE_MISMATCH:
    case SQLITE_TOOBIG:
      throw ArchiveError(file + "the archive is damaged (" + printable(message, longest_message) +
                         "); it is left as it is; restore a backup, or save what can be read: "
                         "sqlite3 FILE .recover | sqlite3 saved.tribolog");
    case SQLITE_CONSTRAINT:
      throw ArchiveError(file + "the archive's rules refuse this (" +
                         printable(message, longest_message) + "); nothing was changed");
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
      throw OutputError(file + "the archive cannot be written (" + message +
                        "); nothing was changed");
    case SQLITE_FULL:
      throw OutputError(file + "no space left for the archive; nothing was changed");
    case SQLITE_IOERR:
      throw OutputError(file + "the system cannot read or write the archive (" + message +
                        "); nothing was changed");
    case SQLITE_NOMEM:
      throw std::bad_alloc();
    default:
      throw std::runtime_error(file + message);
  }
}

class SqliteConnection final : public Connection {
 public:
  SqliteConnection(const std::string& path, int flags, int wait_ms)
      : path_(path), wait_ms_(wait_ms) {
    sqlite3* opened = nullptr;
    const int status = sqlite3_open_v2(path.c_str(), &opened, flags | SQLITE_OPEN_NOMUTEX, nullptr);
    database_.reset(opened);
    sqlite3_extended_result_codes(opened, 1);
    if (status != SQLITE_OK) refuse(status);
    sqlite3_busy_timeout(opened, wait_ms);
    // What the file says about itself runs nothing.
    sqlite3_db_config(opened, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(opened, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_exec(opened, "PRAGMA cell_size_check=ON", nullptr, nullptr, nullptr);
  }

  [[nodiscard]] Dialect dialect() const override { return Dialect::sqlite; }
  [[nodiscard]] const std::string& name() const override { return path_; }

  Rows run(const std::string& text, const std::vector<Value>& parameters) override {
    sqlite3_stmt* statement = prepared(text);
    bind(statement, parameters);
    Rows rows;
    int status = SQLITE_ROW;
    while ((status = sqlite3_step(statement)) == SQLITE_ROW) rows.push_back(row_of(statement));
    const int ended = sqlite3_reset(statement);
    sqlite3_clear_bindings(statement);
    if (status != SQLITE_DONE) refuse(ended != SQLITE_OK ? ended : status);
    return rows;
  }
  using Connection::run;

  void run_script(const std::string& statements) override {
    const int status = sqlite3_exec(database_.get(), statements.c_str(), nullptr, nullptr, nullptr);
    if (status != SQLITE_OK) refuse(status);
  }

  void write(const std::function<void()>& work) override {
    transact("BEGIN IMMEDIATE", [&] {
      const Uninterrupted together;
      const int before = sqlite3_total_changes(database_.get());
      work();
      run_script("COMMIT");
      if (sqlite3_total_changes(database_.get()) == before) return;
      note_kept("changes of the archive " + shown(path_));
    });
  }
  void read(const std::function<void()>& work) override { transact("BEGIN", work); }

 private:
  [[noreturn]] void refuse(int status) const {
    fail(status, sqlite3_errmsg(database_.get()), path_, wait_ms_);
  }

  sqlite3_stmt* prepared(const std::string& text) {
    Statement& statement = statements_[text];
    if (statement) return statement.get();
    sqlite3_stmt* made = nullptr;
    const int status = sqlite3_prepare_v3(database_.get(), text.c_str(), -1,
                                          SQLITE_PREPARE_PERSISTENT, &made, nullptr);
    if (status != SQLITE_OK) refuse(status);
    statement.reset(made);
    return made;
  }

  void bind(sqlite3_stmt* statement, const std::vector<Value>& parameters) const {
    if (sqlite3_bind_parameter_count(statement) != static_cast<int>(parameters.size())) {
      throw std::logic_error(std::string("parameters of ") + sqlite3_sql(statement));
    }
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const int status = bind_one(statement, static_cast<int>(k) + 1, parameters[k]);
      if (status != SQLITE_OK) refuse(status);
    }
  }

  static int bind_one(sqlite3_stmt* statement, int index, const Value& value) {
    if (const auto* number = std::get_if<std::int64_t>(&value.content())) {
      return sqlite3_bind_int64(statement, index, *number);
    }
    if (const auto* number = std::get_if<double>(&value.content())) {
      return sqlite3_bind_double(statement, index, *number);
    }
    if (const auto* text = std::get_if<std::string>(&value.content())) {
      return sqlite3_bind_text64(statement, index, text->data(), text->size(), SQLITE_STATIC,
                                 SQLITE_UTF8);
    }
    if (const auto* blob = std::get_if<Blob>(&value.content())) {
      return sqlite3_bind_blob64(statement, index, blob->bytes.data(), blob->bytes.size(),
                                 SQLITE_STATIC);
    }
    return sqlite3_bind_null(statement, index);
  }

  /// A text as add() keeps them; a damaged or altered archive may hold any bytes.
  [[nodiscard]] std::string checked_text(std::string text) const {
    if (is_kept_text(text)) return text;
    throw ArchiveError(shown(path_) + ": the archive is damaged ('" + printable(text) +
                       "' is no text that it keeps); it is left as it is; restore a backup");
  }

  Row row_of(sqlite3_stmt* statement) const {
    Row row;
    const int columns = sqlite3_column_count(statement);
    for (int k = 0; k < columns; ++k) {
      const auto bytes = [&] {
        const void* begin = sqlite3_column_blob(statement, k);
        const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement, k));
        return begin == nullptr ? std::string()
                                : std::string(static_cast<const char*>(begin), size);
      };
      switch (sqlite3_column_type(statement, k)) {
        case SQLITE_INTEGER:
          row.emplace_back(static_cast<std::int64_t>(sqlite3_column_int64(statement, k)));
          break;
        case SQLITE_FLOAT:
          row.emplace_back(sqlite3_column_double(statement, k));
          break;
        case SQLITE_TEXT:
          row.emplace_back(checked_text(bytes()));
          break;
        case SQLITE_BLOB:
          row.emplace_back(Blob{bytes()});
          break;
        default:
          row.emplace_back();
      }
    }
    return row;
  }

  void transact(const char* begin, const std::function<void()>& work) {
    run_script(begin);
    try {
      work();
      if (sqlite3_get_autocommit(database_.get()) == 0) run_script("COMMIT");
    } catch (...) {
      // Some errors have rolled back already.
      if (sqlite3_get_autocommit(database_.get()) == 0) {
        sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
      }
      throw;
    }
  }

  std::string path_;
  int wait_ms_;
  std::unique_ptr<sqlite3, CloseDatabase> database_;
  std::map<std::string, Statement> statements_;  // goes before the database
};

/// Before SQLite sees the file: it takes an empty one for a new database.
void refuse_other_files(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() != fs::file_type::regular) {
    throw ArchiveError(shown(path) + ": is no file, and so no archive");
  }
  const std::uintmax_t bytes = fs::file_size(path, error);
  if (!error && bytes == 0) {
    throw ArchiveError(shown(path) + ": is an empty file, no archive; it is left as it is");
  }
}

/// SQLite could not take back what it has written behind the limit of a file's size.
bool is_larger_than_allowed(const std::string& path) {
  rlimit limit{};
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  return !error && getrlimit(RLIMIT_FSIZE, &limit) == 0 && bytes > limit.rlim_cur;
}

}  // namespace

std::unique_ptr<Connection> open_sqlite(const std::string& path, Access access, int wait_ms) {
  refuse_other_files(path);
  if (::access(path.c_str(), R_OK) != 0) {
    throw InputError({path, 0, 0}, {std::string("cannot be read: ") + strerror(errno), "", "", ""});
  }
  if (access == Access::write && ::access(path.c_str(), W_OK) != 0) {
    throw OutputError(shown(path) + ": the archive cannot be written: " + strerror(errno) +
                      "; nothing was changed");
  }
  if (access == Access::write && is_larger_than_allowed(path)) {
    throw OutputError(shown(path) + ": the archive cannot be written: " + strerror(EFBIG) +
                      "; nothing was changed");
  }
  // A journal that a killed process left is rolled back by the first who may write.
  const bool may_write = ::access(path.c_str(), W_OK) == 0;
  auto connection = std::make_unique<SqliteConnection>(
      path, may_write ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READONLY, wait_ms);
  const std::int64_t id = connection->run("PRAGMA application_id").front().front().integer();
  if (id != application_id) {
    throw ArchiveError(shown(path) +
                       ": is an SQLite file of another program, no archive; it is left as it is");
  }
  connection->run_script("PRAGMA foreign_keys=ON; PRAGMA synchronous=EXTRA");
  return connection;
}

std::unique_ptr<Connection> sqlite_in_memory() {
  return std::make_unique<SqliteConnection>(":memory:", SQLITE_OPEN_READWRITE, usual_wait_ms);
}

void create_sqlite(const std::string& path, const std::function<void(Connection&)>& fill) {
  TemporaryFile made{std::filesystem::path(path)};
  if (!made.file().is_open()) {
    throw OutputError(shown(path) + ": no archive can be made there: " + strerror(errno));
  }
  const Unfinished journal(made.path() + "-journal");
  {
    SqliteConnection connection(made.path(), SQLITE_OPEN_READWRITE, usual_wait_ms);
    connection.run_script(
        fmt::format("PRAGMA journal_mode=DELETE; PRAGMA synchronous=EXTRA; "
                    "PRAGMA application_id={}",
                    application_id));
    connection.read([&] { fill(connection); });  // nothing else has it yet
  }
  if (!made.open_to_others() || (!made.link_to(path) && errno != EEXIST)) {
    throw OutputError(shown(path) + ": no archive can be made there: " + strerror(errno));
  }
}

void copy_sqlite(Connection& from, const std::string& path) {
  TemporaryFile made{std::filesystem::path(path)};
  if (!made.file().is_open()) {
    throw OutputError(shown(path) + ": cannot be written: " + strerror(errno));
  }
  from.run("VACUUM INTO $1", {made.path()});
  if (!made.flush() || !made.open_to_others() || !made.link_to(path)) {
    throw OutputError(shown(path) + ": cannot be written: " + strerror(errno) +
                      (errno == EEXIST ? "; a backup replaces no file" : ""));
  }
}

std::vector<std::string> faults_of_sqlite(Connection& connection) {
  std::vector<std::string> faults;
  for (const Row& row : connection.run("PRAGMA integrity_check")) {
    if (row.front().text() != "ok") faults.push_back(row.front().text());
  }
  for (const Row& row : connection.run("PRAGMA foreign_key_check")) {
    faults.push_back("a row of " + row.front().text() + " belongs to no calibration");
  }
  return faults;
}

}  // namespace tribolog::archive::sql
