#include "archive/postgres/postgres_errors.h"

#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>

#include "base/error.h"

namespace tribolog::sql {
namespace {

constexpr std::size_t longest_message = 400;

bool is_one_of(const std::string& state, std::initializer_list<const char*> states) {
  for (const char* const start : states) {
    if (state.starts_with(start)) return true;
  }
  return false;
}

}  // namespace

std::string in_one_line(const std::string& message) {
  std::string line;
  const char* gap = "";
  for (const char c : message) {
    if (c == '\n') {
      gap = "; ";
    } else if (c == ' ' || c == '\t') {
      if (*gap == '\0') gap = " ";
    } else {
      if (!line.empty()) line += gap;
      gap = "";
      line += c;
    }
  }
  return printable(line, longest_message);
}

void fail(const PostgresFailure& failure, const std::string& name, int wait_ms) {
  const std::string server = printable(name, longest_path) + ": ";
  const std::string said = in_one_line(failure.message);
  const std::string& state = failure.state;
  if (!failure.is_connected) {
    throw ArchiveError(server + "the connection to the server was lost (" + said +
                       "); what was not said to be archived may be missing: archive it again, the "
                       "same inputs are one entry");
  }
  if (state == "55P03") {
    throw ArchiveError(
        fmt::format("{}the archive is locked by another process, for more than {} s; nothing was "
                    "changed",
                    server, 1e-3 * wait_ms));
  }
  if (state == "25006" || (state == "42501" && failure.was_writing)) {
    throw OutputError(server + "the archive cannot be written (" + said + "); nothing was changed");
  }
  if (is_one_of(state, {"53100", "53400"})) {
    throw OutputError(server + "no space left for the archive (" + said + "); nothing was changed");
  }
  if (is_one_of(state, {"58"})) {
    throw OutputError(server + "the server cannot read or write the archive (" + said +
                      "); nothing was changed");
  }
  if (is_one_of(state, {"42P07", "42710"})) {
    throw ArchiveError(server + "no archive can be made beside another program's tables (" + said +
                       "); nothing was changed");
  }
  if (is_one_of(state, {"22", "23"})) {
    throw ArchiveError(server + "the archive's rules refuse this (" + said +
                       "); nothing was changed");
  }
  // Statements are right: what they name is missing, or something else.
  if (is_one_of(state, {"XX001", "XX002", "42", "0A"}) && state != "42501") {
    throw ArchiveError(server + "the archive is damaged (" + said +
                       "); it is left as it is; restore a backup");
  }
  throw ArchiveError(server + "the server refuses (" + said + "); nothing was changed");
}

}  // namespace tribolog::sql
