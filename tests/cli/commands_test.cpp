#include <cstddef>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "cli/small_dataset.h"

namespace tribolog::test::commands_test {
namespace {

TEST(Commands, VersionNamesWhatItStandsOn) {
  const ProgramRun run = run_shell(program + "--version");
  EXPECT_EQ(run.status, 0) << run.err;
  for (const char* part : {"tribolog ", "Eigen ", "VTK 9.", "FreeType", "DejaVuSans.ttf"}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << " in\n" << run.out;
  }
  const ProgramRun verbose = run_shell(program + "--version --verbose");
  EXPECT_EQ(verbose.status, 0) << verbose.err;
  for (const char* part : {"VTK 9.", "Mesa", "llvmpipe"}) {
    EXPECT_NE(verbose.out.find(part), std::string::npos) << part << " in\n" << verbose.out;
  }
}

TEST(Commands, HelpTeaches) {
  const ProgramRun all = run_shell(program + "--help");
  EXPECT_EQ(all.status, 0);
  for (const char* part : {"simulate", "identify", "figures", "report", "Exit status"}) {
    EXPECT_NE(all.out.find(part), std::string::npos) << part;
  }
  for (const char* command : {"report", "identify"}) {
    const ProgramRun help = run_shell(program + command + " --help");
    EXPECT_EQ(help.status, 0);
    for (const char* key : {"gear_ratio = 100", "[uncertainty]", "[[limit]]", "[[known_load]]",
                            "[known_gravity]", "\"none\"", "tribolog manifest"}) {
      EXPECT_NE(help.out.find(key), std::string::npos) << command << " --help: " << key;
    }
  }
}

TEST(Commands, ModelsAreListedAsScenariosNameThem) {
  const ProgramRun run = run_shell(program + "models");
  EXPECT_EQ(run.status, 0);
  for (const char* model :
       {"dahl", "haessig_bristles", "reset_integrator", "hess_soom", "bliman_sorine", "armstrong",
        "lugre", "leuven", "elasto_plastic", "gms", "stribeck", "threshold_speed", "waiboer"}) {
    EXPECT_NE(run.out.find(std::string("\n  ") + model + " "), std::string::npos) << model;
  }
  for (const char* key : {"attraction_Nm_s", "break_away_deflection_rad", "rise_time_s", "elements",
                          "threshold_rad_s            wth > 0 [0.0001]"}) {
    EXPECT_NE(run.out.find(std::string("\n      ") + key), std::string::npos) << key;
  }
}

TEST(Commands, ModelsAreComparedInOnePage) {
  const SmallDataset directory;
  const ProgramRun run =
      run_shell(program + "models --compare -o '" + directory.file("models.html") + "'");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err.find("note:"), std::string::npos) << run.err;
  const std::string page = read_text(directory.file("models.html"));
  for (const char* id : {"static-curve-dahl", "presliding-loop-gms", "lag-loop-hess-soom",
                         "break-away-lugre", "break-away-haessig-bristles"}) {
    EXPECT_NE(page.find(std::string("id=\"") + id), std::string::npos) << id;
  }
  EXPECT_EQ(page.find("is missing"), std::string::npos);
  EXPECT_EQ(run_shell(program + "models --compare").status, 2);
  EXPECT_EQ(run_shell(program + "models -o '" + directory.file("models.html") + "'").status, 2);
}

TEST(Commands, ThePaperIsRegeneratedAndEveryCheckHolds) {
  const SmallDataset directory;
  const ProgramRun run = run_shell(program + "paper -o '" + directory.file("paper.html") + "'");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err.find("note:"), std::string::npos) << run.err;
  for (const char* line : {"figures: 22 of 22 regenerated, no check fails in 22",
                           "tables: 2 of 2 regenerated, no check fails in 2",
                           "equations: 14 of 14 regenerated, no check fails in 14",
                           "print against computation: 28 of 28 hold"}) {
    EXPECT_NE(run.out.find(line), std::string::npos) << line << " in\n" << run.out;
  }
  const std::string page = read_text(directory.file("paper.html"));
  EXPECT_NE(page.find("WHAT THE PAPER PRINTS IS FOUND AGAIN"), std::string::npos);
  EXPECT_EQ(page.find("is missing"), std::string::npos);
  EXPECT_EQ(page.find("class=\"fails\""), std::string::npos);
  EXPECT_LT(page.size(), 10U << 20);
  EXPECT_EQ(run_shell(program + "paper").status, 2);
  EXPECT_EQ(run_shell(program + "paper -o /no/such/directory/paper.html").status, 4);
}

