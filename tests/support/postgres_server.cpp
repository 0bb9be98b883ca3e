#include "support/postgres_server.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <thread>

#include <libpq-fe.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tribolog::test {
namespace {

constexpr int not_installed = 77;
constexpr std::chrono::seconds longest_start{60};

}  // namespace

PostgresServer& PostgresServer::of_this_program() {
  static PostgresServer server;
  return server;
}

PostgresServer::PostgresServer() {
  // Its owner is another user where this is root.
  std::filesystem::permissions(directory_.path(), std::filesystem::perms{0755});
  const std::string script = TRIBOLOG_SOURCE_DIR "/tests/support/postgres_server.sh";
  const std::string own = directory_.file("server");
  process_ = fork();
  if (process_ == 0) {
    execl(script.c_str(), script.c_str(), own.c_str(), static_cast<char*>(nullptr));
    _exit(1);
  }
  const auto until = std::chrono::steady_clock::now() + longest_start;
  while (uri_.empty() || PQping(uri_.c_str()) != PQPING_OK) {
    int status = 0;
    if (waitpid(process_, &status, WNOHANG) == process_) {
      process_ = -1;
      why_not_ = "PostgreSQL's server is not installed";
      if (WIFEXITED(status) && WEXITSTATUS(status) == not_installed) return;
      throw std::runtime_error("no PostgreSQL server: " + read_text(own + "/server.log"));
    }
    if (std::chrono::steady_clock::now() > until) throw std::runtime_error("no PostgreSQL server");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    uri_ = read_text(own + "/uri");
    while (uri_.ends_with('\n')) uri_.pop_back();
  }
}

PostgresServer::~PostgresServer() {
  if (process_ > 0) {
    kill(process_, SIGQUIT);
    waitpid(process_, nullptr, 0);
  }
}

std::string PostgresServer::uri(const std::string& database) const {
  return uri_.substr(0, uri_.rfind('/') + 1) + database;
}

std::string PostgresServer::password_in_uri() { return "p%40ss%3A%20w%C3%B6rd%2F%3F%23"; }

std::string PostgresServer::new_database(const std::string& options) {
  const std::string name = "test_" + std::to_string(++databases_);
  run("CREATE DATABASE " + name + " " + options, uri_);
  return uri(name);
}

std::string PostgresServer::run(const std::string& statements,
                                const std::string& uri_of_database) const {
  const std::unique_ptr<PGconn, decltype(&PQfinish)> connection(
      PQconnectdb(uri_of_database.c_str()), &PQfinish);
  const std::unique_ptr<PGresult, decltype(&PQclear)> result(
      PQexec(connection.get(), statements.c_str()), &PQclear);
  const ExecStatusType status = PQresultStatus(result.get());
  if (status != PGRES_COMMAND_OK && status != PGRES_TUPLES_OK) {
    throw std::runtime_error(PQerrorMessage(connection.get()));
  }
  return PQntuples(result.get()) == 0 ? "" : PQgetvalue(result.get(), 0, 0);
}

}  // namespace tribolog::test
