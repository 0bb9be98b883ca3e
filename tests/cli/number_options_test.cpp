// Numbers on the command line: what none can be is refused by the option's name, status 2.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/small_dataset.h"

namespace tribolog::test::number_options_test {
namespace {

struct NumberOption {
  const char* command;
  const char* option;
  bool is_whole;
};

const std::vector<NumberOption> all_options{
    {"identify dataset.toml -o c.json", "--seed", true},
    {"identify dataset.toml -o c.json", "--resamples", true},
    {"identify dataset.toml -o c.json", "--truth-runs", true},
    {"identify dataset.toml -o c.json --archive a", "--wait", false},
    {"report dataset.toml -o r.html", "--seed", true},
    {"report dataset.toml -o r.html", "--resamples", true},
    {"report dataset.toml -o r.html", "--truth-runs", true},
    {"report dataset.toml -o r.html", "--processes", true},
    {"report dataset.toml -o r.html --archive a", "--wait", false},
    {"figures dataset.toml -o f", "--truth-runs", true},
    {"figures dataset.toml -o f", "--processes", true},
    {"inspect log.csv", "--gear-ratio", false},
    {"inspect log.csv", "--torque-constant", false},
    {"inspect log.csv", "--header-line", true},
    {"init log.csv -o i.toml", "--gear-ratio", false},
    {"init log.csv -o i.toml", "--torque-constant", false},
    {"simulate s.toml -o o", "--seed", true},
    {"plan j.toml -o o", "--seed", true},
    {"plan j.toml -o o", "--runs", true},
    {"plan j.toml -o o", "--threads", true},
    {"study -o s.html", "--seed", true},
    {"study -o s.html", "--runs", true},
    {"study -o s.html", "--threads", true},
    {"models --compare -o m.html", "--processes", true},
    {"paper -o p.html", "--processes", true},
    {"review 00000000 --approve --reviewer x --archive a", "--wait", false},
    {"archive list --archive a", "--wait", false},
    {"archive verify --archive a", "--wait", false},
    {"archive diff 0000 1111 --archive a", "--allowed-kelvin", false},
    {"archive trend --archive a", "--baseline", true},
    {"archive trend --archive a", "--limit", false},
    {"archive export 0000 --format mjcf --archive a", "--arm-inertia", false},
};

TEST(NumberOptions, RefuseWhatIsNoNumberByTheirName) {
  const SmallDataset dataset;
  const std::string there = "cd '" + dataset.scratch().path() + "' && " + program;
  for (const NumberOption& one : all_options) {
    std::vector<std::string> values{"nan",   "inf", "-inf", "-5", "-1e-320",
                                    "1e400", "",    "x",    "0x", "5 x"};
    if (one.is_whole) values.insert(values.end(), {"1.5", "99999999999999999999999"});
    for (const std::string& value : values) {
      const std::string command = std::string(one.command) + " " + one.option + "='" + value + "'";
      const ProgramRun run = run_shell(there + command);
      EXPECT_EQ(run.status, 2) << command << ": " << run.err;
      EXPECT_NE(run.err.find(one.option), std::string::npos) << command << ": " << run.err;
    }
  }
}

}  // namespace
}  // namespace tribolog::test::number_options_test
