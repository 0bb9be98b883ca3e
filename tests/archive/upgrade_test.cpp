#include "archive/store/upgrade.h"

#include <gtest/gtest.h>

#include "archive/archive_location.h"
#include "archive/sample_calibration.h"
#include "archive/store/schema.h"

#include "error.h"
#include "files/temporary_directory.h"

namespace tribolog::archive {
namespace {

const std::string now = "2026-12-24T12:00:00Z";

class Upgrade : public testing::Test {
 protected:
  void SetUp() override {
    open_archive(path_, sql::Access::write)
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

void add_humidity(sql::Connection& c) { c.run("ALTER TABLE calibration ADD COLUMN humidity REAL"); }
void fail(sql::Connection& c) {
  c.run("ALTER TABLE calibration ADD COLUMN wind REAL");
  throw std::runtime_error("no wind");
}

TEST_F(Upgrade, HasAsManyStepsAsTheSchemasNumberSays) {
  EXPECT_EQ(upgrade_steps().size() + 1, static_cast<std::size_t>(schema_version));
  EXPECT_EQ(upgrade(*connection_, upgrade_steps()), schema_version);
  EXPECT_EQ(directory_.entries(), 1U) << "no copy where nothing changes";
}

TEST_F(Upgrade, AppliesWhatIsMissingAndKeepsACopy) {
  EXPECT_EQ(upgrade(*connection_, {add_humidity}), 1);
  EXPECT_EQ(version_of(*connection_), 2);
  EXPECT_EQ(columns_called("humidity"), 1U);
  EXPECT_EQ(upgrade(*connection_, {add_humidity}), 2) << "once";
  EXPECT_EQ(open_archive(path_ + ".schema-1", sql::Access::read).list({}).size(), 1U);
  EXPECT_THROW((void)open_archive(path_, sql::Access::read), ArchiveError) << "newer than known";
}

TEST_F(Upgrade, IsAllOrNothing) {
  EXPECT_THROW(upgrade(*connection_, {add_humidity, fail}), std::runtime_error);
  EXPECT_EQ(version_of(*connection_), 1);
  EXPECT_EQ(columns_called("humidity"), 0U);
  EXPECT_EQ(columns_called("wind"), 0U);
  EXPECT_TRUE(open_archive(path_, sql::Access::read).verify("", {}).faults.empty());
}

}  // namespace
}  // namespace tribolog::archive
