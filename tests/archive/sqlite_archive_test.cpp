// What an archive in a file does with files that are none, are damaged or are in use.

#include <stdlib.h>

#include "archive/sample_calibration.h"
#include "archive/sqlite_place.h"
#include "base/error.h"

namespace tribolog::archive::sqlite_archive_test {
namespace {

using test::sample_calibration;
using test::SqlitePlace;
using test::TemporaryDirectory;

const std::string now = "2026-12-24T12:00:00Z";

class SqliteArchive : public testing::Test {
 protected:
  [[nodiscard]] std::string path() const { return place_.location(); }
  [[nodiscard]] store::CalibrationArchive open() const {
    return store::open_archive(path(), sql::Access::write, 200);
  }
  void run(const std::string& statement) { place_.run(statement, true); }
  test::SqlitePlace place_;
  const test::TemporaryDirectory& directory_{place_.directory()};
};

TEST_F(SqliteArchive, BacksUpWithoutReplacingAFile) {
  store::CalibrationArchive archive = open();
  archive.add(test::sample_calibration(1, 2, 3, 0.45), false, now);
  const std::string copy = directory_.path("copy.tribolog");
  archive.backup(copy);
  store::CalibrationArchive other = store::open_archive(copy, sql::Access::read);
  EXPECT_EQ(other.list({}).size(), 1U);
  EXPECT_TRUE(other.verify(archive.verify("", {}).head, {}).faults.empty());
  EXPECT_THROW(archive.backup(copy), OutputError);
}

std::string refusal(const std::string& path, sql::Access access, ExitStatus& status) {
  try {
    (void)store::open_archive(path, access, 100);
  } catch (const Error& error) {
    status = error.status();
    return error.what();
  }
  status = ExitStatus::done;
  return "";
}

TEST_F(SqliteArchive, LeavesOtherFilesAlone) {
  const auto expect = [&](const std::string& bytes, ExitStatus wanted, const char* words) {
    (void)directory_.file("a.tribolog", bytes);
    for (const sql::Access access : {sql::Access::read, sql::Access::write}) {
      ExitStatus status{};
      EXPECT_NE(refusal(path(), access, status).find(words), std::string::npos)
          << refusal(path(), access, status);
      EXPECT_EQ(status, wanted);
      EXPECT_EQ(directory_.contents("a.tribolog"), bytes);
    }
  };
  expect("", ExitStatus::archive_failed, "empty file");
  expect("robot,serial\n1,2\n", ExitStatus::archive_failed, "is no archive");
  expect(std::string(5000, '\x5a'), ExitStatus::archive_failed, "is no archive");
}

TEST_F(SqliteArchive, RefusesAnotherProgramsDatabaseANewerSchemaAndATruncatedFile) {
  ExitStatus status{};
  run("CREATE TABLE t (x)");
  EXPECT_NE(refusal(path(), sql::Access::write, status).find("of another program"),
            std::string::npos);
  EXPECT_EQ(status, ExitStatus::archive_failed);
  std::filesystem::remove(path());
  open().add(test::sample_calibration(1, 2, 3, 0.45), false, now);
  const std::string whole = directory_.contents("a.tribolog");
  run("PRAGMA user_version = 7");
  EXPECT_NE(refusal(path(), sql::Access::read, status).find("newer tribolog"), std::string::npos);
  EXPECT_EQ(status, ExitStatus::archive_failed);
  (void)directory_.file("a.tribolog", whole.substr(0, whole.size() / 2));
  EXPECT_NE(refusal(path(), sql::Access::read, status).find("damaged"), std::string::npos);
  EXPECT_EQ(status, ExitStatus::archive_failed);
  EXPECT_EQ(directory_.contents("a.tribolog").size(), whole.size() / 2);
}

TEST_F(SqliteArchive, SaysThatAnotherProcessHasLockedIt) {
  open().add(test::sample_calibration(1, 2, 3, 0.45), false, now);
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path().c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database, "BEGIN EXCLUSIVE", nullptr, nullptr, nullptr), SQLITE_OK);
  ExitStatus status{};
  EXPECT_NE(refusal(path(), sql::Access::read, status).find("locked by another process"),
            std::string::npos);
  EXPECT_EQ(status, ExitStatus::archive_failed);
  sqlite3_close(database);
}

TEST(ArchiveLocation, IsAskedForWhereThereIsNone) {
  const test::TemporaryDirectory directory;
  ExitStatus status{};
  EXPECT_NE(refusal(directory.path("none"), sql::Access::read, status).find("no archive here"),
            std::string::npos);
  EXPECT_EQ(status, ExitStatus::input_refused);
  EXPECT_NE(refusal(directory.path("no/such/a"), sql::Access::write, status), "");
  EXPECT_EQ(status, ExitStatus::output_failed);
}

TEST(ArchiveLocation, FollowsTheXdgRules) {
  setenv("XDG_DATA_HOME", "/data", 1);
  EXPECT_EQ(store::default_location(), "/data/tribolog/archive.tribolog");
  setenv("XDG_DATA_HOME", "relative", 1);
  setenv("HOME", "/home/a", 1);
  EXPECT_EQ(store::default_location(), "/home/a/.local/share/tribolog/archive.tribolog");
  unsetenv("XDG_DATA_HOME");
  unsetenv("HOME");
  EXPECT_THROW((void)store::default_location(), UsageError);
}

using test::AnyArchive;
INSTANTIATE_TEST_SUITE_P(Sqlite, AnyArchive,
                         testing::Values([](std::string&) -> std::unique_ptr<test::ArchivePlace> {
                           return std::make_unique<test::SqlitePlace>();
                         }));

}  // namespace
}  // namespace tribolog::archive::sqlite_archive_test
