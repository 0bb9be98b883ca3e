// What init writes, identify reads: whatever characters the names of columns and files have. Names
// that no manifest can hold are refused.

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_dataset.h"

namespace tribolog::test::init_round_trip_test {
namespace {

/// A name of a few characters that mean something to TOML, CSV, JSON, a shell or a terminal.
std::string strange_name(std::mt19937& random) {
  static const std::vector<std::string> pieces{
      "\"", "\\", "'",   "#",      "#1",     "\n",      "\r",     "\t",  "=",    "[",
      "]",  "{",  "}",   ",",      ";",      ".",       "\x1b[m", "~",   "\x7f", "\xc2\x85",
      " ",  "$x", "`x`", "\u202E", "\u2028", "\\u0041", "\"\"\"", "'''", "é",    "関節"};
  std::string name;
  for (std::size_t k = 1 + random() % 4; k > 0; --k) name += pieces[random() % pieces.size()];
  return name;
}

std::string quoted_for_shell(const std::string& text) {
  std::string shell = "'";
  for (const char c : text) shell += c == '\'' ? "'\\''" : std::string(1, c);
  return shell + "'";
}

std::string quoted_for_csv(const std::string& text) {
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + "\"";
}

/// The small log with other names of its columns, as a text and as JSON.
std::string csv_with(const std::string& angle, const std::string& effort) {
  return replaced(small_log(), "t,q,tau",
                  "t_s," + quoted_for_csv(angle) + "," + quoted_for_csv(effort));
}

std::string json_with(const std::string& angle, const std::string& effort) {
  nlohmann::json columns;
  for (const std::string& name : {std::string("t_s"), angle, effort})
    columns[name] = nlohmann::json::array();
  const std::string log = small_log();
  for (std::size_t at = log.find('\n') + 1; at < log.size();) {
    const std::size_t end = std::min(log.find('\n', at), log.size());
    const std::string row = log.substr(at, end - at);
    const std::size_t first = row.find(',');
    const std::size_t second = row.find(',', first + 1);
    columns["t_s"].push_back(std::stod(row.substr(0, first)));
    columns[angle].push_back(std::stod(row.substr(first + 1, second - first - 1)));
    columns[effort].push_back(std::stod(row.substr(second + 1)));
    at = end + 1;
  }
  return columns.dump();
}

/// @return whether init wrote a manifest; then identify has to take it.
bool is_proposed(const ScratchDirectory& scratch, const std::string& file, const std::string& log,
                 const std::string& words) {
  const std::filesystem::path path(scratch.file(file));
  scratch.write(file, log);
  const std::string there = "cd '" + scratch.path() + "' && " + program;
  const ProgramRun init = run_shell(there + "init --force -o d.toml ./" + quoted_for_shell(file));
  EXPECT_TRUE(init.status == 0 || init.status == 3) << words << ": " << init.err;
  if (init.status == 0) {
    const ProgramRun run =
        run_shell(there + "identify --resamples 0 --truth-runs 0 d.toml -o c.json");
    EXPECT_EQ(run.status, 0) << words << ": " << run.err << read_text(scratch.file("d.toml"));
  }
  std::filesystem::remove(path);
  return init.status == 0;
}

TEST(InitRoundTrip, StrangeNamesOfColumnsAndFiles) {
  std::mt19937 random(3);
  std::size_t proposed = 0;
  for (int k = 0; k < 60; ++k) {
    const ScratchDirectory scratch;
    const std::string joint = strange_name(random);
    const bool is_json = k % 2 == 0;
    const std::string angle = joint + " q_rad";
    const std::string effort = joint + " tau_Nm";
    std::string file = "log" + strange_name(random) + (is_json ? ".json" : ".csv");
    if (is_proposed(scratch, file, is_json ? json_with(angle, effort) : csv_with(angle, effort),
                    "column " + angle + ", file " + file)) {
      ++proposed;
    }
  }
  EXPECT_GT(proposed, 30U) << "most of them are names that a manifest can hold";
}

TEST(InitRoundTrip, NamesThatAreNotUtf8AreRefused) {
  const ScratchDirectory scratch;
  const std::string there = "cd '" + scratch.path() + "' && " + program;
  const std::string log = replaced(small_log(), "t,q,tau", "t_s,q_rad,tau_Nm");
  for (const std::string& file : {std::string("log\xff.csv"), std::string("\xed\xa0\x80.csv")}) {
    scratch.write(file, log);
    const ProgramRun run = run_shell(there + "init -o d.toml './" + file + "'");
    EXPECT_EQ(run.status, 3) << run.err;
    EXPECT_NE(run.err.find("not UTF-8"), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(scratch.file("d.toml")));
  }
  scratch.write("-", log);
  EXPECT_TRUE(is_proposed(scratch, "-", log, "a file called -"));
  scratch.write("log.csv", log);
  for (const char* const robot : {" ", "\xff"}) {
    const ProgramRun run = run_shell(there + "init -o d2.toml log.csv --robot '" + robot + "'");
    EXPECT_EQ(run.status, 2) << run.err;
  }
}

}  // namespace
}  // namespace tribolog::test::init_round_trip_test
