#include "archive/store/archive_location.h"

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "archive/sql/databases.h"
#include "archive/store/schema.h"
#include "base/atomic_file.h"
#include "base/early_end.h"
#include "base/error.h"

namespace tribolog::archive::store {

namespace {

void keep_a_copy(sql::Connection& connection, int version) {
  if (connection.dialect() != sql::Dialect::sqlite) return;  // a server has backups of its own
  const std::string copy = fmt::format("{}.schema-{}", connection.name(), version);
  std::error_code error;
  if (!std::filesystem::exists(copy, error)) sql::copy_sqlite(connection, copy);
}

}  // namespace

const std::vector<UpgradeStep>& upgrade_steps() {
  static const std::vector<UpgradeStep> steps{add_reviews, take_wider_digests};
  return steps;
}

int upgrade(sql::Connection& connection, const std::vector<UpgradeStep>& steps) {
  const int wanted = 1 + static_cast<int>(steps.size());
  const int found = version_of(connection);
  refuse_other_versions(connection, wanted);
  if (found == wanted) return found;
  refuse_damaged_schema(connection, found);
  keep_a_copy(connection, found);
  connection.write([&] {
    // Another process may have been first.
    for (int version = version_of(connection); version < wanted; ++version) {
      steps[static_cast<std::size_t>(version - 1)](connection);
      set_version(connection, version + 1);
    }
  });
  return found;
}

namespace {

std::string absolute_path_in(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && value[0] == '/' ? value : "";
}

std::string path_of(const std::string& location) {
  return location.empty() ? default_location() : location;
}

void make_archive(const std::string& path) {
  const Uninterrupted together;
  sql::create_sqlite(path, [](sql::Connection& connection) { create_schema(connection); });
  note_kept("the new archive " + printable(path, longest_path));
}

[[noreturn]] void refuse_absent(const std::string& name) {
  throw InputError({name, 0, 0}, {"there is no archive here", "", "",
                                  "tribolog archive add, or report --archive, starts one"});
}

CalibrationArchive open_on_server(const std::string& uri, sql::Access access, int wait_ms) {
  auto connection = sql::open_postgres(uri, access, wait_ms);
  if (version_of(*connection) == 0) {
    if (access == sql::Access::read) refuse_absent(connection->name());
    connection->write([&] {  // another process may have been first
      if (version_of(*connection) == 0) create_schema(*connection);
    });
  }
  if (access == sql::Access::write) upgrade(*connection, upgrade_steps());
  return CalibrationArchive(std::move(connection));
}

}  // namespace

std::string default_location() {
  std::string data = absolute_path_in("XDG_DATA_HOME");
  if (data.empty()) {
    const std::string home = absolute_path_in("HOME");
    if (home.empty()) {
      throw UsageError(
          "where is the archive? Neither XDG_DATA_HOME nor HOME is set to an absolute path; state "
          "--archive PATH");
    }
    data = home + "/.local/share";
  }
  return data + "/tribolog/archive.tribolog";
}

bool is_server(const std::string& location) {
  return location.starts_with("postgresql://") || location.starts_with("postgres://");
}

bool is_there(const std::string& location) {
  std::error_code error;
  return is_server(location) ||
         std::filesystem::exists(std::filesystem::symlink_status(path_of(location), error));
}

void check_can_be_made(const std::string& location) {
  const std::string path = path_of(location);
  if (location.empty()) create_directory(std::filesystem::path(path).parent_path().string());
  check_output_can_be_written(path);
}

CalibrationArchive open_archive(const std::string& location, sql::Access access, int wait_ms) {
  const std::string path = path_of(location);
  if (is_server(path)) return open_on_server(path, access, wait_ms);
  if (access == sql::Access::write) {
    if (!is_there(location)) {
      check_can_be_made(location);
      make_archive(path);
    }
  } else if (std::error_code error; !std::filesystem::exists(path, error)) {
    refuse_absent(path);
  }
  auto connection = sql::open_sqlite(path, access, wait_ms);
  if (access == sql::Access::write) upgrade(*connection, upgrade_steps());
  return CalibrationArchive(std::move(connection));
}

}  // namespace tribolog::archive::store
