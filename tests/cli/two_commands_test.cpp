// The main job through the real command line, on the scenarios of examples/.

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "cli/small_dataset.h"
#include "support/breadth.h"

namespace tribolog::test::two_commands_test {
namespace {

std::string example(const std::string& name) {
  return std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/" + name;
}

TEST(MainJob, FromScenarioToReport) {
  const ScratchDirectory scratch;
  const std::string out = scratch.file("paper");
  const ProgramRun simulated =
      run_shell(program + "simulate '" + example("scenario.toml") + "' -o '" + out + "'");
  ASSERT_EQ(simulated.status, 0) << simulated.err;
  for (const char* file : {"dataset.toml", "truth.json", "rough_sweep.csv", "precise_sweep.csv",
                           "oscillation.csv", "constant_speed_20.csv", "am100ib.toml"}) {
    EXPECT_TRUE(std::filesystem::exists(out + "/" + file)) << file;
  }
  const ProgramRun report =
      run_shell(program + "report '" + out + "/dataset.toml' -o '" + out + "/report.html'");
  ASSERT_EQ(report.status, 0) << report.err;
  EXPECT_NE(report.out.find("verdict: usable"), std::string::npos) << report.out;
  EXPECT_NE(report.out.find("79.1679"), std::string::npos) << report.out;
  const std::string html = read_text(out + "/report.html");
  // Figures 10 to 17 and 22, candidates, loop fit, curve models, directions, masses;
  // not the known-truth check's.
  std::size_t pictures = 0;
  for (std::size_t at = 0; (at = html.find("data:image/png;base64,", at)) != std::string::npos;
       ++at) {
    ++pictures;
  }
  EXPECT_EQ(pictures, 13U);
  EXPECT_EQ(html.find("Other figures"), std::string::npos) << "each has its section";
  const std::size_t precise = html.find("id=\"stage-2\"");
  for (const char* id : {"fig-10-phenomenological-model", "fig-11-rough-motion",
                         "fig-12-range-of-motion", "fig-13-rough-torque"}) {
    EXPECT_LT(html.find(std::string("id=\"") + id + "\""), precise) << id;
  }
  EXPECT_LT(html.size(), 2'000'000U);

  const ProgramRun figures =
      run_shell(program + "figures '" + out + "/dataset.toml' -o '" + out + "/figures'");
  EXPECT_EQ(figures.status, 0) << figures.err;
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(out + "/figures")) {
    EXPECT_EQ(entry.path().extension(), ".png");
    ++files;
  }
  EXPECT_EQ(files, 17U) << "all but the known-truth check's, which is made for --check alone";
}

TEST(MainJob, NoisyScenariosReportToo) {
  // Ripple takes eight positions, and time.
  const std::string fewer = " --truth-runs 2";
  for (const auto& [scenario, options] :
       {std::pair{"scenario_noise.toml", every_case() ? "" : fewer},
        std::pair{"scenario_ripple.toml", every_case() ? fewer : fewer + " --no-figures"}}) {
    const ScratchDirectory scratch;
    const std::string out = scratch.file("paper");
    ASSERT_EQ(run_shell(program + "simulate '" + example(scenario) + "' -o '" + out + "'").status,
              0);
    const ProgramRun report = run_shell(program + "report '" + out + "/dataset.toml' -o '" + out +
                                        "/report.html'" + options);
    EXPECT_EQ(report.status, 0) << scenario << report.err;
  }
}

TEST(MainJob, SeedOnTheCommandLineChangesTheNoise) {
  const ScratchDirectory scratch;
  const auto simulate = [&](const std::string& seed, const std::string& out) {
    const ProgramRun run = run_shell(program + "simulate '" + example("scenario_noise.toml") +
                                     "' --seed " + seed + " -o '" + scratch.file(out) + "'");
    EXPECT_EQ(run.status, 0) << run.err;
    return read_text(scratch.file(out) + "/oscillation.csv");
  };
  EXPECT_EQ(simulate("7", "a"), simulate("7", "b"));
  EXPECT_NE(simulate("7", "c"), simulate("8", "d"));
}

}  // namespace
}  // namespace tribolog::test::two_commands_test
