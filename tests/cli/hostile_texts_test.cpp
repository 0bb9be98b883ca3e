// Names from outside that a terminal would obey, or that hide: in every text of a manifest, a log,
// a scenario, an archive and the command line, for every command that prints. What is printed is
// UTF-8 in which nothing hides, and JSON is JSON.

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sqlite3.h>

#include "base/utf8.h"
#include "cli/small_dataset.h"
#include "support/breadth.h"

namespace tribolog::test::hostile_texts_test {
namespace {

/// As text: ESC, BEL, DEL, C1, bidi, line separators, tags. No line feed: a log's name ends there.
const std::string hostile =
    "a\x1b[31m\x07\x7f\xc2\x85\xc2\x9b\u202E\u2066\u061C\u2028\u2029\uFEFFz";

/// The same as TOML writes it, with a line feed and a carriage return.
const std::string hostile_in_toml =
    "a\\u001b[31m\\u0007\\u007f\\u0085\\u009b\\u202E\\u2066\\u061C\\u2028\\u2029\\uFEFF\\n\\rz";

/// What stands in an output that no reader would see; empty: nothing.
std::string hidden_in(const std::string& output) {
  std::string found;
  for (std::string_view rest = output; !rest.empty();) {
    const Utf8Character c = first_utf8_character(rest);
    const std::string_view bytes = rest.substr(0, std::max<std::size_t>(c.bytes, 1));
    const bool is_line_end = c.code_point == '\n';
    if (c.bytes == 0) {
      found += fmt::format(" byte {:02x}", static_cast<unsigned char>(rest.front()));
    } else if (!is_line_end &&
               (is_control_character(c.code_point) || is_hidden_character(c.code_point))) {
      found += fmt::format(" U+{:04X}", static_cast<unsigned>(c.code_point));
    }
    rest.remove_prefix(bytes.size());
  }
  return found;
}

void expect_clean(const ProgramRun& run, const std::string& command) {
  EXPECT_EQ(hidden_in(run.out), "") << command;
  EXPECT_EQ(hidden_in(run.err), "") << command;
  for (const int status : {0, 1, 2, 3, 4, 5, 6}) {
    if (run.status == status) return;
  }
  ADD_FAILURE() << command << ": status " << run.status << ": " << run.err;
}

std::string quoted(const std::string& text) {
  std::string shell = "'";
  for (const char c : text) shell += c == '\'' ? "'\\''" : std::string(1, c);
  return shell + "'";
}

class HostileTexts : public testing::Test {
 protected:
  HostileTexts() {
    scratch_.write(hostile + ".csv", replaced(small_log(), "t,q,tau", "t,q," + hostile));
    std::string manifest =
        replaced(small_manifest(), "test robot\"",
                 hostile_in_toml + "\"\nserial = \"" + hostile_in_toml + "\"\noperator = \"" +
                     hostile_in_toml + "\"\nnote = \"" + hostile_in_toml + "\"\nmeasured_on = \"" +
                     hostile_in_toml + "\"");
    manifest = replaced(manifest, "\"J1\"", "\"" + hostile_in_toml + "\"");
    const std::string in_one_line = replaced(hostile_in_toml, "\\n\\r", "");
    manifest = replaced(manifest, "\"tau\"", "\"" + in_one_line + "\"");
    manifest =
        replaced(manifest, "log.csv\"", in_one_line + ".csv\"\nnote = \"" + hostile_in_toml + "\"");
    manifest += "[payload]\nmass_kg = 5\nnote = \"" + hostile_in_toml + "\"\n";
    manifest += "[certificate]\n";
    for (const char* const key :
         {"number", "replaces", "laboratory", "laboratory_address", "customer", "customer_address",
          "place", "received_on", "procedure", "conditions", "adjustment", "decision_rule",
          "responsible"}) {
      manifest += std::string(key) + " = \"" + hostile_in_toml + "\"\n";
    }
    manifest += "[[certificate.instrument]]\n";
    for (const char* const key : {"name", "identification", "traceability", "used_for"}) {
      manifest += std::string(key) + " = \"" + hostile_in_toml + "\"\n";
    }
    scratch_.write("dataset.toml", manifest);
  }
  [[nodiscard]] ProgramRun run(const std::string& arguments) const {
    // With no archive of the user's own.
    ProgramRun ran = run_shell("cd '" + scratch_.path() + "' && HOME='" + scratch_.path() +
                               "' XDG_DATA_HOME= " + program + arguments);
    expect_clean(ran, arguments);
    return ran;
  }
  /// That it is read, and that its text hides nothing.
  void expect_json(const std::string& text) const {
    EXPECT_EQ(hidden_in(text), "");
    EXPECT_TRUE(nlohmann::json::accept(text)) << text.substr(0, 300);
  }
  void archive_it() const {
    ASSERT_EQ(run("identify dataset.toml -o c.json --truth-runs 0").status, 0);
    ASSERT_EQ(run("archive add c.json --archive a.tribolog").status, 0);
  }
  [[nodiscard]] std::string id() const {
    const auto list = nlohmann::json::parse(run("archive list --json --archive a.tribolog").out);
    return list["calibrations"][0]["id"].get<std::string>();
  }

