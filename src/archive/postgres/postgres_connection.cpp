#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <libpq-fe.h>

#include "archive/postgres/postgres_answers.h"
#include "archive/sql/databases.h"
#include "base/error.h"

namespace tribolog::archive::postgres {

// Which server an archive is on, by its connection string.

namespace {

/// A connection string that libpq understands, and what may be shown of it.
struct PostgresLocation {
  std::string uri;    ///< For libpq; may hold a password.
  std::string shown;  ///< "postgresql://user@host:port/database", as far as it states these.
};

[[noreturn]] void refuse() {
  throw UsageError(
      "the archive's connection string cannot be read; it has the form "
      "postgresql://USER@HOST:PORT/DATABASE, with options of libpq's behind a ?; characters such "
      "as "
      "@ / : ? % # of a name or a password are written as %40 %2F %3A %3F %25 %23");
}

/// A password with an unescaped `@` or `/` would be taken for a host or a database, and shown.
bool shows_where_its_password_ends(const std::string& uri) {
  const std::string rest = uri.substr(uri.find("//") + 2);
  const std::size_t at = rest.find('@');
  return at == std::string::npos || (at < rest.find('/') && at < rest.find('?') &&
                                     rest.find('@', at + 1) == std::string::npos);
}

using Options = std::unique_ptr<PQconninfoOption, decltype(&PQconninfoFree)>;

std::map<std::string, std::string> stated_in(const std::string& uri) {
  const Options options(PQconninfoParse(uri.c_str(), nullptr), &PQconninfoFree);
  if (!options) refuse();
  std::map<std::string, std::string> stated;
  for (const PQconninfoOption* option = options.get(); option->keyword != nullptr; ++option) {
    if (option->val != nullptr) stated[option->keyword] = option->val;
  }
  return stated;
}

/// @param uri "postgresql://user:password@host:port/database?option=value"; as libpq takes them.
/// @throw UsageError: not of this form, or an `@` whose place makes it unclear where a password
///        ends. The message repeats nothing of the string.
PostgresLocation postgres_location(const std::string& uri) {
  if (uri.find('\0') != std::string::npos || !shows_where_its_password_ends(uri)) refuse();
  std::map<std::string, std::string> stated = stated_in(uri);
  const std::string& host = stated["host"].empty() ? stated["hostaddr"] : stated["host"];
  const std::string& port = stated["port"];
  const bool are_digits = std::all_of(port.begin(), port.end(),
                                      [](char c) { return (c >= '0' && c <= '9') || c == ','; });
  if (!are_digits) refuse();
  std::string shown = "postgresql://";
  if (!stated["user"].empty()) shown += stated["user"] + "@";
  const bool is_socket = host.starts_with('/') || host.starts_with('@');
  if (!is_socket) shown += host;
  if (!is_socket && !port.empty()) shown += ":" + port;
  shown += "/" + stated["dbname"];
  if (is_socket) shown += "?host=" + host + (port.empty() ? "" : "&port=" + port);
  return {uri, shown};
}

/// Of the lock that writers of an archive wait at: "tribolog".
constexpr std::int64_t writers_lock = 0x747269626f6c6f67;

struct Disconnect {
  void operator()(PGconn* connection) const { PQfinish(connection); }
};
struct ClearResult {
  void operator()(PGresult* result) const { PQclear(result); }
};
using Result = std::unique_ptr<PGresult, ClearResult>;

std::unique_ptr<PGconn, Disconnect> connected(const std::string& uri) {
  // What stands before the string is a default that it may state otherwise: nobody waits for ever
  // for a server that does not answer.
  constexpr std::array names{
      "connect_timeout",  "keepalives_idle",  "keepalives_interval",
      "keepalives_count", "tcp_user_timeout", "application_name",
      "dbname",           "client_encoding",  static_cast<const char*>(nullptr)};
  const std::array values{"10",        "30",    "10",
                          "3",         "60000", "tribolog",
                          uri.c_str(), "UTF8",  static_cast<const char*>(nullptr)};
  constexpr int dbname_is_a_string = 1;
  std::unique_ptr<PGconn, Disconnect> connection(
      PQconnectdbParams(names.data(), values.data(), dbname_is_a_string));
  if (!connection) throw std::bad_alloc();
  return connection;
}

class PostgresConnection final : public sql::Connection {
 public:
  PostgresConnection(PostgresLocation location, int wait_ms, NoteKept note_kept)
      : name_(std::move(location.shown)),
        wait_ms_(wait_ms),
        note_kept_(note_kept),
        connection_(connected(location.uri)) {
    prepare_session();
  }

  [[nodiscard]] sql::Dialect dialect() const override { return sql::Dialect::postgres; }
  [[nodiscard]] const std::string& name() const override { return name_; }

