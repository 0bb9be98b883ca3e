// 43 to 46: names that others wrote, in outputs and in the names of outputs.

#include <cstddef>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "cli/input_cases/case_log.h"
#include "cli/small_dataset.h"

namespace tribolog::test::shown_text_test {
namespace {

const std::string without_runs = " --truth-runs 0 ";

std::string report_of(const std::string& robot, const std::string& log_name) {
  const SmallDataset dataset(replaced(case_manifest("test robot", robot), "log.csv", log_name), "");
  const std::string plain = log_name.find('\\') == std::string::npos ? log_name : "a\u202Evsc.b";
  dataset.scratch().write(plain, case_log());
  const ProgramRun run = dataset.run("--quiet report --no-figures" + without_runs, "r.html");
  EXPECT_EQ(run.status, 0) << run.err;
  return read_text(dataset.file("r.html"));
}

std::size_t count(const std::string& text, const std::string& piece) {
  std::size_t times = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) {
    ++times;
  }
  return times;
}

TEST(InputCase44, MarkupInNamesIsShownAndNeverRun) {
  const std::string plain = report_of("x", "log.csv");
  const std::string attacked = report_of(
      "\\\"><img src=x onerror=alert(1)></script><script>alert(2)</script>{{TITLE}}]]>--></style>",
      "<script>alert(3)<\u200b.csv");
  for (const char* tag :
       {"<script", "</script", "<img", "<style", "</style", "<!--", "<p", "<td"}) {
    EXPECT_EQ(count(attacked, tag), count(plain, tag)) << tag;
  }
  EXPECT_GT(count(attacked, "&lt;img src=x onerror=alert(1)&gt;"), 0U);
  EXPECT_GT(count(attacked, "&lt;script&gt;alert(3)&lt;[U+200B].csv"), 0U);
  EXPECT_GT(count(attacked, "{{TITLE}}"), 0U);
}

TEST(InputCase44, TextThatTurnsOrHidesOthersIsMadeVisible) {
  const std::string page = report_of("abc\\u202Efed\\u2028\\u200B\\u001B[31m", "a\\u202Evsc.b");
  const std::string body = page.substr(0, page.find("<script type"));
  EXPECT_EQ(count(body, "\u202E"), 0U);
  EXPECT_EQ(count(body, "\x1b"), 0U);
  EXPECT_GT(count(body, "abc[U+202E]fed[U+2028][U+200B]\\x1b[31m"), 0U);
  EXPECT_GT(count(body, "a[U+202E]vsc.b"), 0U);
}

TEST(InputCase45, ExportedLogsHoldNumbersAndNoTextOfTheUser) {
  const SmallDataset dataset;
  std::string scenario =
      read_text(std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/scenario.toml");
  const std::string formula = "=HYPERLINK(0)\\t@x\\r+1";
  scenario = replaced(scenario, "the paper's joint, no noise", formula);
  scenario = replaced(scenario, "FANUC AM100iB", formula);
  dataset.scratch().write(
      "am100ib.toml", read_text(std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/am100ib.toml"));
  const std::string path = dataset.scratch().write("scenario.toml", scenario);
  const ProgramRun run =
      run_shell(program + "--quiet simulate '" + path + "' -o '" + dataset.file("out") + "'");
  ASSERT_EQ(run.status, 0) << run.err;
  int logs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(dataset.file("out"))) {
    if (entry.path().extension() != ".csv") continue;
    ++logs;
    const std::string csv = read_text(entry.path().string());
    const std::size_t header = csv.find('\n');
    EXPECT_EQ(csv.substr(0, header).find_first_not_of("abcdefghijklmnopqrstuvwxyzNRT_,"),
              std::string::npos)
        << csv.substr(0, header);
    EXPECT_EQ(csv.find_first_not_of("0123456789.,e-+\n", header), std::string::npos)
        << entry.path();
  }
  EXPECT_GT(logs, 0);
}

TEST(InputCase46, NamesOfRobotsNameNoFiles) {
  const SmallDataset dataset(
      replaced(case_manifest("test robot", "../../etc/x"), "\"J1\"", "\"../CON\""), case_log());
  ASSERT_EQ(dataset.run("--quiet report --no-figures" + without_runs, "r.html").status, 0);
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(dataset.scratch().path())) {
    names.insert(entry.path().filename().string());
  }
  EXPECT_EQ(names,
            (std::set<std::string>{"dataset.toml", "log.csv", "r.calibration.json", "r.html"}));
}

TEST(InputCase43, OutputsThatAreInputsAreRefusedAlsoThroughALink) {
  const SmallDataset dataset(case_manifest(), case_log());
  std::filesystem::create_symlink("log.csv", dataset.file("link.json"));
  const auto in = [&](const std::string& output) {
    const ProgramRun run = run_shell("cd '" + dataset.scratch().path() + "' && " + program +
                                     "--quiet identify dataset.toml -o '" + output + "'");
    return std::to_string(run.status) + " " + run.err;
  };
  const std::string overwritten = ": is also an input; it would be overwritten\n";
  EXPECT_EQ(in("dataset.toml"), "2 tribolog: error: dataset.toml" + overwritten);
  EXPECT_EQ(in("log.csv"), "2 tribolog: error: log.csv" + overwritten);
  EXPECT_EQ(in("link.json"), "2 tribolog: error: link.json" + overwritten);
  EXPECT_EQ(in("."), "4 tribolog: error: .: cannot write: is a directory\n");
  EXPECT_EQ(read_text(dataset.file("log.csv")), case_log());
}

TEST(InputCase43, ANameWithALineEndIsWrittenAndToldOnOneLine) {
  const SmallDataset dataset(case_manifest(), case_log());
  const ProgramRun run = dataset.run("identify" + without_runs, "a\nb \"c\".json");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("a\\x0ab \"c\".json\n"), std::string::npos) << run.out;
  EXPECT_TRUE(std::filesystem::exists(dataset.file("a\nb \"c\".json")));
}

}  // namespace
}  // namespace tribolog::test::shown_text_test
