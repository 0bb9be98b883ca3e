#include <gtest/gtest.h>

#include "archive/old_archive.h"
#include "archive/sample_calibration.h"
#include "archive/store/archive_location.h"
#include "archive/store/schema.h"
#include "base/error.h"
#include "base/temporary_directory.h"

namespace tribolog::archive::upgrade_test {
namespace {

const std::string now = "2026-12-24T12:00:00Z";

class Upgrade : public testing::Test {
 protected:
  void SetUp() override {
    store::open_archive(path_, sql::Access::write)
        .add(test::sample_calibration(1, 2, 3, 0.45), false, now);
    connection_ = sql::open_sqlite(path_, sql::Access::write, sql::usual_wait_ms);
  }
  [[nodiscard]] std::size_t columns_called(const std::string& name) const {
    return connection_
        ->run("SELECT name FROM pragma_table_info('calibration') WHERE name = $1", {name})
        .size();
  }

  test::TemporaryDirectory directory_;
  std::string path_{directory_.path("a.tribolog")};
  std::unique_ptr<sql::Connection> connection_;
};

/// Steps of a program that knows more.
std::vector<store::UpgradeStep> and_then(const std::vector<store::UpgradeStep>& further) {
  std::vector<store::UpgradeStep> steps = store::upgrade_steps();
  steps.insert(steps.end(), further.begin(), further.end());
  return steps;
}

/// The tables as schema 1 had them.
void make_schema_1(sql::Connection& c) {
  c.run_script(
      "DELETE FROM event WHERE what = 'reviewed'; DROP TABLE review; ALTER TABLE event RENAME TO "
      "newer; CREATE TABLE event (number INTEGER PRIMARY KEY CHECK (number >= 1), at_utc TEXT NOT "
      "NULL, what TEXT NOT NULL CHECK (what IN ('added', 'report', 'removed')), id TEXT NOT NULL, "
      "digest TEXT NOT NULL, chain TEXT NOT NULL CHECK (length(chain) = 64)) STRICT; INSERT INTO "
      "event SELECT * FROM newer; DROP TABLE newer; PRAGMA user_version = 1");
}

void add_humidity(sql::Connection& c) { c.run("ALTER TABLE calibration ADD COLUMN humidity REAL"); }
void fail(sql::Connection& c) {
  c.run("ALTER TABLE calibration ADD COLUMN wind REAL");
  throw std::runtime_error("no wind");
}

TEST_F(Upgrade, HasAsManyStepsAsTheSchemasNumberSays) {
  EXPECT_EQ(store::upgrade_steps().size() + 1, static_cast<std::size_t>(store::schema_version));
  EXPECT_EQ(store::upgrade(*connection_, store::upgrade_steps()), store::schema_version);
  EXPECT_EQ(directory_.entries(), 1U) << "no copy where nothing changes";
}

TEST_F(Upgrade, AppliesWhatIsMissingAndKeepsACopy) {
  EXPECT_EQ(store::upgrade(*connection_, and_then({add_humidity})), store::schema_version);
  EXPECT_EQ(store::version_of(*connection_), store::schema_version + 1);
  EXPECT_EQ(columns_called("humidity"), 1U);
  EXPECT_EQ(store::upgrade(*connection_, and_then({add_humidity})), store::schema_version + 1)
      << "once";
  const std::string copy = path_ + ".schema-" + std::to_string(store::schema_version);
  EXPECT_EQ(store::open_archive(copy, sql::Access::read).list({}).size(), 1U);
  EXPECT_THROW((void)store::open_archive(path_, sql::Access::read), ArchiveError)
      << "newer than known";
}

TEST_F(Upgrade, IsAllOrNothing) {
  EXPECT_THROW(store::upgrade(*connection_, and_then({add_humidity, fail})), std::runtime_error);
  EXPECT_EQ(store::version_of(*connection_), store::schema_version);
  EXPECT_EQ(columns_called("humidity"), 0U);
  EXPECT_EQ(columns_called("wind"), 0U);
  EXPECT_TRUE(store::open_archive(path_, sql::Access::read).verify("", {}).faults.empty());
}

class OldArchive : public testing::Test {
 protected:
  void SetUp() override {
    test::make_archive_of_schema_2(path_);
    connection_ = sql::open_sqlite(path_, sql::Access::write, sql::usual_wait_ms);
  }
  [[nodiscard]] std::vector<std::string> faults(const std::string& head = "") const {
    return store::open_archive(path_, sql::Access::read).verify(head, {}).faults;
  }