  ScratchDirectory scratch_;
};

TEST_F(HostileTexts, OfAManifestAndALogAreShownByNoCommandAsTheyAre) {
  const std::string log = quoted(hostile + ".csv");
  (void)run("inspect " + log);
  (void)run("inspect " + log + " --json s.json");
  expect_json(read_text(scratch_.file("s.json")));
  EXPECT_EQ(run("init " + log + " -o init.toml").status, 0);
  EXPECT_EQ(hidden_in(read_text(scratch_.file("init.toml"))), "");
  EXPECT_EQ(run("report dataset.toml -o r.html --no-figures --truth-runs 0").status, 0);
  EXPECT_EQ(hidden_in(read_text(scratch_.file("r.html"))), "");
  expect_json(read_text(scratch_.file("r.calibration.json")));
  EXPECT_EQ(run("show r.html").status, 0);
  expect_json(run("show r.html --json").out);
}

TEST_F(HostileTexts, OfAnArchiveAreShownByNoCommandAsTheyAre) {
  archive_it();
  const std::string with = " --archive a.tribolog ";
  const std::string one = id();
  ASSERT_EQ(run("archive add c.json --again" + with).status, 0);
  ASSERT_EQ(run("review " + one + " --approve --reviewer " + quoted(hostile) + " --note " +
                quoted(hostile) + with)
                .status,
            0);
  (void)run("archive list" + with);
  (void)run("archive show " + one + with);
  expect_json(run("archive show " + one + " --json" + with).out);
  expect_json(run("archive list --json" + with).out);
  for (const char* const format :
       {"csv", "latex", "json", "dcc", "urdf", "sdf", "mjcf", "modelica", "ros2"}) {
    (void)run("archive export " + one + " --doubtful-too --format " + format + with);
    (void)run(std::string("export c.json --doubtful-too --format ") + format);
  }
  (void)run("archive trend" + with);
  expect_json(run("archive trend --json" + with).out);
  (void)run("archive fleet -o fleet.html" + with);
  EXPECT_EQ(hidden_in(read_text(scratch_.file("fleet.html"))), "");
  (void)run("archive verify --head " + quoted(hostile) + with);
  expect_json(run("archive verify --json" + with).out);
  (void)run("archive remove " + one + with);
}

TEST_F(HostileTexts, ThatWereAlteredInAnArchiveAreRefusedOrEscaped) {
  TRIBOLOG_EACH_NIGHT();
  archive_it();
  const std::string one = id();
  const std::string kept = read_text(scratch_.file("a.tribolog"));
  sqlite3* database = nullptr;
  for (const std::string& text :
       {hostile + "\n\r", std::string("\xff\xfe"), std::string("\xc0\xaf"),
        std::string("\xed\xa0\x80"), std::string("a\0b", 3)}) {
    for (const char* const column :
         {"calibration.robot", "calibration.id", "calibration.measured_at", "calibration.verdict",
          "calibration.tool_version", "calibration.digest", "quantity.words", "quantity.unit",
          "quantity.name", "input.name", "document.name", "document.kind", "document.sha256",
          "event.what", "event.id", "event.chain"}) {
      scratch_.write("a.tribolog", kept);
      ASSERT_EQ(sqlite3_open(scratch_.file("a.tribolog").c_str(), &database), SQLITE_OK);
      std::string hex;
      for (const char c : text) hex += fmt::format("{:02x}", static_cast<unsigned char>(c));
      const std::string place(column);
      const std::size_t point = place.find('.');
      const std::string statement =
          fmt::format("PRAGMA ignore_check_constraints=1; UPDATE {} SET {} = CAST(x'{}' AS TEXT)",
                      place.substr(0, point), place.substr(point + 1), hex);
      (void)sqlite3_exec(database, statement.c_str(), nullptr, nullptr, nullptr);
      sqlite3_close(database);
      const std::string with = " --archive a.tribolog";
      EXPECT_EQ(run("archive verify" + with).status, 6) << statement;
      (void)run("archive list" + with);
      (void)run("archive show " + one + with);
      const std::string json = run("archive show " + one + " --json" + with).out;
      if (!json.empty()) expect_json(json);
    }
  }
}

TEST_F(HostileTexts, OfTheCommandLineAreEscapedInItsErrors) {
  for (const std::string& text :
       {hostile + "\n\r", std::string("\xff"), std::string("\xed\xa0\x80")}) {
    const std::string name = quoted(text);
    for (const std::string& arguments : {name,
                                         "--" + name,
                                         "report " + name + " -o r.html",
                                         "report dataset.toml -o " + name + "/r.html",
                                         "report dataset.toml --fail-on " + name + " -o r.html",
                                         "figures dataset.toml -o o --style " + name,
                                         "archive list --archive " + name,
                                         "archive list --robot " + name,
                                         "archive show " + name,
                                         "archive export 0000 --format " + name,
                                         "inspect " + name,
                                         "init " + name + " -o i.toml",
                                         "init dataset.toml -o i.toml --robot " + name,
                                         "simulate " + name + " -o o",
                                         "plan " + name + " -o o",
                                         "study " + name + " -o o",
                                         "show " + name,
                                         "review " + name + " --approve --reviewer x",
                                         "models --" + name,
                                         "identify dataset.toml -o c.json --seed " + name,
                                         "archive trend --baseline-from " + name,
                                         "archive list --wait " + name}) {
      const ProgramRun ran = run(arguments);
      EXPECT_NE(ran.status, 0) << arguments;
      EXPECT_NE(ran.err.find("tribolog: error: "), std::string::npos) << arguments;
    }
  }
}

}  // namespace
}  // namespace tribolog::test::hostile_texts_test
