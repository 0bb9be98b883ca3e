// `archive export` and `archive fleet` through the program.

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_dataset.h"

namespace tribolog::test::archive_export_test {
namespace {

/// A small dataset, identified and archived with a made-up report.
class ArchivedDataset {
 public:
  explicit ArchivedDataset(const std::string& robot = "test robot")
      : dataset_(replaced(small_manifest(), "test robot", robot)) {
    const ProgramRun identified = dataset_.run("identify", "cal.json");
    EXPECT_EQ(identified.status, 0) << identified.err;
    (void)dataset_.scratch().write("report.html", "<html>its report</html>");
    const ProgramRun added =
        run("add '" + file("cal.json") + "' --report '" + file("report.html") + "'");
    EXPECT_EQ(added.status, 0) << added.err;
    const auto list = nlohmann::json::parse(run("list --json").out);
    id = list["calibrations"][0]["id"].get<std::string>();
  }
  [[nodiscard]] std::string file(const std::string& name) const { return dataset_.file(name); }
  std::string write(const std::string& name, const std::string& text) const {
    return dataset_.scratch().write(name, text);
  }
  [[nodiscard]] ProgramRun run(const std::string& command) const {
    return run_shell(program + "archive " + command + " --archive '" + file("a.tribolog") + "'");
  }
  std::string id;

 private:
  SmallDataset dataset_;
};

// The user's own model: one joint's numbers, all else as it is; refused, the output stays.
TEST(Apply, ChangesTheJointsNumbersAlone) {
  const ArchivedDataset archived;
  const std::string head = "<robot name=\"r\">\n <joint name=\"elbow\" type=\"revolute\">";
  const std::string foot = "</joint>\n</robot>\n";
  (void)archived.write("arm.urdf", head + "<dynamics damping=\"9\"/>" + foot);
  const std::string out = archived.write("new.urdf", "old");
  const auto apply = [&](const std::string& options) {
    return run_shell(program + "apply '" + archived.file("cal.json") + "' '" +
                     archived.file("arm.urdf") + "' -o '" + out + "' " + options);
  };
  const ProgramRun unnamed = apply("");
  EXPECT_EQ(unnamed.status, 3) << unnamed.err;
  EXPECT_NE(unnamed.err.find("has no joint of this name"), std::string::npos) << unnamed.err;
  EXPECT_EQ(apply("--joint elbow --range 1e5:2e5").status, 2);
  EXPECT_EQ(apply("--joint elbow --range 3").status, 2);
  EXPECT_EQ(read_text(out), "old");
  const ProgramRun done = apply("--joint elbow --doubtful-too");
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("URDF, joint elbow:\n  damping: 9 -> "), std::string::npos) << done.out;
  const std::string made = read_text(out);
  EXPECT_TRUE(made.starts_with(head + "<dynamics damping=\"")) << made;
  EXPECT_TRUE(made.ends_with("\"/>" + foot)) << made;
  EXPECT_NE(made.find("\" friction=\""), std::string::npos) << made;
}

// Without an archive: from the calibration, or from the report that carries it.
TEST(ExportOfAFile, IsThatOfTheArchive) {
  const ArchivedDataset archived;
  const ProgramRun kept = archived.run("export " + archived.id.substr(0, 10) + " --format csv");
  const ProgramRun own =
      run_shell(program + "export '" + archived.file("cal.json") + "' --format csv");
  EXPECT_EQ(own.status, 0) << own.err;
  EXPECT_EQ(own.out, replaced(kept.out, ", from its archive.", "."));
  const ProgramRun certificate =
      archived.run("export " + archived.id.substr(0, 10) + " --format dcc");
  EXPECT_EQ(certificate.status, 0) << certificate.err;
  EXPECT_NE(certificate.out.find("<dcc:uniqueIdentifier>tribolog-" + archived.id.substr(0, 12)),
            std::string::npos);
  EXPECT_EQ(run_shell(program + "export '" + archived.file("cal.json") + "' --format dcc").out,
            certificate.out);
  EXPECT_EQ(
      run_shell(program + "export '" + archived.file("report.html") + "' --format csv").status, 3);
  EXPECT_EQ(run_shell(program + "export none.json --format csv").status, 3);
  EXPECT_EQ(run_shell(program + "export '" + archived.file("cal.json") + "'").status, 2);
  const std::string same = "' --format csv -o '" + archived.file("cal.json") + "'";
  EXPECT_NE(run_shell(program + "export '" + archived.file("cal.json") + same).status, 0)
      << "its own input";
}

// What would be one with another in trend and fleet is said when it is archived.
TEST(ArchiveAdd, SaysWhatIsHardToTellApart) {
  const auto told = [](const std::string& robot, const std::string& more) {
    const SmallDataset dataset(
        replaced(small_manifest(), "name = \"test robot\"", "name = \"" + robot + "\"\n" + more));
    EXPECT_EQ(dataset.run("identify", "cal.json").status, 0);
    return run_shell(program + "archive add '" + dataset.file("cal.json") + "' --archive '" +
                     dataset.file("a.tribolog") + "'")
        .err;
  };
  EXPECT_NE(told("unnamed robot", "").find("archived without the robot's name"), std::string::npos);
  EXPECT_NE(told("R1", "").find("archived without a serial number"), std::string::npos);
  EXPECT_EQ(told("R1", "serial = \"S1\"\n").find("note:"), std::string::npos);
  EXPECT_NE(told("R1", "serial = \"S1\"\nmeasured_on = \"2999-01-01\"\n").find("in the future"),
            std::string::npos);
}

// Every calibration in one file: a row for each quantity, or a line for each calibration.
TEST(ArchiveExport, WritesAWholeArchive) {
  const ArchivedDataset archived;
  ASSERT_EQ(archived.run("add '" + archived.file("cal.json") + "' --again").status, 0);
  const auto calibration = nlohmann::json::parse(read_text(archived.file("cal.json")));
  const std::size_t quantities = calibration["verdict"]["quantities"].size();
  const ProgramRun csv = archived.run("export --all --format csv");
  EXPECT_EQ(csv.status, 0) << csv.err;
  std::size_t rows = 0;
  std::size_t of_friction = 0;  // at the speeds at which calibrations are compared
  std::istringstream table(csv.out);
  for (std::string row; std::getline(table, row);) {
    ++(row.find(",friction_at_") == std::string::npos ? rows : of_friction);
  }
  EXPECT_EQ(rows, 1 + 2 * quantities);
  EXPECT_GT(of_friction, 0U);
  EXPECT_EQ(csv.out.rfind("id,revision,robot,", 0), 0U);
  EXPECT_NE(csv.out.find("\n" + archived.id + ",1,test robot,"), std::string::npos) << csv.out;
  const ProgramRun json = archived.run("export --all --format json");
  EXPECT_EQ(json.status, 0) << json.err;
  std::istringstream lines(json.out);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const auto one = nlohmann::json::parse(line);
    EXPECT_EQ(one["schema"], "tribolog-export-1");
    EXPECT_EQ(one["robot"], "test robot");
  }
  EXPECT_EQ(count, 2);
  EXPECT_EQ(archived.run("export --all --format csv --robot nobody").out,
            csv.out.substr(0, csv.out.find('\n') + 1));
  EXPECT_EQ(archived.run("export --all --format urdf").status, 2);
  EXPECT_EQ(archived.run("export --all --format dcc").status, 2);
  EXPECT_EQ(archived.run("export --format csv").status, 2);
  EXPECT_EQ(archived.run("export --all --format csv " + archived.id.substr(0, 10)).status, 2);
}

