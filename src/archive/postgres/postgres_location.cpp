#include "archive/postgres/postgres_location.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>

#include <fmt/format.h>
#include <libpq-fe.h>

#include "base/error.h"

namespace tribolog::sql {
namespace {

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

}  // namespace

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

}  // namespace tribolog::sql
