// Every block of TOML in the pages of docs/ and in README.md that is one of a manifest is read as
// one: a whole manifest as it stands, a part of one with the tables before it that it does not
// have.

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/input_file.h"
#include "ingest/manifest/manifest_file.h"
#include "ingest/manifest/robot_joints.h"

namespace tribolog::documented_manifests_test {
namespace {

namespace fs = std::filesystem;

struct Block {
  std::string page;
  int line{};
  std::string text;
};

std::vector<Block> toml_blocks() {
  const fs::path source = TRIBOLOG_SOURCE_DIR;
  std::vector<fs::path> pages{source / "README.md"};
  for (const auto& entry : fs::directory_iterator(source / "docs")) {
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  }
  std::vector<Block> blocks;
  for (const fs::path& page : pages) {
    std::istringstream lines(read_file(page.string()));
    bool is_inside = false;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      if (line.starts_with("```")) {
        is_inside = line == "```toml";
        if (is_inside) blocks.push_back({page.filename().string(), number, ""});
      } else if (is_inside) {
        blocks.back().text += line + "\n";
      }
    }
  }
  return blocks;
}

bool is_of_scenario(const std::string& text) {
  return text.find("[friction]") != std::string::npos;
}

bool has(const std::string& text, const std::string& line) {
  return text.starts_with(line) || text.find("\n" + line) != std::string::npos;
}

/// A manifest that has the part: each table that is needed and not in it, before or behind it.
std::string completed(const std::string& part) {
  const bool is_current = part.find("unit = \"A\"") != std::string::npos;
  std::string before = "schema = \"tribolog-dataset-1\"\n";
  const auto add = [&](const std::string& table, const std::string& keys) {
    if (!has(part, table)) before += table + "\n" + keys;
  };
  add("[robot]", "name = \"robot\"\n");
  add("[joint]", "name = \"J1\"\ngear_ratio = 100\n");
  add("[effort]", is_current
                      ? "kind = \"motor_current\"\nside = \"motor\"\ntorque_constant_Nm_A = 0.1\n"
                      : "kind = \"motor_torque\"\nside = \"motor\"\n");
  std::string columns;
  for (const std::string& column :
       {std::string("time = { name = \"t\", unit = \"s\" }"),
        std::string("angle = { name = \"q\", unit = \"rad\" }"),
        "effort = { name = \"i\", unit = \"" + std::string(is_current ? "A" : "Nm") + "\" }"}) {
    const bool is_there = has(part, "[columns]") && has(part, column.substr(0, column.find(' ')));
    if (!is_there) columns += (columns.empty() ? "" : ", ") + column;
  }
  std::string behind;
  if (!has(part, "[columns]"))
    before.insert(before.find('\n') + 1, "columns = { " + columns + " }\n");
  if (!has(part, "[[recording]]")) {
    behind = "[[recording]]\nrole = \"rough_sweep\"\nfile = \"log.csv\"\n";
    if (has(part, "[columns]") && !columns.empty()) behind += "columns = { " + columns + " }\n";
  }
  return before + part + behind;
}

TEST(DocumentedManifests, WholeOnesAreRead) {
  int whole = 0;
  for (const Block& block : toml_blocks()) {
    if (!block.text.starts_with("schema = ")) continue;
    ++whole;
    std::vector<std::string> joints;
    EXPECT_NO_THROW(joints = ingest::manifest::joints_in_manifest(block.text, block.page))
        << block.line;
    if (joints.empty()) joints.emplace_back();
    for (const std::string& joint : joints) {
      EXPECT_NO_THROW(ingest::manifest::parse_manifest(block.text, block.page, joint))
          << block.page << ":" << block.line;
    }
  }
  EXPECT_GE(whole, 2);
}

TEST(DocumentedManifests, PartsAreReadWithWhatTheyLack) {
  int parts = 0;
  for (const Block& block : toml_blocks()) {
    if (block.text.starts_with("schema = ") || is_of_scenario(block.text)) continue;
    ++parts;
    const std::string text = completed(block.text);
    EXPECT_NO_THROW(ingest::manifest::parse_manifest(text, block.page, ""))
        << block.page << ":" << block.line << "\n"
        << text;
  }
  EXPECT_GE(parts, 8);
}

}  // namespace
}  // namespace tribolog::documented_manifests_test