TEST(ArchiveExport, WritesTablesOfWhatWasIdentified) {
  const ArchivedDataset archived;
  const std::string id = archived.id.substr(0, 10);
  const ProgramRun csv = archived.run("export " + id + " --format csv");
  EXPECT_EQ(csv.status, 0) << csv.err;
  EXPECT_NE(csv.out.find("# Robot: test robot\n"), std::string::npos);
  EXPECT_NE(csv.out.find("# Calibration: " + archived.id), std::string::npos);
  EXPECT_NE(csv.out.find("\nbreak_away_torque,,,,N·m,joint,not_identifiable,archived × n,\n"),
            std::string::npos)
      << csv.out;
  const auto calibration = nlohmann::json::parse(read_text(archived.file("cal.json")));
  const ProgramRun json =
      archived.run("export " + id + " --format json -o '" + archived.file("out.json") + "'");
  EXPECT_EQ(json.status, 0) << json.err;
  const auto exported = nlohmann::json::parse(read_text(archived.file("out.json")));
  ASSERT_EQ(exported["quantities"][0]["quantity"], "cog_angle");
  // Those of the verdict; the gear ratio is 100.
  const auto& judged = calibration["verdict"]["quantities"];
  EXPECT_EQ(exported["quantities"][0]["value"], judged[0]["estimate"]["estimate"]);
  EXPECT_NEAR(exported["quantities"][0]["value"].get<double>(), 0.2, 1e-6);
  for (const auto& q : exported["quantities"]) {
    if (q["quantity"] != "coulomb_torque") continue;
    for (const auto& one : judged) {
      if (one["key"] != "coulomb_torque") continue;
      const double factor = q["side"] == "joint" ? 100 : 1;
      const double value = one["estimate"]["estimate"].get<double>();
      EXPECT_NEAR(q["value"].get<double>(), factor * value, 1e-9 * factor * value);
    }
  }
  EXPECT_EQ(archived.run("export " + id + " --format latex").status, 0);
}