TEST(Commands, ThePapersClaimsArePutToAnotherJoint) {
  const SmallDataset directory;
  const std::string page = directory.file("claims.html");
  const ProgramRun run = run_shell(
      program + "paper '" TRIBOLOG_SOURCE_DIR "/examples/paper/scenario_noise.toml' -o '" + page +
      "'");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("here: holds (B, off by"), std::string::npos) << run.out;
  const std::string text = read_text(page);
  EXPECT_NE(text.find("claims hold on this joint"), std::string::npos);
  EXPECT_NE(text.find("\"schema\":\"tribolog-claims-1\""), std::string::npos);
  EXPECT_EQ(text.find("is missing"), std::string::npos);
  EXPECT_EQ(text.find("://"), std::string::npos);
  EXPECT_EQ(run_shell(program + "paper none.toml -o '" + page + "'").status, 3);
  EXPECT_EQ(read_text(page), text);
}

TEST(Commands, AStudyIsOnePageAndItsNumbers) {
  const SmallDataset directory;
  const auto study = [&](const std::string& more) {
    return run_shell("SOURCE_DATE_EPOCH=1700000000 " + program + "study " + more +
                     " --runs 2 --factor torque_step --json '" + directory.file("study.json") +
                     "'");
  };
  const ProgramRun run = study("--threads 1 -o '" + directory.file("study.html") + "'");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err.find("note:"), std::string::npos) << run.err;
  EXPECT_NE(run.out.find("point B is off by"), std::string::npos) << run.out;
  const std::string page = read_text(directory.file("study.html"));
  for (const char* part : {"Where the method can be trusted", "id=\"study-gravity-torque-step\"",
                           "id=\"table-trust-coverage\"", "id=\"tribolog-study\""}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(page.find("is missing"), std::string::npos);
  const std::string json = read_text(directory.file("study.json"));
  EXPECT_NE(json.find("\"schema\": \"tribolog-study-1\""), std::string::npos);
  EXPECT_EQ(study("--threads 2").status, 0);
  EXPECT_EQ(json, read_text(directory.file("study.json")));
}

TEST(Commands, AStudyRefusesWhatCannotBe) {
  const SmallDataset directory;
  const std::string out = " -o '" + directory.file("study.html") + "'";
  EXPECT_EQ(run_shell(program + "study").status, 2);
  EXPECT_EQ(run_shell(program + "study --runs 1" + out).status, 2);
  EXPECT_EQ(run_shell(program + "study --factor weather" + out).status, 2);
  EXPECT_EQ(run_shell(program + "study -o /no/such/directory/study.html").status, 4);
  EXPECT_EQ(run_shell(program + "study '" + directory.file("nothing.toml") + "'" + out).status, 3);
  EXPECT_EQ(run_shell(program + "study '" + directory.file("dataset.toml") + "'" + out).status, 3);
  const std::string numbers = " --json '" + directory.file("study.json") + "'";
  EXPECT_EQ(run_shell(program + "study --mixed").status, 2);
  EXPECT_EQ(run_shell(program + "study" + numbers + " --sound --mixed").status, 2);
  EXPECT_EQ(run_shell(program + "study --joint geared_arm --mixed" + numbers).status, 2);
  EXPECT_EQ(run_shell(program + "study --mixed" + numbers + out).status, 2);
  const std::string itself = directory.file("dataset.toml");
  EXPECT_EQ(run_shell(program + "study '" + itself + "' -o '" + itself + "'").status, 2);
  EXPECT_FALSE(std::filesystem::exists(directory.file("study.html")));
}

