// The numbered list of what users complain about, each case run through the real program.

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <ostream>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/input_cases/case_log.h"
#include "cli/input_cases/input_case.h"
#include "cli/small_dataset.h"

namespace tribolog::test {

InputCase refused(const std::string& id, const std::string& name, const std::string& log,
                  const std::string& says) {
  return {id, name, log, case_manifest(), 3, says};
}

InputCase accepted(const std::string& id, const std::string& name, const std::string& log,
                   const std::string& notes) {
  return {id, name, log, case_manifest(), 0, notes, Numbers::same};
}

InputCase with_manifest(InputCase one, const std::string& manifest) {
  one.manifest = manifest;
  return one;
}

void PrintTo(const InputCase& one, std::ostream* out) { *out << one.id << " " << one.name; }

namespace {

using nlohmann::json;

constexpr int last_case = 48;

std::vector<InputCase> all_cases() {
  std::vector<InputCase> all;
  for (const auto& some : {file_cases(), dialect_cases(), number_cases(), time_cases(),
                           content_cases(), manifest_cases()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  std::stable_sort(all.begin(), all.end(), [](const InputCase& a, const InputCase& b) {
    return std::stoi(a.id) < std::stoi(b.id);
  });
  return all;
}

const std::string old_numbers = "last year's numbers";

/// Runs identify beside its files, so that messages name them as the user does.
ProgramRun run(const SmallDataset& dataset, const InputCase& one) {
  dataset.scratch().write("c.json", old_numbers);
  if (one.prepare) one.prepare(dataset.scratch());
  return run_shell("cd '" + dataset.scratch().path() + "' && env " + one.environment + " " +
                   program + "--quiet identify dataset.toml -o c.json --truth-runs 0");
}

/// What is said, as the program prefixes it.
std::string expected_error(const InputCase& one) {
  if (one.status != 0) return "tribolog: error: " + one.says + "\n";
  std::string lines;
  for (std::size_t start = 0; start < one.says.size();) {
    const std::size_t end = std::min(one.says.find('\n', start), one.says.size());
    lines += "tribolog: note: " + one.says.substr(start, end - start) + "\n";
    start = end + 1;
  }
  return lines;
}

void expect_said(const InputCase& one, const std::string& said) {
  const std::string expected = expected_error(one);
  const std::size_t dots = expected.find("...\n");
  if (one.status == 0 || dots == std::string::npos) {
    EXPECT_EQ(said, expected);
    return;
  }
  EXPECT_EQ(said.substr(0, dots), expected.substr(0, dots));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

/// Of a calibration, without what tells one input from another.
json results(const std::string& text) {
  json all = json::parse(text);
  for (const char* key : {"inputs", "notes", "provenance", "robot", "conversions"}) all.erase(key);
  return all;
}

const json& clean_results() {
  static const json clean = [] {
    const SmallDataset dataset(case_manifest(), case_log());
    const ProgramRun of_clean = run(dataset, accepted("0", "Clean", ""));
    EXPECT_EQ(of_clean.status, 0) << of_clean.err;
    return results(read_text(dataset.file("c.json")));
  }();
  return clean;
}

void expect_numbers(const InputCase& one, const json& calibration) {
  const json found = results(calibration.dump());
  if (one.numbers == Numbers::same) {
    EXPECT_TRUE(found == clean_results()) << json::diff(clean_results(), found).dump();
  } else if (one.numbers == Numbers::close) {
    const auto mass_kg = [](const json& c) {
      return c.at("surrogate_masses").at(0).at("mass_kg").at("estimate").get<double>();
    };
    const auto peak_rad = [](const json& c) {
      return c.at("cog").at("rough").at("q_peak_rad").at("estimate").get<double>();
    };
    EXPECT_NEAR(mass_kg(found) / mass_kg(clean_results()), 1, 1e-6);
    EXPECT_NEAR(peak_rad(found), peak_rad(clean_results()), 1e-6);
  }
}

/// "4: cannot be used (skip_bad_rows)" of the log, and that every row is accounted for.
std::string left_out(const json& calibration) {
  const json& log = calibration.at("inputs").at(1);
  std::string reasons;
  std::size_t rows = log.at("rows_used").get<std::size_t>();
  for (const json& skipped : log.at("skipped")) {
    const auto count = skipped.at("rows").get<std::size_t>();
    rows += count;
    reasons += (reasons.empty() ? "" : "; ") + std::to_string(count) + ": " +
               skipped.at("reason").get<std::string>();
  }
  EXPECT_EQ(rows, log.at("rows_read").get<std::size_t>());
  return reasons;
}

/// Whether a check or a verdict says it.
bool finds(const json& calibration, const std::string& line) {
  for (const json& check : calibration.at("data_checks")) {
    const std::string said = "check " + check.at("state").get<std::string>() + ": " +
                             check.at("title").get<std::string>() + ": " +
                             check.at("found").get<std::string>();
    if (said == line) return true;
  }
  return false;
}

class InputCases : public testing::TestWithParam<InputCase> {};

TEST_P(InputCases, SayWordForWordWhatIsWrong) {
  const InputCase& one = GetParam();
  if (run_shell("env " + one.environment + " test -x " + program).status != 0) {
    GTEST_SKIP() << "the program cannot be run with " << one.environment;
  }
  const SmallDataset dataset(one.manifest, one.log);
  const ProgramRun done = run(dataset, one);
  EXPECT_EQ(done.status, one.status) << done.err;
  expect_said(one, done.err);
  EXPECT_EQ(done.out, "");
  const std::string written = read_text(dataset.file("c.json"));
  if (done.status != 0) {
    EXPECT_EQ(written, old_numbers);
    const std::set<std::string> known{"c.json", "dataset.toml", "log.csv"};
    for (const auto& entry : std::filesystem::directory_iterator(dataset.scratch().path())) {
      EXPECT_EQ(known.count(entry.path().filename().string()), 1U) << entry.path();
    }
    return;
  }
  const json calibration = json::parse(written);
  expect_numbers(one, calibration);
  EXPECT_EQ(left_out(calibration), one.left_out);
  if (one.finds.empty()) return;
  EXPECT_TRUE(finds(calibration, one.finds)) << calibration.at("data_checks");
}

std::string test_name(const testing::TestParamInfo<InputCase>& test) {
  const bool is_one_digit = std::stoi(test.param.id) < 10;  // two digits, so that lists sort
  return (is_one_digit ? "0" : "") + test.param.id + "_" + test.param.name;
}

INSTANTIATE_TEST_SUITE_P(List, InputCases, testing::ValuesIn(all_cases()), test_name);

TEST(InputCaseList, IsComplete) {
  std::set<int> there(cases_elsewhere.begin(), cases_elsewhere.end());
  for (const InputCase& one : all_cases()) there.insert(std::stoi(one.id));
  for (int number = 1; number <= last_case; ++number) {
    EXPECT_EQ(there.count(number), 1U) << "case " << number << " has no test";
  }
}

}  // namespace
}  // namespace tribolog::test
