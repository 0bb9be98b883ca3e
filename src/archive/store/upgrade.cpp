#include "archive/store/upgrade.h"

#include <filesystem>

#include <fmt/format.h>

#include "archive/sql/sqlite_connection.h"
#include "archive/store/schema.h"
#include "archive/store/schema_check.h"

namespace tribolog::archive {
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

}  // namespace tribolog::archive
