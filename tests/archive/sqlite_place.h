#pragma once

#include <filesystem>

#include <sqlite3.h>

#include "archive/archive_place.h"
#include "base/temporary_directory.h"

namespace tribolog::test {

class SqlitePlace final : public ArchivePlace {
 public:
  [[nodiscard]] std::string location() const override { return directory_.path("a.tribolog"); }
  void run(const std::string& statements, bool cascades) override {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(location().c_str(), &database), SQLITE_OK);
    const std::string all =
        (cascades ? "PRAGMA foreign_keys=1; " : "PRAGMA foreign_keys=0; ") + statements;
    EXPECT_EQ(sqlite3_exec(database, all.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(database);
    sqlite3_close(database);
  }
  void start_again() override { std::filesystem::remove(location()); }
  void keep() override { copy(location(), location() + ".kept"); }
  void restore() override { copy(location() + ".kept", location()); }
  [[nodiscard]] std::unique_ptr<archive::sql::Connection> without_rules() const override {
    auto connection = archive::sql::open_sqlite(location(), archive::sql::Access::write, 200);
    connection->run_script("PRAGMA foreign_keys=0; PRAGMA ignore_check_constraints=1");
    return connection;
  }
  [[nodiscard]] std::string row_id() const override { return "rowid"; }
  [[nodiscard]] const TemporaryDirectory& directory() const { return directory_; }

 private:
  static void copy(const std::string& from, const std::string& to) {
    std::filesystem::copy_file(from, to, std::filesystem::copy_options::overwrite_existing);
  }

  TemporaryDirectory directory_;
};

}  // namespace tribolog::test
