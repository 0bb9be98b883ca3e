#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/temporary_directory.h"
#include "calibration/archived_calibration.h"
#include "exports/export_sample.h"
#include "exports/results/calibration_exports.h"
#include "support/run_program.h"

namespace tribolog::archive::export_tables_test {
namespace {

using test::export_sample;
using test::hostile_export_sample;
using test::quantity_of;
using test::run_shell;
using test::TemporaryDirectory;

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(GearSide, ConservesPowerAndEnergy) {
  // What the gear passes on is the same on both sides: torque times speed, 1/2 J w², 1/2 k q².
  const double n = 50;
  const calibration::Quantity torque{"coulomb_torque", "", "N·m", calibration::Verdict::usable,
                                     statistics::Estimate{2, 1, 3, {}}};
  const calibration::Quantity speed{"stribeck_speed", "", "rad/s", calibration::Verdict::usable,
                                    statistics::Estimate{7, 6, 8, {}}};
  EXPECT_NEAR(calibration::at_joint(torque, n).value * calibration::at_joint(speed, n).value, 2 * 7,
              1e-12);
  for (const char* const name : {"inertia", "viscous_coefficient", "bristle_damping"}) {
    const calibration::Quantity q{name, "", "", calibration::Verdict::usable,
                                  statistics::Estimate{0.3, 0.2, 0.4, {}}};
    const double joint_speed = calibration::at_joint(speed, n).value;
    EXPECT_NEAR(calibration::at_joint(q, n).value * joint_speed * joint_speed, 0.3 * 7 * 7, 1e-12)
        << name;
    EXPECT_NEAR(calibration::at_joint(q, n).high / calibration::at_joint(q, n).low, 2, 1e-12);
  }
}

TEST(CsvTable, HasEachQuantityOnEachSide) {
  const std::string csv = exports::results::csv_table(test::export_sample());
  EXPECT_NE(csv.find("\ncoulomb_torque,0.31,0.3,0.32,N·m,motor,usable,as archived,\n"),
            std::string::npos)
      << csv;
  EXPECT_NE(csv.find("\ncoulomb_torque,15.5,15,16,N·m,joint,usable,archived × n,\n"),
            std::string::npos);
  EXPECT_NE(csv.find("\nviscous_coefficient,5,"), std::string::npos);
  EXPECT_NE(csv.find("\nstribeck_speed,0.1,"), std::string::npos);
  EXPECT_EQ(count_of(csv, "\ncog_angle,"), 1U);
  EXPECT_NE(csv.find("\ncog_angle,-0.4,"), std::string::npos);
  EXPECT_NE(csv.find("# Gear ratio n = motor angle / joint angle = 50\n"), std::string::npos);
  EXPECT_EQ(csv.find("viscous_curve"), std::string::npos);
}

TEST(Tables, SayAmperesWhereTheTorqueConstantIsNotKnown) {
  const exports::results::ArchivedJoint joint = test::ampere_sample();
  const std::string csv = exports::results::csv_table(joint);
  for (const char* const row :
       {"\ncoulomb_torque,15.5,15,16,A,joint,", "\nbristle_stiffness,500,480,520,A/rad,motor,",
        "\nviscous_coefficient,5,", ",A·s/rad,joint,", ",A·s²/rad,joint,"}) {
    EXPECT_NE(csv.find(row), std::string::npos) << row << " in " << csv;
  }
  EXPECT_NE(csv.find("# Kept are SI units (rad, A, kg, s)"), std::string::npos) << csv;
  const std::string latex = exports::results::latex_table(joint);
  EXPECT_NE(latex.find("A\\ensuremath{\\cdot}s\\ensuremath{^2}/rad & motor"), std::string::npos)
      << latex;
  const std::string json = exports::results::json_document(joint);
  EXPECT_NE(json.find("friction_A"), std::string::npos) << json;
  for (const std::string& text : {csv, latex, json, exports::results::matlab_file(joint)}) {
    EXPECT_EQ(text.find("N·m"), std::string::npos) << text;
    EXPECT_EQ(text.find("N\\ensuremath{\\cdot}m"), std::string::npos) << text;
    EXPECT_EQ(text.find("kg·m"), std::string::npos) << text;
    EXPECT_EQ(text.find("friction_Nm"), std::string::npos) << text;
  }
}

TEST(CsvTable, MarksWhatIsNotUsable) {
  exports::results::ArchivedJoint joint = test::export_sample();
  test::quantity_of(joint, "inertia").verdict = calibration::Verdict::not_identifiable;
  test::quantity_of(joint, "inertia").estimate.reset();
  test::quantity_of(joint, "coulomb_torque").verdict = calibration::Verdict::doubtful;
  const std::string csv = exports::results::csv_table(joint);
  EXPECT_NE(csv.find("\ninertia,,,,kg·m²,motor,not_identifiable,"), std::string::npos);
  EXPECT_NE(csv.find(",joint,doubtful,archived × n,\n"), std::string::npos);
}

TEST(Tables, HaveFrictionAtSpeedsOnBothSides) {
  const exports::results::ArchivedJoint joint = test::export_sample();
  const std::string csv = exports::results::csv_table(joint);
  EXPECT_EQ(count_of(csv, "\nfriction_at_speed,"), 12U);
  for (const char* const row :
       {"\nfriction_at_speed,0.32,0.31,0.33,N·m,motor,usable,as archived,10\n",
        "\nfriction_at_speed,16,15.5,16.5,N·m,joint,usable,archived × n,0.2\n",
        "\nfriction_at_speed,31.25,25,37.5,N·m,joint,doubtful,archived × n,3.2\n"}) {
    EXPECT_NE(csv.find(row), std::string::npos) << row << csv;
  }

  const auto json = nlohmann::json::parse(exports::results::json_document(joint));
  const auto& friction = json["friction_at_speed"];
  EXPECT_EQ(friction["columns"][1], "friction_Nm");
  EXPECT_EQ(friction["motor"].size(), 6U);
  EXPECT_EQ(friction["joint"][5].dump(), R"([3.2,31.25,25.0,37.5,"doubtful"])");

  const std::string latex = exports::results::latex_table(joint);
  EXPECT_EQ(count_of(latex, "Friction at "), 10U) << latex;
  EXPECT_NE(latex.find("Friction at 10.0 rad/s & 0.320 & 0.310 & 0.330 & "), std::string::npos)
      << latex;
  EXPECT_NE(latex.find("Friction at 3.20 rad/s\\textsuperscript{*} & "), std::string::npos)
      << latex;
}

TEST(CsvTable, HoldsNoFormula) {
  exports::results::ArchivedJoint joint = test::hostile_export_sample();
  test::quantity_of(joint, "coulomb_torque").name = "=cmd|' /C calc'!A0,\"x\"";
  test::quantity_of(joint, "inertia").unit = "@SUM(1)";
  const test::TemporaryDirectory directory;
  const std::string file = directory.file("a.csv", exports::results::csv_table(joint));
  // As a spreadsheet splits it, by comma and by semicolon; numbers may begin with a sign.
  const std::string script = directory.file("a.py", R"(
import csv, re, sys
for separator in ',;\t':
    for row in csv.reader(open(sys.argv[1], newline='', encoding='utf-8'), delimiter=separator):
        for cell in row:
            text = cell.strip()
            if text[:1] in ('=', '+', '-', '@') and not re.fullmatch(r'-?[0-9.e+-]+.*', text):
                sys.exit('formula: ' + cell)
table = [r for r in csv.reader(open(sys.argv[1], newline='', encoding='utf-8'))
         if not r[0].startswith('#')]
assert all(len(r) == 9 for r in table), table
)");
  const auto run = test::run_shell("/usr/bin/env python3 '" + script + "' '" + file + "'");
  EXPECT_EQ(run.status, 0) << run.err << exports::results::csv_table(joint);
}

TEST(JsonDocument, SaysWhatTheOthersSay) {
  const auto json = nlohmann::json::parse(exports::results::json_document(test::export_sample()));
  EXPECT_EQ(json["schema"], "tribolog-export-1");
  EXPECT_EQ(json["gear_ratio"], 50);
  EXPECT_EQ(json["quantities"].size(), 16U);
  const auto& curve = json["friction_curve"];
  ASSERT_EQ(curve["motor"].size(), 4U);
  // At rest the slowest run's; both directions of 10 and of 100 rad/s in one row each.
  EXPECT_EQ(curve["motor"][0][0], 0);
  EXPECT_NEAR(curve["motor"][0][1].get<double>(), 0.33, 1e-12);
  EXPECT_NEAR(curve["motor"][2][0].get<double>(), 100, 1e-9);
  EXPECT_NEAR(curve["motor"][2][1].get<double>(), 0.51, 1e-12);
  EXPECT_NEAR(curve["joint"][3][0].get<double>(), 4, 1e-12);
  EXPECT_NEAR(curve["joint"][3][1].get<double>(), 35, 1e-12);
}

TEST(JsonDocument, FollowsItsSchema) {
  if (test::run_shell("python3 -c 'import jsonschema'").status != 0) {
    GTEST_SKIP() << "python3-jsonschema is not installed";
  }
  const test::TemporaryDirectory directory;
  const std::string script = directory.file("a.py", R"(
import json, sys, jsonschema
schema = json.load(open(sys.argv[1]))
# Before version 4 it knows drafts up to 7, which lack prefixItems alone of what is in this schema.
newest = getattr(jsonschema, 'Draft202012Validator', jsonschema.Draft7Validator)
newest.check_schema(schema)
newest(schema).validate(json.load(open(sys.argv[2])))
)");
  exports::results::ArchivedJoint bare = test::export_sample();
  bare.calibration.clear();
  bare.quantities.resize(1);
  bare.quantities[0].estimate.reset();
  bare.entry.facts.of.serial.clear();
  for (const exports::results::ArchivedJoint& joint :
       {test::export_sample(), test::hostile_export_sample(), bare}) {
    const std::string file = directory.file("a.json", exports::results::json_document(joint));
    const auto run =
        test::run_shell("python3 '" + script +
                        "' '" TRIBOLOG_SOURCE_DIR "/templates/export.schema.json' '" + file + "'");
    EXPECT_EQ(run.status, 0) << run.err;
  }
}

TEST(LatexTable, IsRoundedByItsIntervals) {
  const std::string latex = exports::results::latex_table(test::export_sample());
  EXPECT_NE(latex.find("Coulomb torque & 0.310 & 0.300 & 0.320 & N\\ensuremath{\\cdot}m & motor & "
                       "usable \\\\\n"),
            std::string::npos)
      << latex;
  EXPECT_NE(latex.find("Coulomb torque & 15.50 & 15.00 & 16.00 &"), std::string::npos);
}

TEST(LatexTable, StaysInItsRows) {
  const std::string latex = exports::results::latex_table(test::hostile_export_sample());
  EXPECT_EQ(count_of(latex, "\\begin{tabular}"), 1U);
  std::size_t begin = latex.find("\\begin{tabular}");
  const std::string table = latex.substr(begin);
  EXPECT_EQ(count_of(table, "\\end{tabular}"), 1U);
  EXPECT_EQ(table.find("\\write"), std::string::npos);
  EXPECT_EQ(count_of(table, " \\\\\n"), 27U);  // the heading, 16 rows and 10 of friction
  EXPECT_EQ(count_of(table, " & "), 6U * 27U);
  for (std::size_t at = 0; at < begin; at = latex.find('\n', at) + 1) EXPECT_EQ(latex[at], '%');
}

TEST(LatexTable, Compiles) {
  if (test::run_shell("command -v pdflatex").status != 0) {
    GTEST_SKIP() << "pdflatex (texlive-latex-base) is not installed";
  }
  const test::TemporaryDirectory directory;
  for (const exports::results::ArchivedJoint& joint :
       {test::export_sample(), test::hostile_export_sample()}) {
    (void)directory.file("table.tex", exports::results::latex_table(joint));
    (void)directory.file("main.tex",
                         "\\documentclass{article}\n\\begin{document}\n\\input{table}\n"
                         "\\end{document}\n");
    const auto run =
        test::run_shell("cd '" + directory.path() +
                        "' && pdflatex -interaction=nonstopmode -halt-on-error main.tex");
    EXPECT_EQ(run.status, 0) << run.out;
    EXPECT_NE(run.out.find("Output written on main.pdf (1 page"), std::string::npos) << run.out;
  }
}

}  // namespace
}  // namespace tribolog::archive::export_tables_test
