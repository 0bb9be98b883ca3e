#include "archive/store/calibration_archive.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "archive/archive_location.h"
#include "archive/sample_calibration.h"

#include "error.h"
#include "files/temporary_directory.h"

namespace tribolog::archive {
namespace {

using test::refusal_of;
using test::sample_calibration;
using test::TemporaryDirectory;

const std::string now = "2026-12-24T12:00:00Z";

class CalibrationArchiveTest : public testing::Test {
 protected:
  [[nodiscard]] std::string path() const { return directory_.path("a.tribolog"); }
  [[nodiscard]] CalibrationArchive open(sql::Access access = sql::Access::write) const {
    return open_archive(path(), access, 200);
  }
  /// As another program would.
  void run(const std::string& statement) const {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(path().c_str(), &database), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(database, statement.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(database);
    sqlite3_close(database);
  }
  std::vector<std::string> faults(const std::string& head = "") const {
    return open(sql::Access::read).verify(head, {}).faults;
  }
  TemporaryDirectory directory_;
};

TEST_F(CalibrationArchiveTest, GivesBackWhatWasAdded) {
  const NewCalibration given = sample_calibration(1, 2, 3, 0.45);
  const Added added = open().add(given, false, now);
  EXPECT_TRUE(added.is_new);
  CalibrationArchive again = open(sql::Access::read);
  const Entry entry = again.find(added.id.substr(0, shown_digits));
  EXPECT_EQ(entry.facts.of, given.facts.of);
  EXPECT_EQ(entry.facts.measured_at, "2026-01-04T10:00:00Z");
  EXPECT_EQ(entry.facts.temperature_C, 25.0);
  EXPECT_EQ(entry.facts.payload_kg, std::nullopt);
  const auto quantities = again.quantities(entry);
  ASSERT_EQ(quantities.size(), 2U);
  EXPECT_EQ(quantities[0].name, "coulomb_torque");
  EXPECT_EQ(quantities[0].estimate->value, 0.45);
  EXPECT_EQ(quantities[0].estimate->high, 0.46);
  EXPECT_FALSE(quantities[1].estimate);
  EXPECT_EQ(again.inputs(entry).size(), 2U);
  EXPECT_EQ(again.document(entry, DocumentKind::calibration), given.documents.front().bytes);
  EXPECT_EQ(again.document(entry, DocumentKind::report), std::nullopt);
  EXPECT_TRUE(faults().empty());
}

TEST_F(CalibrationArchiveTest, TheSameInputsAreOneEntry) {
  CalibrationArchive archive = open();
  NewCalibration one = sample_calibration(1, 2, 3, 0.45);
  const Added first = archive.add(one, false, now);
  one.facts.tool_version = "9.9";
  const Added second = archive.add(one, false, now);
  EXPECT_FALSE(second.is_new);
  EXPECT_EQ(second.id, first.id);
  EXPECT_EQ(second.tool_version, "0.1.0");
  EXPECT_EQ(archive.list({}).size(), 1U);
  const Added third = archive.add(one, true, now);
  EXPECT_TRUE(third.is_new);
  EXPECT_NE(third.id, first.id);
  EXPECT_EQ(archive.list({}).size(), 2U);
  Filter latest;
  latest.latest_revisions = true;
  ASSERT_EQ(archive.list(latest).size(), 1U);
  EXPECT_EQ(archive.list(latest).front().id, third.id);
  one.facts.configuration = "Resamples: 500\n";
  EXPECT_TRUE(archive.add(one, false, now).is_new);
}

TEST_F(CalibrationArchiveTest, KeepsTheFirstReport) {
  CalibrationArchive archive = open();
  const Added added = archive.add(sample_calibration(1, 2, 3, 0.45), false, now);
  const std::string html = "<html>" + std::string(100000, 'x') + "</html>";
  EXPECT_TRUE(archive.attach_report(added.id, html, now));
  EXPECT_FALSE(archive.attach_report(added.id, "<html>other</html>", now));
  const Entry entry = archive.find(added.id);
  EXPECT_EQ(archive.document(entry, DocumentKind::report), html);
  EXPECT_LT(archive.documents(entry)[1].stored_bytes, 200U);
  EXPECT_TRUE(faults().empty());
}

TEST_F(CalibrationArchiveTest, ListsByJointAndTime) {
  CalibrationArchive archive = open();
  for (const int day : {9, 3, 30}) {
    for (const int joint : {2, 1}) {
      archive.add(sample_calibration(1, joint, day, 0.45), false, now);
      archive.add(sample_calibration(2, joint, day, 0.45), false, now);
    }
  }
  Filter filter;
  filter.robot = "R1";
  filter.joint = "J2";
  const auto measured = archive.measured(filter);
  ASSERT_EQ(measured.size(), 3U);
  EXPECT_EQ(measured[0].entry.facts.measured_on, "2026-01-04");
  EXPECT_EQ(measured[2].entry.facts.measured_on, "2026-02-03");
  for (const Measured& one : measured) {
    EXPECT_EQ(one.entry.facts.of.joint, "J2");
    ASSERT_EQ(one.quantities.size(), 2U);
    EXPECT_EQ(one.quantities[0].estimate->value, 0.45);
  }
  EXPECT_EQ(archive.list({}).size(), 12U);
}

TEST_F(CalibrationArchiveTest, FindsByEnoughDigits) {
  CalibrationArchive archive = open();
  const Added added = archive.add(sample_calibration(1, 2, 3, 0.45), false, now);
  EXPECT_EQ(archive.find(added.id.substr(0, 4)).id, added.id);
  EXPECT_THROW((void)archive.find(added.id.substr(0, 3)), UsageError);
  EXPECT_THROW((void)archive.find("%"), UsageError);
  EXPECT_THROW((void)archive.find("0000000000"), UsageError);
}

TEST_F(CalibrationArchiveTest, VerifyFindsEveryAlteration) {
  std::string id;
  std::string head;
  const auto fill = [&] {
    CalibrationArchive archive = open();
    id = archive.add(sample_calibration(1, 2, 3, 0.45), false, now).id;
    archive.add(sample_calibration(1, 2, 4, 0.46), false, now);
    archive.attach_report(id, "<html></html>", now);
    head = archive.verify("", {}).head;
  };
  fill();
  EXPECT_TRUE(faults(head).empty());
  EXPECT_FALSE(faults(std::string(64, '0')).empty());
  for (const char* const statement :
       {"UPDATE quantity SET value = value * 1.001, high = high * 1.1 WHERE place = 0",
        "UPDATE calibration SET temperature_C = 26 WHERE number = 1",
        "UPDATE calibration SET robot = 'R7' WHERE number = 2",
        "DELETE FROM quantity WHERE calibration = 2 AND place = 1",
        "DELETE FROM calibration WHERE number = 1", "DELETE FROM event WHERE number = 2",
        "UPDATE event SET at_utc = '2020-01-01T00:00:00Z' WHERE number = 1",
        "UPDATE content SET zstd = zeroblob(20) WHERE document = 1",
        "DELETE FROM document WHERE kind = 'report'", "DELETE FROM content WHERE document = 2",
        "UPDATE input SET bytes = bytes + 1", "PRAGMA foreign_keys=0; DELETE FROM document",
        "PRAGMA foreign_keys=0; DELETE FROM calibration WHERE number = 2"}) {
    std::filesystem::remove(path());
    fill();
    run(statement);
    EXPECT_FALSE(faults().empty()) << statement;
  }
  // Cut off at its end, the chain alone is whole: the head that was written down tells.
  std::filesystem::remove(path());
  fill();
  run("PRAGMA foreign_keys=1; DELETE FROM event WHERE number = 3; "
      "DELETE FROM document WHERE kind = 'report'");
  EXPECT_TRUE(faults().empty());
  EXPECT_FALSE(faults(head).empty());
}

TEST_F(CalibrationArchiveTest, RemovesAndRemembersThatItDid) {
  CalibrationArchive archive = open();
  const Added added = archive.add(sample_calibration(1, 2, 3, 0.45), false, now);
  archive.remove(archive.find(added.id), now);
  EXPECT_TRUE(archive.list({}).empty());
  const Verification outcome = archive.verify("", {});
  EXPECT_TRUE(outcome.faults.empty());
  EXPECT_EQ(outcome.events, 2U);
  EXPECT_TRUE(archive.add(sample_calibration(1, 2, 3, 0.45), false, now).is_new);
}

TEST_F(CalibrationArchiveTest, BacksUpWithoutReplacingAFile) {
  CalibrationArchive archive = open();
  archive.add(sample_calibration(1, 2, 3, 0.45), false, now);
  const std::string copy = directory_.path("copy.tribolog");
  archive.backup(copy);
  CalibrationArchive other = open_archive(copy, sql::Access::read);
  EXPECT_EQ(other.list({}).size(), 1U);
  EXPECT_TRUE(other.verify(archive.verify("", {}).head, {}).faults.empty());
  EXPECT_THROW(archive.backup(copy), OutputError);
}

TEST_F(CalibrationArchiveTest, HostileTextsAreText) {
  NewCalibration hostile = sample_calibration(1, 2, 3, 0.45);
  hostile.facts.of.robot = "'; DROP TABLE calibration; --";
  hostile.facts.of.serial = "../../x\xe2\x80\xae";
  hostile.facts.of.joint = std::string(10000, 'J');
  CalibrationArchive archive = open();
  const Added added = archive.add(hostile, false, now);
  EXPECT_EQ(archive.find(added.id).facts.of, hostile.facts.of);
  Filter filter;
  filter.robot = hostile.facts.of.robot;
  EXPECT_EQ(archive.list(filter).size(), 1U);
  EXPECT_TRUE(faults().empty());
}

TEST_F(CalibrationArchiveTest, ImpossibleNumbersAreRefusedAndNothingIsKept) {
  NewCalibration wrong = sample_calibration(1, 2, 3, 0.45);
  wrong.quantities[0].estimate->low = 0.5;
  CalibrationArchive archive = open();
  EXPECT_ANY_THROW(archive.add(wrong, false, now));
  EXPECT_TRUE(archive.list({}).empty());
  EXPECT_EQ(archive.verify("", {}).events, 0U);
}

std::string refusal(const std::string& path, sql::Access access, ExitStatus& status) {
  try {
    (void)open_archive(path, access, 100);
  } catch (const Error& error) {
    status = error.status();
    return error.what();
  }
  status = ExitStatus::done;
  return "";
}

TEST_F(CalibrationArchiveTest, LeavesOtherFilesAlone) {
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

TEST_F(CalibrationArchiveTest, RefusesAnotherProgramsDatabaseANewerSchemaAndATruncatedFile) {
  ExitStatus status{};
  run("CREATE TABLE t (x)");
  EXPECT_NE(refusal(path(), sql::Access::write, status).find("of another program"),
            std::string::npos);
  EXPECT_EQ(status, ExitStatus::archive_failed);
  std::filesystem::remove(path());
  open().add(sample_calibration(1, 2, 3, 0.45), false, now);
  const std::string whole = directory_.contents("a.tribolog");
  run("PRAGMA user_version = 7");
  EXPECT_NE(refusal(path(), sql::Access::read, status).find("newer tribolog"), std::string::npos);
  EXPECT_EQ(status, ExitStatus::archive_failed);
  (void)directory_.file("a.tribolog", whole.substr(0, whole.size() / 2));
  EXPECT_NE(refusal(path(), sql::Access::read, status).find("damaged"), std::string::npos);
  EXPECT_EQ(status, ExitStatus::archive_failed);
  EXPECT_EQ(directory_.contents("a.tribolog").size(), whole.size() / 2);
}

TEST_F(CalibrationArchiveTest, SaysThatAnotherProcessHasLockedIt) {
  open().add(sample_calibration(1, 2, 3, 0.45), false, now);
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
  const TemporaryDirectory directory;
  ExitStatus status{};
  EXPECT_NE(refusal(directory.path("none"), sql::Access::read, status).find("no archive here"),
            std::string::npos);
  EXPECT_EQ(status, ExitStatus::input_refused);
  EXPECT_NE(refusal(directory.path("no/such/a"), sql::Access::write, status), "");
  EXPECT_EQ(status, ExitStatus::output_failed);
}

TEST(ArchiveLocation, FollowsTheXdgRules) {
  setenv("XDG_DATA_HOME", "/data", 1);
  EXPECT_EQ(default_location(), "/data/tribolog/archive.tribolog");
  setenv("XDG_DATA_HOME", "relative", 1);
  setenv("HOME", "/home/a", 1);
  EXPECT_EQ(default_location(), "/home/a/.local/share/tribolog/archive.tribolog");
  unsetenv("XDG_DATA_HOME");
  unsetenv("HOME");
  EXPECT_THROW((void)default_location(), UsageError);
}

}  // namespace
}  // namespace tribolog::archive
