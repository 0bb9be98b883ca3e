#pragma once
// A real PostgreSQL server for a test program.

#include <string>

#include <sys/types.h>

#include "support/run_program.h"

namespace tribolog::test {

/// One server of the distribution's package, on loopback, from the first use to the program's end,
/// however it ends.
class PostgresServer {
 public:
  static PostgresServer& of_this_program();
  PostgresServer(const PostgresServer&) = delete;
  PostgresServer& operator=(const PostgresServer&) = delete;

  /// Empty: it runs. Else why it does not, where that is no fault: it is not installed.
  [[nodiscard]] const std::string& why_not() const { return why_not_; }

  /// A new database. @return its connection string, with the password.
  std::string new_database(const std::string& options = "");

  /// The connection string of a database, whether it is there or not.
  [[nodiscard]] std::string uri(const std::string& database) const;
  /// As it stands in the connection strings.
  [[nodiscard]] static std::string password_in_uri();

  /// As another program would: one or several statements. @return the first field of the result.
  /// @throw std::runtime_error: the server's message.
  std::string run(const std::string& statements, const std::string& uri_of_database) const;

 private:
  PostgresServer();
  ~PostgresServer();

  ScratchDirectory directory_;
  std::string uri_;
  std::string why_not_;
  pid_t process_{-1};
  int databases_{0};
};

}  // namespace tribolog::test