TEST(Commands, TheKnownTruthCheckIsMadeWhereItIsAskedFor) {
  const SmallDataset dataset;
  EXPECT_EQ(dataset.run("identify --check", "with.json").status, 0);
  EXPECT_EQ(dataset.run("identify", "without.json").status, 0);
  EXPECT_EQ(dataset.run("identify --check --truth-runs 2", "both.json").status, 2);
  EXPECT_NE(read_text(dataset.file("with.json")).find("\"came_back\""), std::string::npos);
  EXPECT_NE(read_text(dataset.file("without.json")).find("\"truth_check\": null"),
            std::string::npos);
}

TEST(Commands, WrongUsageIsStatus2) {
  for (const char* arguments :
       {"", "nonsense", "report", "figures x.toml", "identify --fail-on never x -o y"}) {
    const ProgramRun run = run_shell(program + arguments);
    EXPECT_EQ(run.status, 2) << arguments << run.err;
  }
}

TEST(Commands, SourceDateEpochMustBeANumber) {
  const SmallDataset dataset;
  const ProgramRun run =
      run_shell("SOURCE_DATE_EPOCH=yesterday " + program + "identify '" +
                dataset.file("dataset.toml") + "' -o '" + dataset.file("c.json") + "'");
  EXPECT_EQ(run.status, 2) << run.err;
}

TEST(Commands, IdentifyGivesTheTruthOfASmallLog) {
  const SmallDataset dataset;
  const ProgramRun run = dataset.run("identify", "c.json");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("verdict: doubtful"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("rows: 4001 read"), std::string::npos) << run.out;
  // 0.2 rad is 11.4592 deg.
  EXPECT_NE(run.out.find("11.459"), std::string::npos) << run.out;
}

TEST(Commands, RowsOfALogWithSeveralRecordingsAreCountedOnce) {
  const std::string whole = "file = \"log.csv\"\n";
  const std::string more = "[[recording]]\nrole = \"rough_sweep\"\n" + whole;
  const SmallDataset dataset(small_manifest() + "to_s = 14.995\n" + more +
                             "from_s = 14.995\nto_s = 34.995\n");
  const ProgramRun run = dataset.run("identify", "c.json");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("log.csv: 2 recordings; 501 of 4001 rows are in none of them"),
            std::string::npos)
      << run.out;
  EXPECT_NE(run.out.find("rows: 4001 read, 3500 used"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("outside the window"), std::string::npos) << run.out;
  const SmallDataset twice(small_manifest() + more);
  EXPECT_NE(twice.run("identify", "c.json").out.find("some of their windows overlap"),
            std::string::npos);
}

TEST(Commands, FailOnTurnsTheVerdictIntoAStatus) {
  const SmallDataset dataset;
  EXPECT_EQ(dataset.run("identify --fail-on doubtful", "c.json").status, 1);
  EXPECT_EQ(dataset.run("identify --fail-on not-identifiable", "c.json").status, 0);
  EXPECT_TRUE(std::filesystem::exists(dataset.file("c.json")));
}

TEST(Commands, WithoutTorqueTheMotionIsCheckedAndTheVerdictSaysWhatToRecord) {
  std::string manifest =
      replaced(small_manifest(), "kind = \"motor_torque\"\nside = \"motor\"", "kind = \"none\"");
  manifest = replaced(manifest, "effort = { name = \"tau\", unit = \"Nm\" }\n", "");
  const SmallDataset dataset(manifest);
  EXPECT_EQ(dataset.run("identify --fail-on not-identifiable", "c.json").status, 1);
  const ProgramRun run = dataset.run("report", "r.html");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(
      run.out.find("No torque was read, though 'tau' may hold one; tribolog init LOG --column "
                   "effort=NAME --effort-unit UNIT states it."),
      std::string::npos)
      << run.out;
  const std::string page = read_text(dataset.file("r.html"));
  EXPECT_NE(page.find("actual current together with the torque constant"), std::string::npos);
  EXPECT_NE(page.find("id=\"check-sweep-directions\""), std::string::npos);
}

