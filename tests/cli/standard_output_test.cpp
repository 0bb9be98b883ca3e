// Standard output as the place of an output, and as one that takes nothing.

#include <cstddef>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "cli/small_dataset.h"

namespace tribolog::test::standard_output_test {
namespace {

namespace fs = std::filesystem;

class StandardOutput : public testing::Test {
 protected:
  [[nodiscard]] ProgramRun in_folder(const std::string& command) const {
    return run_shell("cd '" + dataset_.scratch().path() + "' && export SOURCE_DATE_EPOCH=1 && " +
                     command);
  }
  [[nodiscard]] ProgramRun run(const std::string& command) const {
    return in_folder(program + command);
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    return read_text(dataset_.file(name));
  }

  SmallDataset dataset_;
  const std::string few_ = " --truth-runs 0";
};

TEST_F(StandardOutput, GetsExactlyTheBytesOfTheFile) {
  ASSERT_EQ(run("identify dataset.toml -o first.json --archive a.tribolog" + few_).status, 0);
  for (const std::string& command :
       {"identify dataset.toml" + few_ + " -o ", std::string("init log.csv -o "),
        std::string("inspect log.csv --json "), std::string("models --compare -o "),
        std::string("archive trend --archive a.tribolog -o "),
        std::string("archive fleet --archive a.tribolog -o "),
        "report dataset.toml --no-figures --calibration c.json" + few_ + " -o "}) {
    ASSERT_EQ(run(command + "a").status, 0) << command;
    std::string written = text("a");
    const std::string named = command.substr(
        command.rfind("-o") == std::string::npos ? command.rfind("--json") : command.rfind("-o"));
    // The command line stands in what is written.
    for (std::size_t at = 0; (at = written.find(named + "a", at)) != std::string::npos;) {
      written[at + named.size()] = '-';
    }
    const ProgramRun printed = run(command + "-");
    EXPECT_EQ(printed.status, 0) << printed.err;
    EXPECT_TRUE(printed.out == written) << command << printed.out.substr(0, 400);
    // Into a file that is open already: the shell's, which is not replaced.
    const ProgramRun behind =
        in_folder("{ echo before; " + program + command + "/dev/stdout; echo behind; } > b; cat b");
    EXPECT_TRUE(behind.out.starts_with("before\n") && behind.out.ends_with("\nbehind\n"))
        << command << behind.out.substr(0, 400);
    std::filesystem::remove(dataset_.file("a"));
  }
  EXPECT_FALSE(fs::exists(dataset_.file("-")));
  EXPECT_TRUE(fs::is_symlink("/dev/stdout"));
}

TEST_F(StandardOutput, HasTheLinesOfTheConsoleBesideIt) {
  const ProgramRun made = run("identify dataset.toml -o -" + few_);
  EXPECT_EQ(made.status, 0);
  EXPECT_EQ(made.out.front(), '{');
  EXPECT_NE(made.err.find("\ncalibration: -\n"), std::string::npos) << made.err;
  EXPECT_EQ(run("-q identify dataset.toml -o -" + few_).err, "");
}

TEST_F(StandardOutput, TakesOneFileAlone) {
  for (const std::string command :
       {"report dataset.toml -o -", "report dataset.toml -o /dev/null",
        "report dataset.toml -o - --calibration /dev/stdout",
        "simulate '" TRIBOLOG_SOURCE_DIR "/examples/paper/scenario.toml' -o -",
        "figures dataset.toml -o -", "study -o - --json -", "archive backup -o -",
        "archive trend --json -o -", "archive report 0 -o - --calibration -"}) {
    const ProgramRun refused = run(command + " --archive a.tribolog");
    const ProgramRun plain = run(command);
    const ProgramRun& said = command.starts_with("archive") ? refused : plain;
    EXPECT_EQ(said.status, 2) << command << said.err;
    EXPECT_EQ(said.out, "") << command;
  }
  EXPECT_FALSE(fs::exists(dataset_.file("-")));
}

TEST_F(StandardOutput, ThatTakesNothingIsStatus4) {
  const std::string failed = "error: standard output: cannot write: ";
  for (const char* command : {"--help", "models", "inspect log.csv", "init log.csv -o -"}) {
    const ProgramRun full = in_folder(program + command + " > /dev/full");
    EXPECT_EQ(full.status, 4) << command;
    EXPECT_NE(full.err.find(failed + "No space left on device\n"), std::string::npos) << full.err;
    const ProgramRun closed = in_folder(program + command + " >&-");
    EXPECT_EQ(closed.status, 4) << command;
    EXPECT_NE((closed.err + closed.out).find("it is closed\n"), std::string::npos) << closed.err;
  }
}

TEST_F(StandardOutput, ThatFailsKeepsTheFilesAndSaysSo) {
  const ProgramRun full =
      in_folder(program + "identify dataset.toml -o cal.json" + few_ + " > /dev/full");
  EXPECT_EQ(full.status, 4);
  EXPECT_NE(full.err.find("No space left on device; kept: cal.json\n"), std::string::npos)
      << full.err;
  EXPECT_TRUE(fs::exists(dataset_.file("cal.json")));
}

TEST_F(StandardOutput, WhoseReaderGoesAwayIsNoFailure) {
  const ProgramRun run = in_folder("{ " + program + "models; echo status $? >&2; } | true");
  EXPECT_EQ(run.err, "status 0\n");
}

TEST_F(StandardOutput, ClosedStreamsGetNoFilesThatAreOpenedLater) {
  const ProgramRun run = in_folder(program + "identify dataset.toml -o cal.json" + few_ +
                                   " <&- >&- 2>&-; echo $? > status");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(text("status"), "4\n");
  EXPECT_EQ(text("cal.json").front(), '{');
  EXPECT_EQ(text("log.csv"), small_log());
}

}  // namespace
}  // namespace tribolog::test::standard_output_test