TEST(ArchiveExport, RefusesInOneLine) {
  const ArchivedDataset archived;
  const std::string id = archived.id.substr(0, 10);
  const auto refusal = [&](const std::string& options) {
    const ProgramRun run = archived.run("export " + options);
    EXPECT_EQ(run.status, 2) << options << run.out;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    return run.err;
  };
  EXPECT_NE(refusal(id + " --format modelica").find("Viscous curve is not identifiable"),
            std::string::npos);
  EXPECT_NE(refusal(id + " --format modelica --doubtful-too").find("no friction curve"),
            std::string::npos);
  (void)refusal(id + " --format xls");
  (void)refusal(id);
  (void)refusal(id + " --format urdf --side motor");
  (void)refusal(id + " --format csv --arm-inertia 1");
  (void)refusal("0000000000 --format csv");
  EXPECT_EQ(archived.run("export " + id + " --format csv -o /no/such/directory/a.csv").status, 4);
}

TEST(ArchiveFleet, LinksToReportsThatItWrites) {
  const ArchivedDataset archived("</title><script>x</script>");
  const ProgramRun run = archived.run("fleet -o '" + archived.file("fleet.html") + "' --reports '" +
                                      archived.file("my reports") + "'");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out.find("fleet sheet: "), 0U) << run.out;
  const std::string page = read_text(archived.file("fleet.html"));
  EXPECT_NE(page.find("href=\"my%20reports/" + archived.id + ".html\""), std::string::npos);
  EXPECT_EQ(page.find("<script>"), page.rfind("<script>"));  // its own
  EXPECT_EQ(read_text(archived.file("my reports/" + archived.id + ".html")),
            "<html>its report</html>");
  // The page tells nothing about the machine.
  EXPECT_EQ(page.find(archived.file("")), std::string::npos);
}

TEST(ArchiveFleet, LinksToTrendsThatItWritesOrFinds) {
  const ArchivedDataset archived("a/b");
  const std::string page = archived.file("fleet.html");
  const std::string trends = archived.file("trends");
  EXPECT_EQ(archived.run("fleet -o '" + page + "'").status, 0);
  EXPECT_EQ(read_text(page).find("class=\"trend\""), std::string::npos);
  const ProgramRun run = archived.run("fleet -o '" + page + "' --trends '" + trends + "'");
  EXPECT_EQ(run.status, 0) << run.err;
  std::vector<std::string> files;
  for (const auto& file : std::filesystem::directory_iterator(trends)) {
    files.push_back(file.path().filename().string());
  }
  ASSERT_EQ(files.size(), 1U);
  // A robot's name that no file can have.
  EXPECT_EQ(files[0].rfind("a_b.", 0), 0U) << files[0];
  EXPECT_NE(read_text(trends + "/" + files[0]).find("<title>Trend: "), std::string::npos);
  const std::string link = "<a class=\"trend\" href=\"trends/" + files[0] + "\">";
  EXPECT_NE(read_text(page).find(link), std::string::npos);
  EXPECT_EQ(archived.run("fleet -o '" + page + "'").status, 0);
  EXPECT_NE(read_text(page).find(link), std::string::npos) << "of an earlier call";
}

TEST(ArchiveFleet, IsJsonForScripts) {
  const ArchivedDataset archived;
  const ProgramRun run = archived.run("fleet --json");
  EXPECT_EQ(run.status, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["robots"][0]["joints"][0]["id"], archived.id);
  EXPECT_EQ(archived.run("fleet").status, 2);
  EXPECT_EQ(archived.run("fleet --json --reports x").status, 2);
  EXPECT_EQ(archived.run("fleet --json --trends x").status, 2);
  EXPECT_EQ(archived.run("fleet -o /no/such/directory/fleet.html").status, 4);
}

}  // namespace
}  // namespace tribolog::test::archive_export_test