TEST(Commands, AVoltageIsRefusedInOneLine) {
  const SmallDataset dataset(
      replaced(small_manifest(), "kind = \"motor_torque\"", "kind = \"motor_voltage\""));
  const ProgramRun run = dataset.run("identify", "c.json");
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find("a voltage or duty cycle is no torque"), std::string::npos) << run.err;
}

TEST(Commands, FailingChecksAndBrokenLimitsAreTold) {
  const SmallDataset wrong_sign(
      replaced(small_manifest(), "side = \"motor\"", "side = \"motor\"\nsign = -1"));
  const ProgramRun run = wrong_sign.run("identify --fail-on not-identifiable", "c.json");
  EXPECT_EQ(run.status, 1) << run.out;
  EXPECT_NE(run.out.find("check fails: Friction dissipates power"), std::string::npos) << run.out;
  const SmallDataset limited(small_manifest() +
                             "[[limit]]\nquantity = \"gravity_motor_Nm\"\nmax = 2.5\n");
  const ProgramRun broken = limited.run("identify --fail-on doubtful", "c.json");
  EXPECT_EQ(broken.status, 1);
  EXPECT_NE(read_text(limited.file("c.json")).find("does not meet the limit of at most 2.5"),
            std::string::npos);
}

TEST(Commands, QuietSaysNothingAndPipesGetPlainLines) {
  const SmallDataset dataset;
  const ProgramRun quiet = dataset.run("--quiet identify", "c.json");
  EXPECT_EQ(quiet.out, "");
  EXPECT_EQ(quiet.err, "");
  const ProgramRun piped = dataset.run("identify", "c.json");
  EXPECT_EQ(piped.err.find('\r'), std::string::npos);
  EXPECT_EQ(piped.err.find('\x1b'), std::string::npos);
  EXPECT_NE(piped.err.find("tribolog: hysteresis loop"), std::string::npos) << piped.err;
}

TEST(Commands, AReaderThatGoesAwayIsNoFault) {
  const SmallDataset dataset;
  const ProgramRun run =
      run_shell("{ " + program + "identify '" + dataset.file("dataset.toml") + "' -o '" +
                dataset.file("c.json") + "'; echo status $? >&2; } | head -c 1");
  EXPECT_NE(run.err.find("status 0"), std::string::npos) << run.err;
}

TEST(Commands, TheSeedOfTheCommandLineWinsOverTheManifests) {
  const SmallDataset dataset(
      replaced(small_manifest(), "[columns]", "[intervals]\nresamples = 300\nseed = 5\n[columns]"));
  const auto numbers = [&](const std::string& options) {
    const ProgramRun run = dataset.run("identify " + options, "c.json");
    EXPECT_EQ(run.status, 0) << run.err;
    const std::string text = read_text(dataset.file("c.json"));
    const std::size_t at = text.find("\"created_utc\"");  // a second may begin between two runs
    return text.substr(0, at) + text.substr(text.find('\n', at));
  };
  const auto holds = [](const std::string& text, const std::string& piece) {
    return text.find(piece) != std::string::npos;
  };
  const std::string of_seed_5 = "\"name\": \"Seed of the known-truth check\",\n";
  EXPECT_FALSE(holds(numbers("--truth-runs 0"), of_seed_5));
  const std::string stated = numbers("--truth-runs 1");
  EXPECT_TRUE(holds(stated, of_seed_5) && holds(stated, "\"text\": \"5\""));
  EXPECT_TRUE(holds(numbers("--truth-runs 1 --seed 6"), "\"text\": \"6\""));
  // Of commands and manifests of programs that resampled: accepted, without effect.
  EXPECT_EQ(replaced(numbers("--truth-runs 1 --resamples 7"), " --resamples 7", ""), stated);
  EXPECT_EQ(dataset.run("identify --resamples many", "c.json").status, 2);
}

}  // namespace
}  // namespace tribolog::test::commands_test
