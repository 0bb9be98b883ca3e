#pragma once

#include <sqlite3.h>

#include "archive/archive_place.h"

#include "files/temporary_directory.h"

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
  [[nodiscard]] const TemporaryDirectory& directory() const { return directory_; }

 private:
  TemporaryDirectory directory_;
};

}  // namespace tribolog::test
