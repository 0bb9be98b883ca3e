// `tribolog archive ...`, and --archive of identify and report, as a user would call them.

#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_dataset.h"

namespace tribolog::test::archive_commands_test {
namespace {

using nlohmann::json;

class ArchiveCommands : public testing::Test {
 protected:
  /// In the scratch directory, with the archive a.tribolog behind it.
  [[nodiscard]] ProgramRun run(const std::string& command) const {
    return run_shell("cd '" + dataset_.scratch().path() + "' && " + program + command +
                     " --archive a.tribolog");
  }
  [[nodiscard]] json listed() const {
    const ProgramRun list = run("archive list --json");
    EXPECT_EQ(list.status, 0) << list.err;
    return json::parse(list.out)["calibrations"];
  }
  [[nodiscard]] std::string only_id() const {
    const json all = listed();
    EXPECT_EQ(all.size(), 1U);
    return all[0]["id"];
  }
  SmallDataset dataset_;
};

const std::string identified = "identify dataset.toml -o cal.json --truth-runs 0";
const std::string reported = "report dataset.toml -o r.html --truth-runs 0";

TEST_F(ArchiveCommands, IdentifyArchivesWhatAddWouldAdd) {
  const ProgramRun first = run(identified);
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_NE(first.out.find("archived: "), std::string::npos) << first.out;
  const std::string id = only_id();
  const ProgramRun second = run("archive add cal.json");
  EXPECT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(second.out.find("already archived: " + id.substr(0, 10)), 0U) << second.out;
  const json shown = json::parse(run("archive show " + id.substr(0, 8) + " --json").out);
  EXPECT_EQ(shown["robot"], "test robot");
  EXPECT_EQ(shown["joint"], "J1");
  EXPECT_EQ(shown["inputs"].size(), 2U);
  EXPECT_EQ(shown["quantities"][0]["name"], "cog_angle");
  EXPECT_NEAR(shown["quantities"][0]["estimate"], 0.2, 0.01);
  const ProgramRun again = run("archive add cal.json --again");
  EXPECT_EQ(again.out.find("archived: "), 0U) << again.out;
  EXPECT_EQ(listed().size(), 2U);
}

TEST_F(ArchiveCommands, TheReportComesBackByteForByte) {
  const ProgramRun made = run(reported);
  ASSERT_EQ(made.status, 0) << made.err;
  const std::string id = only_id();
  const ProgramRun back = run("archive report " + id + " -o back.html --calibration back.json");
  ASSERT_EQ(back.status, 0) << back.err;
  const std::string report = read_text(dataset_.file("r.html"));
  EXPECT_GT(report.size(), 50'000U);
  EXPECT_NE(report.find(id), std::string::npos);
  EXPECT_TRUE(read_text(dataset_.file("back.html")) == report);
  EXPECT_TRUE(read_text(dataset_.file("back.json")) ==
              read_text(dataset_.file("r.calibration.json")));
  // Made again on another day, the first one stays.
  const ProgramRun later = run(reported);
  EXPECT_EQ(later.status, 0) << later.err;
  EXPECT_NE(later.out.find("keeps its existing report"), std::string::npos) << later.out;
  EXPECT_EQ(run("archive report " + id + " -o back.html").status, 0);
  EXPECT_TRUE(read_text(dataset_.file("back.html")) == report);
}

TEST_F(ArchiveCommands, InputsAreKeptIfAsked) {
  ASSERT_EQ(run(identified + " --archive-inputs").status, 0);
  const json shown = json::parse(run("archive show " + only_id() + " --json").out);
  ASSERT_EQ(shown["documents"].size(), 3U);
  EXPECT_EQ(shown["documents"][1]["name"], "dataset.toml");
  EXPECT_EQ(shown["documents"][2]["bytes"], small_log().size());
  EXPECT_EQ(run_shell("cd '" + dataset_.scratch().path() + "' && " + program + identified +
                      " --archive-inputs")
                .status,
            2);
  dataset_.scratch().write("log.csv", small_log() + "9,0,0\n");
  const ProgramRun other = run("archive add cal.json --again --inputs .");
  EXPECT_EQ(other.status, 3);
  EXPECT_NE(other.err.find("is not the file that the calibration was made from"), std::string::npos)
      << other.err;
}

TEST_F(ArchiveCommands, VerifyProvesAndFindsAlteration) {
  ASSERT_EQ(run(identified).status, 0);
  const ProgramRun whole = run("archive verify");
  EXPECT_EQ(whole.status, 0) << whole.err;
  const std::string head = json::parse(run("archive verify --json").out)["head"];
  EXPECT_NE(whole.out.find("head: " + head), std::string::npos) << whole.out;
  EXPECT_EQ(run("archive verify --head " + head).status, 0);
  EXPECT_EQ(run("archive verify --head " + std::string(64, 'a')).status, 6);
  std::string bytes = read_text(dataset_.file("a.tribolog"));
  bytes.replace(bytes.find("test robot"), 10, "rest tobot");
  dataset_.scratch().write("a.tribolog", bytes);
  const ProgramRun altered = run("archive verify");
  EXPECT_EQ(altered.status, 6);
  EXPECT_NE(altered.err.find("damaged: "), std::string::npos) << altered.err;
}

TEST_F(ArchiveCommands, AnEmptyLocationIsNotTheUsersOwn) {
  const std::string own = "cd '" + dataset_.scratch().path() + "' && XDG_DATA_HOME='" +
                          dataset_.file("data") + "' " + program + identified + " --archive";
  for (const char* const empty : {" ''", "="}) {
    const ProgramRun refused = run_shell(own + empty);
    EXPECT_EQ(refused.status, 2) << refused.err;
  }
  EXPECT_FALSE(std::filesystem::exists(dataset_.file("data")));
  EXPECT_EQ(run_shell(own).status, 0);
  EXPECT_TRUE(std::filesystem::exists(dataset_.file("data/tribolog/archive.tribolog")));
}

TEST_F(ArchiveCommands, AddAndRemoveAnswerInJson) {
  ASSERT_EQ(run("identify dataset.toml -o cal.json --truth-runs 0").status, 0);
  const std::string id = only_id();
  const json added = json::parse(run("archive add cal.json --json").out);
  EXPECT_EQ(added["id"], id);
  EXPECT_EQ(added["is_new"], false);
  EXPECT_EQ(added["file"], "cal.json");
  const json removed = json::parse(run("archive remove --yes --json " + id).out);
  EXPECT_EQ(removed["removed"], json::array({id}));
  EXPECT_EQ(json::parse(run("archive add cal.json --json").out)["is_new"], true);
}

TEST_F(ArchiveCommands, NoPageReplacesTheArchive) {
  ASSERT_EQ(run(identified).status, 0);
  const std::string before = read_text(dataset_.file("a.tribolog"));
  const std::string id = only_id();
  for (const std::string& command :
       {"archive export --format csv " + id, "archive diff " + id + " " + id,
        std::string("archive trend"), std::string("archive fleet")}) {
    EXPECT_EQ(run(command + " -o a.tribolog").status, 2) << command;
  }
  EXPECT_TRUE(read_text(dataset_.file("a.tribolog")) == before);
}

TEST_F(ArchiveCommands, RemoveAsksFirst) {
  ASSERT_EQ(run(identified).status, 0);
  const std::string id = only_id();
  const ProgramRun unsure = run("archive remove " + id);
  EXPECT_EQ(unsure.status, 2);
  EXPECT_NE(unsure.out.find("would be removed: " + id.substr(0, 10)), std::string::npos);
  EXPECT_EQ(listed().size(), 1U);
  EXPECT_EQ(run("archive remove --yes " + id).status, 0);
  EXPECT_EQ(listed().size(), 0U);
  EXPECT_EQ(run("archive verify").status, 0);
}

TEST_F(ArchiveCommands, BackupIsAnArchive) {
  ASSERT_EQ(run(identified).status, 0);
  EXPECT_EQ(run("archive backup -o copy.tribolog").status, 0);
  EXPECT_EQ(run("archive backup -o copy.tribolog").status, 4);
  const ProgramRun copy =
      run_shell(program + "archive verify --archive '" + dataset_.file("copy.tribolog") + "'");
  EXPECT_EQ(copy.status, 0) << copy.err;
}

TEST_F(ArchiveCommands, AFailedFigureLosesNoNumbers) {
  const ProgramRun made =
      run_shell("cd '" + dataset_.scratch().path() + "' && TRIBOLOG_FONT_DIR=/nowhere " + program +
                reported + " --archive a.tribolog");
  EXPECT_EQ(made.status, 5) << made.err;
  EXPECT_EQ(listed().size(), 1U);
}

TEST_F(ArchiveCommands, NoOutputReplacesTheArchive) {
  ASSERT_EQ(run(identified).status, 0);
  const std::string before = read_text(dataset_.file("a.tribolog"));
  for (const char* const command :
       {"identify dataset.toml -o a.tribolog", "report dataset.toml -o a.tribolog",
        "report dataset.toml -o r.html --calibration a.tribolog"}) {
    EXPECT_EQ(run(command).status, 2) << command;
  }
  const std::string id = only_id();
  EXPECT_EQ(run("archive report " + id + " --calibration a.tribolog").status, 2);
  EXPECT_EQ(run("archive backup -o a.tribolog").status, 2);
  EXPECT_TRUE(read_text(dataset_.file("a.tribolog")) == before);
}

TEST_F(ArchiveCommands, WhatIsNoArchiveIsLeftAlone) {
  for (const std::string bytes : {"", "robot,joint\n", "SQLite format 3"}) {
    dataset_.scratch().write("a.tribolog", bytes);
    for (const std::string& command :
         {std::string("archive list"), std::string("archive verify"), identified, reported}) {
      const ProgramRun refused = run(command);
      EXPECT_EQ(refused.status, 6) << command << refused.err;
      EXPECT_EQ(refused.err.find("tribolog: error: a.tribolog: "), 0U) << refused.err;
    }
    EXPECT_EQ(read_text(dataset_.file("a.tribolog")), bytes);
    EXPECT_FALSE(std::filesystem::exists(dataset_.file("cal.json")));
  }
}

TEST_F(ArchiveCommands, OtherFilesAreNotAdded) {
  for (const std::string text :
       {"", "{", "[]", "{\"schema\": \"other\"}", "{\"schema\": \"tribolog-calibration-1\"}"}) {
    dataset_.scratch().write("cal.json", text);
    const ProgramRun refused = run("archive add cal.json");
    EXPECT_EQ(refused.status, 3) << text << refused.err;
    EXPECT_EQ(refused.err.find("tribolog: error: cal.json: "), 0U) << refused.err;
  }
  EXPECT_FALSE(std::filesystem::exists(dataset_.file("a.tribolog")));
}

TEST_F(ArchiveCommands, WhatIsRefusedStartsNoArchive) {
  const auto expect_refusal = [&](const std::string& command, int status) {
    const ProgramRun refused = run(command);
    EXPECT_EQ(refused.status, status) << command << refused.err;
    EXPECT_FALSE(std::filesystem::exists(dataset_.file("a.tribolog"))) << command;
  };
  for (const std::string& command : {identified, reported}) {
    expect_refusal(replaced(command, "--truth-runs 0", "--truth-runs many"), 2);
    expect_refusal(replaced(command, "dataset.toml", "absent.toml"), 3);
    expect_refusal(replaced(command, "-o ", "-o absent/"), 4);
  }
  EXPECT_EQ(run_shell("cd '" + dataset_.scratch().path() + "' && " + program + identified +
                      " --archive absent/a.tribolog")
                .status,
            4);
  EXPECT_FALSE(std::filesystem::exists(dataset_.file("cal.json")));
}

TEST_F(ArchiveCommands, HostileNamesAreShownAsText) {
  const std::string name = "../../x'; DROP TABLE calibration; --\xe2\x80\xae\\u001b[31m";
  dataset_.scratch().write("dataset.toml", replaced(small_manifest(), "test robot", name));
  ASSERT_EQ(run(identified).status, 0);
  const std::string kept = listed()[0]["robot"];
  EXPECT_EQ(kept.find("../../x'; DROP TABLE calibration; --"), 0U) << kept;
  const ProgramRun list = run("archive list");
  EXPECT_EQ(list.out.find('\x1b'), std::string::npos);
  EXPECT_EQ(list.out.find("\xe2\x80\xae"), std::string::npos);
  dataset_.scratch().write("dataset.toml",
                           replaced(small_manifest(), "test robot", std::string(10'000, 'R')));
  ASSERT_EQ(run(identified).status, 0);
  EXPECT_EQ(listed().size(), 2U);
  EXPECT_LT(run("archive list").out.size(), 1000U);
  EXPECT_EQ(run("archive verify").status, 0);
}

}  // namespace
}  // namespace tribolog::test::archive_commands_test