  test::TemporaryDirectory directory_;
  std::string path_{directory_.path("a.tribolog")};
  std::unique_ptr<sql::Connection> connection_;
};

TEST_F(OldArchive, OfSchema1IsReadAndTakesReviewsOnceItIsWritten) {
  make_schema_1(*connection_);
  store::CalibrationArchive reader = store::open_archive(path_, sql::Access::read);
  const calibration::Entry entry = reader.list({}).front();
  EXPECT_TRUE(reader.reviews(entry).empty());
  EXPECT_TRUE(reader.verify("", {}).faults.empty());
  EXPECT_EQ(store::version_of(*connection_), 1) << "reading changes nothing";
  const std::string head = reader.verify("", {}).head;

  store::CalibrationArchive writer = store::open_archive(path_, sql::Access::write);
  EXPECT_EQ(store::version_of(*connection_), store::schema_version);
  writer.add_review(entry, {now, "A. Reviewer", calibration::Review::Decision::approved, {}});
  EXPECT_EQ(writer.reviews(entry).size(), 1U);
  EXPECT_TRUE(writer.verify(head, {}).faults.empty()) << "the chain goes on from where it was";
  EXPECT_EQ(store::open_archive(path_ + ".schema-1", sql::Access::read).verify(head, {}).head,
            head);
}

TEST_F(OldArchive, OfSchema2IsProvenByItsOwnDigestsBeforeAndAfter) {
  EXPECT_TRUE(faults(test::head_of_schema_2).empty());
  EXPECT_EQ(store::version_of(*connection_), 2) << "reading changes nothing";
  store::CalibrationArchive writer = store::open_archive(path_, sql::Access::write);
  EXPECT_EQ(store::version_of(*connection_), store::schema_version);
  EXPECT_TRUE(faults(test::head_of_schema_2).empty());
  writer.add(test::sample_calibration(1, 2, 3, 0.45), false, now);
  EXPECT_TRUE(faults(test::head_of_schema_2).empty());
}

TEST_F(OldArchive, IsCoveredWhereItsDigestsSayNothing) {
  const std::string kept = read_file(path_);
  for (const char* const statement :
       {"UPDATE document SET name = 'x.csv' WHERE name = 'log.csv'",
        "UPDATE document SET stored_bytes = stored_bytes + 1 WHERE number = 1",
        "UPDATE document SET sha256 = (SELECT sha256 FROM document WHERE number = 1) "
        "WHERE number = 2",
        "DELETE FROM document WHERE name = 'log.csv'", "DELETE FROM document WHERE kind = 'input'",
        "UPDATE calibration SET revision = 2 WHERE number = 1",
        "UPDATE calibration SET identity = (SELECT id FROM calibration WHERE number = 2) "
        "WHERE number = 1",
        "UPDATE quantity SET place = 7 WHERE place = 1",
        "UPDATE input SET place = 7 WHERE place = 1"}) {
    connection_->run_script(statement);
    EXPECT_FALSE(faults().empty()) << statement;
    connection_.reset();
    static_cast<void>(directory_.file("a.tribolog", kept));
    connection_ = sql::open_sqlite(path_, sql::Access::write, sql::usual_wait_ms);
  }
  EXPECT_TRUE(faults(test::head_of_schema_2).empty());
}

}  // namespace
}  // namespace tribolog::archive::upgrade_test
