#include "calibration/provenance.h"

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "base/error.h"
#include "base/shown_text.h"
#include "git_revision.h"

#ifndef TRIBOLOG_VERSION
#define TRIBOLOG_VERSION "unknown"
#endif
#ifndef TRIBOLOG_EIGEN_VERSION
#define TRIBOLOG_EIGEN_VERSION "unknown"
#endif

namespace tribolog::calibration {
namespace {

constexpr std::int64_t end_of_year_9999 = 253402300799;

std::string compiler_name() {
#if defined(__clang__)
  return std::string("Clang ") + __clang_version__;
#elif defined(__GNUC__)
  return std::string("GCC ") + __VERSION__;
#else
  return "unknown";
#endif
}

std::string last_part(std::string path) {
  while (path.size() > 1 && path.back() == '/') path.pop_back();
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos || path.size() == 1 ? path : path.substr(slash + 1);
}

bool is_absolute(const std::string& path) {
  return !path.empty() && (path.front() == '/' || path.front() == '~');
}

/// "postgresql://..." may hold a password; so may a broken one.
std::string without_server(const std::string& argument) {
  const std::size_t begin = argument.find("://");
  if (begin == std::string::npos ||
      argument.substr(0, begin).find("postgres") == std::string::npos) {
    return argument;
  }
  return argument.substr(0, begin) + "://...";
}

std::string without_directories(const std::string& argument) {
  if (argument != without_server(argument)) return without_server(argument);
  if (is_absolute(argument)) return last_part(argument);
  const std::size_t equals = argument.find('=');
  if (equals == std::string::npos || !is_absolute(argument.substr(equals + 1))) return argument;
  return argument.substr(0, equals + 1) + last_part(argument.substr(equals + 1));
}

}  // namespace

std::string creation_time_utc(const char* source_date_epoch) {
  std::int64_t seconds = std::time(nullptr);
  if (source_date_epoch != nullptr && *source_date_epoch != '\0') {
    const char* const end = source_date_epoch + std::strlen(source_date_epoch);
    const auto [stopped, fault] = std::from_chars(source_date_epoch, end, seconds);
    if (fault != std::errc{} || stopped != end || seconds < 0 || seconds > end_of_year_9999) {
      throw UsageError("SOURCE_DATE_EPOCH is '" + printable(source_date_epoch) +
                       "'; it must be whole seconds since 1970, from 0 to " +
                       std::to_string(end_of_year_9999));
    }
  }
  const std::time_t time = static_cast<std::time_t>(seconds);
  std::tm utc{};
  gmtime_r(&time, &utc);
  char text[32];
  const std::size_t length = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return {text, length};
}

std::string command_line_text(const std::vector<std::string>& arguments) {
  std::string line;
  for (const std::string& argument : arguments) {
    if (!line.empty()) line += ' ';
    line += quoted_for_shell(without_directories(argument));
  }
  return line;
}

Provenance make_provenance(const std::vector<std::string>& arguments) {
  Provenance made;
  made.tool_version = TRIBOLOG_VERSION;
  made.git_revision = tribolog_git_revision;
  made.compiler = compiler_name();
  made.eigen_version = TRIBOLOG_EIGEN_VERSION;
  made.created_utc = creation_time_utc(std::getenv("SOURCE_DATE_EPOCH"));
  std::vector<std::string> command = arguments;
  if (!command.empty()) command.front() = last_part(command.front());
  made.command_line = command_line_text(command);
  return made;
}

}  // namespace tribolog::calibration
