// What examples/ ships is what its commands make.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "cli/close_texts.h"
#include "cli/small_dataset.h"

namespace tribolog::test::examples_test {
namespace {

namespace fs = std::filesystem;

const std::string examples = std::string(TRIBOLOG_SOURCE_DIR) + "/examples/";

TEST(Examples, TheLogIsWhatItsScenarioGives) {
  const ScratchDirectory scratch;
  const ProgramRun run = run_shell(program + "simulate '" + examples +
                                   "ur_like/scenario.toml' -o '" + scratch.path() + "'");
  ASSERT_EQ(run.status, 0) << run.err;
  for (const char* file : {"sine_sweep.csv", "dataset.toml", "truth.json"}) {
    EXPECT_EQ(
        difference(read_text(scratch.file(file)), read_text(examples + "ur_like/" + file), 2e-5),
        "")
        << file;
  }
  EXPECT_LT(fs::file_size(scratch.file("sine_sweep.csv")), 1'000'000U);
}

/// The letters in use, which another version of the font draws otherwise.
std::string without_fonts(std::string svg) {
  const std::string mark = "base64,";
  for (auto at = svg.find(mark); at != std::string::npos; at = svg.find(mark, at)) {
    at += mark.size();
    svg.erase(at, svg.find_first_of("')\"", at) - at);
  }
  return svg;
}

TEST(Examples, ThePictureIsTheProgramsOwn) {
  const ScratchDirectory scratch;
  const ProgramRun made = run_shell("TRIBOLOG='" TRIBOLOG_PROGRAM "' '" + examples +
                                    "paper/friction_curve.sh' '" + scratch.file("curve.svg") + "'");
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(difference(without_fonts(read_text(scratch.file("curve.svg"))),
                       without_fonts(read_text(examples + "paper/friction_curve.svg")), 0.01),
            "");
}

}  // namespace
}  // namespace tribolog::test::examples_test
