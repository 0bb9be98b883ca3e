#include "inspect/files/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "archive/sql/databases.h"
#include "base/error.h"
#include "base/input_file.h"
#include "ingest/log/log_format.h"

namespace tribolog::inspect::files {
namespace {

using ingest::log::LogFormat;

constexpr std::size_t start_bytes = std::size_t{1} << 16;
constexpr std::size_t end_bytes = std::size_t{1} << 20;
constexpr std::uint64_t largest_page_bytes = std::uint64_t{1} << 30;

std::string_view without_blanks_before(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

bool starts_with_tag(std::string_view text, std::string_view tag) {
  return text.size() >= tag.size() &&
         std::equal(tag.begin(), tag.end(), text.begin(), [](char wanted, char c) {
           return wanted == std::tolower(static_cast<unsigned char>(c));
         });
}

/// "dataset" of `schema = "tribolog-dataset-1"` or `"schema": "tribolog-dataset-1"`, without the
/// version; empty: none.
std::string_view schema_in(std::string_view text) {
  constexpr std::string_view key = "schema";
  constexpr std::string_view program = "tribolog-";
  for (std::size_t at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
    std::string_view rest = text.substr(at + key.size());
    const std::size_t value = rest.find_first_not_of(" \t\r\n\"'=:");
    if (value == std::string_view::npos) return {};
    rest.remove_prefix(value);
    if (!rest.starts_with(program)) continue;
    rest.remove_prefix(program.size());
    rest = rest.substr(0, rest.find_first_of("\"'\r\n"));
    return rest.substr(0, rest.rfind('-'));
  }
  return {};
}

FileKind kind_of_schema(std::string_view schema) {
  static constexpr std::array kinds{
      std::pair{std::string_view("dataset"), FileKind::manifest},
      std::pair{std::string_view("scenario"), FileKind::scenario},
      std::pair{std::string_view("joint"), FileKind::joint},
      std::pair{std::string_view("robot"), FileKind::arm},
      std::pair{std::string_view("calibration"), FileKind::calibration},
      std::pair{std::string_view("plan"), FileKind::plan},
      std::pair{std::string_view("truth"), FileKind::truth},
      std::pair{std::string_view("robot-truth"), FileKind::truth},
  };
  for (const auto& [name, kind] : kinds) {
    if (schema == name) return kind;
  }
  return schema.empty() ? FileKind::unknown : FileKind::other_json;
}

/// Of the elements with numbers that pages of this program have.
FileKind kind_of_page(std::string_view html) {
  const auto has = [&](std::string_view element) {
    return html.find(element) != std::string_view::npos;
  };
  if (has("id=\"tribolog-result\"")) return FileKind::report;
  if (has("id=\"tribolog-robot\"")) return FileKind::robot_page;
  if (has("id=\"tribolog-")) return FileKind::other_page;
  return has("name=\"generator\" content=\"tribolog ") ? FileKind::bare_page
                                                       : FileKind::foreign_page;
}

/// The field in which SQLite keeps whose file it is.
bool is_archive(std::string_view start) {
  constexpr std::size_t at = 68;
  constexpr std::size_t bytes = 4;
  if (start.size() < at + bytes) return false;
  std::uint32_t id = 0;
  for (const char byte : start.substr(at, bytes)) id = id << 8 | static_cast<unsigned char>(byte);
  return id == static_cast<std::uint32_t>(archive::sql::application_id);
}

bool is_number(std::string_view field) {
  return !field.empty() && field.find_first_of("0123456789") != std::string_view::npos &&
         field.find_first_not_of("0123456789+-.eE\"") == std::string_view::npos;
}

/// As a row of a log: at least two fields are numbers, and most are.
bool is_row_of_numbers(std::string_view line) {
  std::size_t numbers = 0;
  std::size_t fields = 0;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find_first_of(",;\t |\r"), line.size());
    const std::string_view field = line.substr(0, end);
    fields += field.empty() ? 0 : 1;
    numbers += is_number(field) ? 1 : 0;
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return numbers >= 2 && 2 * numbers > fields;
}

bool has_rows_of_numbers(std::string_view text) {
  constexpr std::size_t enough = 3;
  std::size_t rows = 0;
  while (!text.empty() && rows < enough) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    rows += is_row_of_numbers(text.substr(0, end)) ? 1 : 0;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return rows == enough;
}

FileKind kind_of_text(std::string_view text) {
  if (const FileKind kind = kind_of_schema(schema_in(text)); kind != FileKind::unknown) return kind;
  if (text.find("[[recording]]") != std::string_view::npos) return FileKind::manifest;
  return has_rows_of_numbers(text) ? FileKind::log : FileKind::unknown;
}

/// The last bytes of a file; all of a shorter one.
std::string read_end(const std::string& path, std::size_t most_bytes) {
  const InputFileSource file(path);
  const auto bytes =
      static_cast<std::size_t>(std::min<std::uint64_t>(most_bytes, file.likely_bytes()));
  std::string end(bytes, '\0');
  file.read_at(file.likely_bytes() - bytes, end.data(), bytes);
  return end;
}

/// Some writers sort the keys, and "schema" is behind most numbers then: a log of JSON, which may
/// be of any size, is not read for it.
FileKind kind_of_json(const std::string& path, std::string_view start) {
  const FileKind kind = kind_of_schema(schema_in(start));
  if (kind != FileKind::unknown || start.size() < start_bytes) return kind;
  return kind_of_schema(schema_in(read_end(path, end_bytes)));
}

FileKind kind_of_start(const std::string& path, const std::string& start) {
  const LogFormat format = ingest::log::detect_log_format(start, "");
  if (format == LogFormat::sqlite_bag) return is_archive(start) ? FileKind::archive : FileKind::log;
  if (format == LogFormat::json) return kind_of_json(path, start);
  if (format != LogFormat::text) return FileKind::log;
  const std::string_view text = without_blanks_before(start);
  if (starts_with_tag(text, "<!doctype html") || starts_with_tag(text, "<html")) {
    return kind_of_page(read_file(path, largest_page_bytes));
  }
  const bool is_urdf = text.starts_with('<') && text.find("<robot") != std::string_view::npos;
  return is_urdf ? FileKind::arm : kind_of_text(text);
}

}  // namespace

FileKind kind_of_file(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (failure || !fs::exists(status)) return FileKind::missing;
  if (fs::is_directory(status)) return FileKind::folder;
  if (!fs::is_regular_file(status)) return FileKind::unknown;
  try {
    const std::string start = read_start(path, start_bytes);
    return start.empty() ? FileKind::empty : kind_of_start(path, start);
  } catch (const InputError&) {
    return FileKind::missing;
  }
}

}  // namespace tribolog::inspect::files