  sql::Rows run(const std::string& statement, const std::vector<sql::Value>& parameters) override {
    constexpr int binary = 1;
    const PostgresParameters bound(parameters);
    const Result result =
        checked(PQexecParams(connection_.get(), statement.c_str(), bound.count(), bound.types(),
                             bound.values(), bound.lengths(), bound.formats(), binary));
    sql::Rows rows;
    for (int row = 0; row < PQntuples(result.get()); ++row) {
      sql::Row& fields = rows.emplace_back();
      for (int column = 0; column < PQnfields(result.get()); ++column) {
        fields.push_back(field_of(result.get(), row, column));
      }
    }
    return rows;
  }
  using sql::Connection::run;

  void run_script(const std::string& statements) override {
    (void)checked(PQexec(connection_.get(), statements.c_str()));
  }

  void write(const std::function<void()>& work) override {
    transact("BEGIN ISOLATION LEVEL READ COMMITTED", [&] {
      is_writing_ = true;
      run_script(fmt::format("SELECT pg_advisory_xact_lock({})", writers_lock));
      work();
    });
    note_kept_("changes of the archive " + printable(name_, longest_path));
  }

  void read(const std::function<void()>& work) override {
    transact("BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY", work);
  }

 private:
  void prepare_session() {
    const std::string server = printable(name_, longest_path) + ": ";
    if (PQstatus(connection_.get()) != CONNECTION_OK) {
      throw ArchiveError(server + "no connection to the archive: " +
                         in_one_line(PQerrorMessage(connection_.get())));
    }
    PQsetNoticeProcessor(connection_.get(), [](void*, const char*) {}, nullptr);
    const char* const encoding = PQparameterStatus(connection_.get(), "server_encoding");
    if (encoding == nullptr || std::string(encoding) != "UTF8") {
      throw ArchiveError(
          fmt::format("{}the database keeps its texts in {}, an archive needs UTF-8: "
                      "createdb -E UTF8 -T template0 NAME",
                      server, encoding == nullptr ? "no encoding" : encoding));
    }
    // A wait of 0 would be one without end. A client whose machine is gone keeps no lock.
    run_script(fmt::format(
        "SET lock_timeout = {}; SET tcp_keepalives_idle = 30; SET tcp_keepalives_interval = 10; "
        "SET tcp_keepalives_count = 3; SELECT set_config('synchronous_commit', 'on', false) "
        "WHERE current_setting('synchronous_commit') = 'off'",
        std::max(1, wait_ms_)));
  }

  /// A report may take minutes: a connection that was cut meanwhile is made again.
  void start(const char* begin) {
    try {
      run_script(begin);
    } catch (const ArchiveError&) {
      if (PQstatus(connection_.get()) == CONNECTION_OK) throw;
      PQreset(connection_.get());
      prepare_session();
      run_script(begin);
    }
  }

  Result checked(PGresult* answer) const {
    Result result(answer);
    const ExecStatusType status = PQresultStatus(answer);
    if (status == PGRES_TUPLES_OK || status == PGRES_COMMAND_OK) return result;
    const char* const state = PQresultErrorField(answer, PG_DIAG_SQLSTATE);
    const char* const primary = PQresultErrorField(answer, PG_DIAG_MESSAGE_PRIMARY);
    fail({state == nullptr ? "" : state,
          primary == nullptr ? PQerrorMessage(connection_.get()) : primary,
          PQstatus(connection_.get()) == CONNECTION_OK, is_writing_},
         name_, wait_ms_);
  }

  void transact(const char* begin, const std::function<void()>& work) {
    start(begin);
    try {
      work();
      const Result ended = checked(PQexec(connection_.get(), "COMMIT"));
      // One that failed on the way is rolled back by COMMIT, without an error.
      if (std::string(PQcmdStatus(ended.get())) != "COMMIT") {
        throw std::logic_error("a failed transaction was to be kept");
      }
      is_writing_ = false;
    } catch (...) {
      is_writing_ = false;
      if (PQtransactionStatus(connection_.get()) != PQTRANS_IDLE) {
        const Result rolled_back(PQexec(connection_.get(), "ROLLBACK"));
      }
      throw;
    }
  }

  std::string name_;
  int wait_ms_;
  NoteKept note_kept_;
  bool is_writing_{false};
  std::unique_ptr<PGconn, Disconnect> connection_;
};

}  // namespace

}  // namespace tribolog::archive::postgres

tribolog::archive::sql::Connection* tribolog_postgres_connection(
    const std::string& uri, tribolog::archive::sql::Access access, int wait_ms,
    NoteKept note_kept) {
  using namespace tribolog;
  auto connection = std::make_unique<tribolog::archive::postgres::PostgresConnection>(
      tribolog::archive::postgres::postgres_location(uri), wait_ms, note_kept);
  if (access == tribolog::archive::sql::Access::write &&
      connection->run("SELECT current_setting('transaction_read_only')").front().front().text() ==
          "on") {
    throw tribolog::OutputError(
        tribolog::printable(connection->name(), tribolog::longest_path) +
        ": the archive cannot be written: the server is read-only; nothing was "
        "changed");
  }
  return connection.release();
}
