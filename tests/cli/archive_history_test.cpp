// `tribolog archive diff` and `archive trend`, through the program itself.

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sqlite3.h>

#include "cli/small_dataset.h"

namespace tribolog::test::archive_history_test {
namespace {

using nlohmann::json;

/// An archive of calibrations of one joint, one a week: the small dataset's, each with the gravity
/// torque times 1 + `step` from the 11th on, and a scatter of 0.1 %.
class ArchiveHistoryTest : public testing::Test {
 protected:
  void fill(std::size_t calibrations, double step) {
    const ProgramRun run = data_.run("identify", "one.json");
    ASSERT_LE(run.status, 1) << run.err;
    const json one = json::parse(read_text(data_.file("one.json")));
    std::string files;
    for (std::size_t k = 0; k < calibrations; ++k) {
      files += fmt::format(" '{}'", write_calibration(one, k, k >= 10 ? step : 0));
    }
    const ProgramRun added = archive("add" + files);
    ASSERT_EQ(added.status, 0) << added.err;
  }

  std::string write_calibration(json c, std::size_t k, double step) {
    static const double scatter[] = {0.3, -1.1, 0.6, 1.3, -0.4, -0.9, 0.2, 1.0, -0.7, 0.1};
    c["robot"]["measured_on"] = fmt::format("2026-{:02}-{:02}", 1 + k / 4, 1 + 7 * (k % 4));
    for (json& input : c["inputs"]) input["sha256"] = fmt::format("{:064x}", k + 1);
    for (json& q : c["verdict"]["quantities"]) {
      if (q["key"] != "gravity_torque") continue;
      q["verdict"] = "usable";
      const double was = q["estimate"]["estimate"];
      const double by = was * (step + 1e-3 * scatter[k * 7 % 10]);
      for (const char* end : {"estimate", "low", "high"}) {
        q["estimate"][end] = q["estimate"][end].get<double>() + by;
      }
    }
    return data_.scratch().write(fmt::format("c{}.json", k), c.dump());
  }

  [[nodiscard]] ProgramRun archive(const std::string& arguments) const {
    return run_shell("cd '" + data_.scratch().path() + "' && SOURCE_DATE_EPOCH=1700000000 " +
                     program + "archive " + arguments + " --archive a.tribolog");
  }
  [[nodiscard]] std::string id(std::size_t k) const {
    const json list = json::parse(archive("list --json").out);
    return list["calibrations"][k]["id"].get<std::string>().substr(0, 12);
  }

  SmallDataset data_;
};

const json& quantity(const json& quantities, std::string_view name) {
  for (const json& q : quantities) {
    if (q["name"] == name) return q;
  }
  throw std::logic_error(std::string(name));
}

TEST_F(ArchiveHistoryTest, TrendTellsAStepByTextJsonPageAndStatus) {
  fill(20, 0.05);
  const ProgramRun text = archive("trend --joint J1 --fail-on-warning -o trend.html");
  EXPECT_EQ(text.status, 1) << text.err;
  EXPECT_NE(text.out.find("has risen by 5.0"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("visible from 2026-03-15"), std::string::npos) << text.out;
  EXPECT_EQ(text.err.find("note:"), std::string::npos) << text.err;
  EXPECT_EQ(archive("trend").status, 0) << "only with --fail-on-warning";
  const std::string page = read_text(data_.file("trend.html"));
  EXPECT_NE(page.find("data:image/png"), std::string::npos);
  EXPECT_EQ(page.find("This figure is missing"), std::string::npos);
  const json trend = json::parse(archive("trend --json").out);
  const json& gravity = quantity(trend["joints"][0]["quantities"], "gravity_torque");
  EXPECT_EQ(gravity["state"], "warning");
  EXPECT_EQ(gravity["changes"][0]["visible_from"], "2026-03-15T00:00:00Z");
}

TEST_F(ArchiveHistoryTest, TrendWithoutAStepIsQuiet) {
  fill(20, 0);
  const ProgramRun run = archive("trend --fail-on-warning --baseline 8");
  EXPECT_EQ(run.status, 0) << run.out;
  EXPECT_NE(run.out.find("no change visible"), std::string::npos) << run.out;
  EXPECT_EQ(archive("trend --baseline 2").status, 2);
  EXPECT_EQ(archive("trend --baseline-from yesterday").status, 2);
  EXPECT_EQ(archive("trend --robot nobody").status, 0);
  EXPECT_EQ(archive("trend --robot nobody -o x.html").status, 2);
}

TEST_F(ArchiveHistoryTest, DiffTellsTheChangeAndRefusesWhatIsOne) {
  fill(11, 0.05);
  const ProgramRun text = archive(fmt::format("diff {} {} -o diff.html", id(0), id(10)));
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("changed"), std::string::npos) << text.out;
  const json diff = json::parse(archive(fmt::format("diff {} {} --json", id(0), id(10))).out);
  const json& gravity = quantity(diff["quantities"], "gravity_torque");
  EXPECT_EQ(gravity["word"], "changed");
  EXPECT_NEAR(gravity["change_percent"]["estimate"].get<double>(), 5, 0.3);
  const std::string page = read_text(data_.file("diff.html"));
  EXPECT_NE(page.find("Not both calibrations hold a friction curve"), std::string::npos);
  EXPECT_EQ(archive(fmt::format("diff {} {}", id(0), id(0))).status, 2);
  EXPECT_EQ(archive(fmt::format("diff {} ffffffff", id(0))).status, 2);
  EXPECT_EQ(archive(fmt::format("diff {} {} -o /nowhere/x.html", id(0), id(1))).status, 4);
}

TEST(ReportOfAnArchivedJoint, RefusesADamagedCalibrationBefore) {
  const SmallDataset data;
  const auto report = [&](const char* day) {
    data.scratch().write("dataset.toml",
                         replaced(small_manifest(), "name = \"test robot\"",
                                  fmt::format("name = \"test robot\"\nmeasured_on = {}", day)));
    return run_shell("cd '" + data.scratch().path() + "' && " + program +
                     "report dataset.toml --no-figures --truth-runs 0 --archive a.tribolog -o " +
                     day + ".html");
  };
  ASSERT_EQ(report("2026-01-01").status, 0);
  ASSERT_EQ(report("2026-01-02").status, 0);
  EXPECT_EQ(read_text(data.file("2026-01-01.html")).find("no change seen"), std::string::npos);
  EXPECT_NE(read_text(data.file("2026-01-02.html")).find("no change seen"), std::string::npos);
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(data.file("a.tribolog").c_str(), &database), SQLITE_OK);
  const std::string damage =
      "UPDATE document SET sha256 = '" + std::string(64, '0') + "' WHERE kind = 'calibration'";
  EXPECT_EQ(sqlite3_exec(database, damage.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(database);
  const ProgramRun refused = report("2026-01-03");
  EXPECT_EQ(refused.status, 6);
  EXPECT_NE(refused.err.find("is not what was archived; restore a backup; kept: "),
            std::string::npos)
      << refused.err;
  EXPECT_FALSE(std::filesystem::exists(data.file("2026-01-03.html")));
}

}  // namespace
}  // namespace tribolog::test::archive_history_test
