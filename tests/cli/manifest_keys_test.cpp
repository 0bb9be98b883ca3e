// `tribolog manifest` describes every key that the reader of manifests accepts, and no other. What
// it accepts is asked of it: each table gets a key that is none, and the refusal lists those known
// there.

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/small_dataset.h"

namespace tribolog::test::manifest_keys_test {
namespace {

using Keys = std::set<std::string>;

/// Every table there is but one, and in each what makes the reader ask for all of its keys.
constexpr const char* whole_manifest = R"(schema = "tribolog-dataset-1"
[robot]
name = "robot"
description = "arm.urdf"
[joint]
name = "J1"
gear_ratio = 100
[effort]
kind = "motor_current"
side = "motor"
torque_constant_Nm_A = 0.1
[log]
decimal_comma = false
[columns]
[columns.time]
name = "t"
unit = "s"
[columns.time.plus]
name = "ns"
unit = "ns"
[columns.angle]
name = "q"
unit = "rad"
file = "q.csv"
[columns.speed]
name = "dq"
unit = "rad/s"
file = "q.csv"
[columns.effort]
name = "i"
unit = "A"
file = "q.csv"
[columns.temperature]
name = "c"
unit = "degC"
file = "q.csv"
[columns.bristle]
name = "z"
unit = "rad"
file = "q.csv"
[columns.bristle_rate]
name = "dz"
unit = "rad/s"
file = "q.csv"
[columns.rows]
name = "joint"
value = "J1"
[[recording]]
role = "rough_sweep"
file = "log.csv"
[recording.columns]
[[limit]]
quantity = "coulomb_joint_Nm"
max = 15
[uncertainty]
gravity_percent = 0.01
[uncertainty.id]
gravity = "map"
[effects]
lag_ms = 1
[known_gravity]
amplitude_Nm = 38
q_peak_deg = 90
[[known_load]]
amplitude_Nm = 1
angles = ["q2"]
[[other_joint]]
name = "J2"
gear_ratio = 100
[other_joint.angle]
name = "q2"
unit = "rad"
side = "motor"
[payload]
mass_kg = 5
[temperature]
degC = 21
[surrogate]
distance_m = 0.5
[reference]
[certificate]
number = "1"
[[certificate.instrument]]
name = "sensor"
[intervals]
seed = 1
)";
/// Of friction points alone, and nowhere else allowed.
constexpr const char* load_column = R"([columns.load]
name = "load"
unit = "Nm"
file = "q.csv"
)";

/// By the tables' names, "" of the top: the headings of `tribolog manifest` and the keys below.
std::map<std::string, Keys> described_keys() {
  const ProgramRun run = run_shell(program + "manifest");
  EXPECT_EQ(run.status, 0) << run.err;
  std::map<std::string, Keys> tables;
  std::vector<std::string> names;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("### ")) {
      names.clear();
      for (std::size_t at = line.find("`["); at != std::string::npos;
           at = line.find("`[", at + 1)) {
        const std::size_t begin = line.find_first_not_of("`[", at);
        names.push_back(line.substr(begin, line.find(']', begin) - begin));
      }
      if (names.empty()) names.emplace_back();
    } else if (line.starts_with("| `")) {
      for (const std::string& name : names)
        tables[name].insert(line.substr(3, line.find('`', 3) - 3));
    }
  }
  return tables;
}

/// @param table of the manifest, "" for the top.
std::string with_key_that_is_none(const std::string& table) {
  const std::string key = "\"%%%%%%%%%%%%%%%%%%%%\" = 1\n";
  if (table.empty()) return key + whole_manifest;
  std::string text = std::string(whole_manifest) + (table == "columns.load" ? load_column : "");
  for (const std::string& heading : {"[[" + table + "]]\n", "[" + table + "]\n"}) {
    const std::size_t at = text.find(heading);
    if (at != std::string::npos) return text.insert(at + heading.size(), key);
  }
  ADD_FAILURE() << "the whole manifest has no " << table;
  return text;
}

/// Those that the refusal of a key that is none lists.
Keys accepted_keys(const std::string& table) {
  const ScratchDirectory scratch;
  const std::string manifest = scratch.write("dataset.toml", with_key_that_is_none(table));
  const ProgramRun run =
      run_shell(program + "identify '" + manifest + "' -o '" + scratch.file("c.json") + "'");
  EXPECT_EQ(run.status, 3) << table;
  const std::size_t list = run.err.find("known here: ");
  EXPECT_NE(list, std::string::npos) << table << ": " << run.err;
  Keys keys;
  std::istringstream words(run.err.substr(std::min(list, run.err.size())));
  for (std::string word; std::getline(words, word, '\'');) {
    if (std::getline(words, word, '\'')) keys.insert(word);
  }
  return keys;
}

// A list of names in a message is cut off; of the effects' keys, which the reader and the
// description have from one catalogue, the first ones are there.
TEST(ManifestKeys, AreAllDescribedAndNoOther) {
  constexpr std::size_t most_listed = 24;
  const std::map<std::string, Keys> described = described_keys();
  EXPECT_GE(described.size(), 25U);
  for (const auto& [table, keys] : described) {
    const Keys first(
        keys.begin(),
        std::next(keys.begin(), static_cast<std::ptrdiff_t>(std::min(keys.size(), most_listed))));
    EXPECT_EQ(first, accepted_keys(table)) << table;
    EXPECT_TRUE(first.size() == keys.size() || table == "effects") << table;
  }
}

TEST(ManifestKeys, EveryTableOfAManifestIsDescribed) {
  const std::map<std::string, Keys> described = described_keys();
  const Keys columns{"time", "angle", "speed", "effort", "temperature", "load", "bristle", "rows"};
  std::istringstream lines(whole_manifest);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with('[')) continue;
    const std::size_t begin = line.find_first_not_of('[');
    EXPECT_EQ(described.count(line.substr(begin, line.find(']') - begin)), 1U) << line;
  }
  for (const std::string& column : columns) EXPECT_EQ(described.count("columns." + column), 1U);
}

TEST(ManifestKeys, OneTableIsShownAlone) {
  const ProgramRun columns = run_shell(program + "manifest columns");
  EXPECT_EQ(columns.status, 0);
  EXPECT_NE(columns.out.find("### `[columns.time.plus]`"), std::string::npos);
  EXPECT_EQ(columns.out.find("`[robot]`"), std::string::npos);
  const ProgramRun none = run_shell(program + "manifest effcts");
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("'effcts' is no table of a manifest; did you mean 'effects'?"),
            std::string::npos)
      << none.err;
}

}  // namespace
}  // namespace tribolog::test::manifest_keys_test
