// What `cmake --install` puts into a folder is a whole program, wherever the folder is moved.

#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cli/small_dataset.h"

namespace tribolog::test::installation_test {
namespace {

namespace fs = std::filesystem;

TEST(Installation, MayBeMoved) {
  const ScratchDirectory scratch;
  const ProgramRun installed =
      run_shell("'" TRIBOLOG_CMAKE "' --install '" TRIBOLOG_BUILD_DIR "' --prefix '" +
                scratch.file("first") + "'");
  ASSERT_EQ(installed.status, 0) << installed.err;
  fs::rename(scratch.file("first"), scratch.file("second"));
  const std::string prefix = scratch.file("second");
  for (const char* file :
       {"share/doc/tribolog/README.md", "share/doc/tribolog/copyright",
        "share/doc/tribolog/docs/tutorial.md", "share/doc/tribolog/docs/pictures/report.png",
        "share/doc/tribolog/examples/ur_like/sine_sweep.csv",
        "share/tribolog/calibration.schema.json", "share/man/man1/tribolog.1",
        "share/man/man1/tribolog-archive-list.1", "share/bash-completion/completions/tribolog",
        "share/zsh/site-functions/_tribolog", "share/fish/vendor_completions.d/tribolog.fish"}) {
    EXPECT_TRUE(fs::exists(prefix + "/" + file)) << file;
  }
  const std::string command = fmt::format("'{}/bin/tribolog' ", prefix);
  const std::string log = fmt::format("'{}/share/doc/tribolog/examples/ur_like/", prefix);
  const ProgramRun report = run_shell(command + "report " + log + "dataset.toml' -o '" +
                                      scratch.file("report.html") + "'");
  EXPECT_EQ(report.status, 0) << report.err;
  const ProgramRun verbose = run_shell(command + "--version --verbose");
  EXPECT_EQ(verbose.status, 0) << verbose.err;
}

}  // namespace
}  // namespace tribolog::test::installation_test
