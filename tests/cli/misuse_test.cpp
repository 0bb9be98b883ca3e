// Typing errors, misuses, and words in any order: what the program answers to each.

#include <filesystem>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "cli/misuse_calls.h"
#include "cli/small_dataset.h"

namespace tribolog::test::misuse_test {
namespace {

/// dataset.toml and log.csv, and what the program makes of them and of the examples.
class FilesOfEachKind {
 public:
  FilesOfEachKind() {
    namespace fs = std::filesystem;
    const std::string examples = TRIBOLOG_SOURCE_DIR "/examples/";
    fs::copy(examples + "paper/scenario_noise.toml", file("scenario.toml"));
    fs::copy(examples + "paper/am100ib.toml", file("am100ib.toml"));
    fs::copy(examples + "plan/joint.toml", file("joint.toml"));
    make("report dataset.toml -o report.html --no-figures --truth-runs 0 --archive=archive.db");
    make("archive fleet --archive archive.db -o fleet.html");
    make("plan joint.toml -o plan --runs 0");
    make("simulate scenario.toml -o simulation");
    fs::copy(file("plan/plan.json"), file("plan.json"));
    fs::copy(file("simulation/truth.json"), file("truth.json"));
    fs::copy(file("report.html"), file("renamed.csv"));
  }

  /// In the folder, with the user's own archive there.
  [[nodiscard]] ProgramRun run(const std::string& arguments) const {
    const std::string& here = dataset_.scratch().path();
    return run_shell("cd '" + here + "' && XDG_DATA_HOME='" + here + "/home' " + program +
                     arguments);
  }
  [[nodiscard]] std::string file(const std::string& name) const { return dataset_.file(name); }

 private:
  void make(const std::string& arguments) const {
    const ProgramRun made = run(arguments);
    EXPECT_EQ(made.status, 0) << arguments << ": " << made.err;
  }

  SmallDataset dataset_;
};

/// CLI11 writes a range as "1 to 64", from 2.5 on as "[1 - 64]".
std::string with_ranges_in_words(const std::string& text) {
  static const std::regex range(R"(in range \[(\S+) - (\S+)\])");
  return std::regex_replace(text, range, "in range $1 to $2");
}

TEST(Misuse, IsAnsweredWithWhatWasMeant) {
  const FilesOfEachKind files;
  for (const Call& call : calls()) {
    const ProgramRun run = files.run(call.arguments);
    EXPECT_EQ(run.status, call.status) << call.arguments << "\n" << run.err;
    const std::string refusal = std::string("tribolog: error: ") + call.answer + "\n";
    if (call.status == 0) {
      EXPECT_NE(run.out.find(call.answer), std::string::npos) << call.arguments << "\n" << run.out;
    } else {
      EXPECT_TRUE(with_ranges_in_words(run.err).ends_with(refusal)) << call.arguments << "\n"
                                                                    << run.err << refusal;
    }
  }
}

TEST(Misuse, WhatWasRefusedWroteNothing) {
  const FilesOfEachKind files;
  for (const Call& call : calls()) {
    if (call.status != 0) static_cast<void>(files.run(call.arguments));
  }
  for (const char* file : {"r.html", "i.toml", "c.json", "c3.json", "f", "s", "p", "p.html",
                           "s.html", "report.pdf", "x.html", "a.html"}) {
    EXPECT_FALSE(std::filesystem::exists(files.file(file))) << file;
  }
}

TEST(WordOrder, AManifestBehindArchiveIsNoArchive) {
  const FilesOfEachKind files;
  const std::string manifest = read_text(files.file("dataset.toml"));
  ASSERT_EQ(files.run("identify --archive dataset.toml --truth-runs 0 -o c.json").status, 0);
  EXPECT_EQ(read_text(files.file("dataset.toml")), manifest);
  EXPECT_TRUE(std::filesystem::exists(files.file("home/tribolog/archive.tribolog")));
  EXPECT_EQ(files.run("identify dataset.toml --archive own.db --truth-runs 0 -o d.json").status, 0);
  EXPECT_TRUE(std::filesystem::exists(files.file("own.db")));
  EXPECT_EQ(files.run("identify --archive own.db dataset.toml --truth-runs 0 -o e.json").status, 0);
}

TEST(WordOrder, IsKeptInTheProvenance) {
  const FilesOfEachKind files;
  const std::string typed = "identify --archive dataset.toml --seed 2 --truth-runs 0 -o c.json";
  ASSERT_EQ(files.run(typed).status, 0);
  EXPECT_NE(read_text(files.file("c.json")).find("tribolog " + typed + "\""), std::string::npos);
}

TEST(WordOrder, OptionsWithListsLeaveTheLogAlone) {
  const FilesOfEachKind files;
  ASSERT_EQ(files.run("init --column angle=q --gear-ratio 101 log.csv -o before.toml").status, 0);
  ASSERT_EQ(files.run("init log.csv -o behind.toml --gear-ratio 101 --column angle=q").status, 0);
  const std::string manifest = read_text(files.file("before.toml"));
  EXPECT_NE(manifest.find("gear_ratio = 101"), std::string::npos) << manifest;
  EXPECT_EQ(manifest, read_text(files.file("behind.toml")));
  ASSERT_EQ(files.run("init --gear-ratio 101:1 log.csv -o colon.toml --column angle=q").status, 0);
  EXPECT_EQ(manifest, read_text(files.file("colon.toml")));
}

}  // namespace
}  // namespace tribolog::test::misuse_test
