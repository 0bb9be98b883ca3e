// What init writes, identify reads: whatever characters the names of columns and files have. Names
// that no manifest can hold are refused.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <fmt/core.h>
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
    const ProgramRun run = run_shell(there + "identify --truth-runs 0 d.toml -o c.json");
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

/// Rows of numbers, as many loggers write them.
std::string rows_of(std::size_t count, const std::function<std::vector<double>(double)>& row,
                    double interval_s) {
  std::string text;
  for (std::size_t k = 0; k < count; ++k) {
    const std::vector<double> values = row(interval_s * static_cast<double>(k));
    for (std::size_t c = 0; c < values.size(); ++c) {
      text += fmt::format("{}{:.6f}", c > 0 ? " " : "", values[c]);
    }
    text += "\n";
  }
  return text;
}

TEST(InitRoundTrip, ThreeJointsWithoutNamesAreToldByTheirPlaces) {
  const ScratchDirectory scratch;
  constexpr double rate_rad_s = 2 * M_PI * 0.1;
  scratch.write("rows.txt",
                rows_of(
                    4000,
                    [](double t) {
                      const double q = std::sin(rate_rad_s * t);
                      const double v = rate_rad_s * std::cos(rate_rad_s * t);
                      const double current = 2 * std::cos(q) + 0.8 * std::tanh(v / 0.01) + 0.3 * v;
                      return std::vector<double>{t, 0.1, q, 0.3, 0, v, 0, 0.5, current, 0.7};
                    },
                    0.01));
  const std::string there = "cd '" + scratch.path() + "' && " + program;
  const ProgramRun init =
      run_shell(there +
                "init rows.txt --column effort='#8' --effort-kind motor_current "
                "--torque-constant 8.4 -o d.toml");
  ASSERT_EQ(init.status, 0) << init.err;
  const std::string manifest = read_text(scratch.file("d.toml"));
  for (const char* line : {"name = \"2\"", "angle = { name = \"#3\"", "speed = { name = \"#6\"",
                           "effort = { name = \"#9\""}) {
    EXPECT_NE(manifest.find(line), std::string::npos) << line << "\n" << manifest;
  }
  const ProgramRun run = run_shell(there + "identify --truth-runs 0 d.toml -o c.json");
  ASSERT_EQ(run.status, 0) << run.err;
  const auto found = nlohmann::json::parse(read_text(scratch.file("c.json")));
  EXPECT_NEAR(found["cog"]["q_peak_rad"]["estimate"].get<double>(), 0, 0.02);
  const ProgramRun other = run_shell(there + "init rows.txt --joint 3 --force -o d.toml");
  EXPECT_NE(other.out.find("joint '3': no motion"), std::string::npos) << other.out << other.err;
}

TEST(InitRoundTrip, RampsOfABareServoThatSpinAwayNeedNoEdit) {
  const ScratchDirectory scratch;
  constexpr double step_rad = 2 * M_PI / 10000;
  for (const char* name : {"a.txt", "b.txt"}) {
    scratch.write(name,
                  rows_of(
                      3000,
                      [](double t) {
                        const double q = 0.003 * t + (t > 1.6 ? 15 * (t - 1.6) * (t - 1.6) : 0.0);
                        return std::vector<double>{step_rad * std::round(q / step_rad), 0.0167 * t};
                      },
                      0.001));
  }
  const std::string there = "cd '" + scratch.path() + "' && " + program;
  const ProgramRun init =
      run_shell(there +
                "init a.txt b.txt --rate 1000 --column angle='#1' --column "
                "effort='#2' --effort-kind motor_torque --no-gravity -o d.toml");
  ASSERT_EQ(init.status, 0) << init.err;
  const std::string manifest = read_text(scratch.file("d.toml"));
  EXPECT_NE(manifest.find("unit = \"rad\", confirmed = false }  # unit guessed, the log states "
                          "none: its steps"),
            std::string::npos)
      << manifest;
  EXPECT_NE(manifest.find("gravity = \"none\""), std::string::npos);
  const ProgramRun run = run_shell(there + "identify --truth-runs 0 d.toml -o c.json");
  ASSERT_EQ(run.status, 0) << run.err;
  const auto found = nlohmann::json::parse(read_text(scratch.file("c.json")));
  ASSERT_EQ(found["break_away"]["ramps"].size(), 2U);
  for (const auto& ramp : found["break_away"]["ramps"]) {
    EXPECT_TRUE(ramp["broke_away"].get<bool>());
    EXPECT_NEAR(ramp["torque_Nm"].get<double>(), 0.0167 * 1.6, 0.002);
  }
}

TEST(InitRoundTrip, ANumberThatNoJointHasIsNamedAndItsRowLeftOut) {
  const ScratchDirectory scratch;
  scratch.write(
      "log.csv", "t_s,q_rad,tau_Nm\n" + [] {
        std::string text;
        for (int i = 0; i < 4000; ++i) {
          const double t = 0.01 * i;
          const double q = std::sin(0.6 * t);
          const double torque = 2 * std::cos(q) + (std::cos(0.6 * t) > 0 ? 0.5 : -0.5);
          text += fmt::format("{:.2f},{:.6f},{}\n", t, q,
                              i == 2000 ? "1e297" : fmt::format("{}", torque));
        }
        return text;
      }());
  const std::string there = "cd '" + scratch.path() + "' && " + program;
  const ProgramRun inspect = run_shell(there + "inspect log.csv");
  EXPECT_NE(inspect.out.find("numbers that no joint has (1, such as"), std::string::npos)
      << inspect.out;
  ASSERT_EQ(run_shell(there + "init log.csv -o d.toml").status, 0);
  const ProgramRun run = run_shell(there + "identify --truth-runs 0 d.toml -o c.json");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("1 rows skipped: a number that no joint has"), std::string::npos)
      << run.out;
}

}  // namespace
}  // namespace tribolog::test::init_round_trip_test
