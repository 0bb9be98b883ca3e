// The library as it is installed, wherever that is moved: a program outside the tree is built with
// it, by find_package() and by pkg-config, and does the main job.

#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/run_program.h"

namespace tribolog::test::installed_library_test {
namespace {

namespace fs = std::filesystem;

const std::string dataset = TRIBOLOG_SOURCE_DIR "/examples/ur_like/dataset.toml";
const std::string example = TRIBOLOG_SOURCE_DIR "/examples/library";

class TheInstalledLibrary : public testing::Test {
 protected:
  void SetUp() override {
    const ProgramRun installed =
        run_shell(fmt::format("'{}' --install '{}' --prefix '{}'", TRIBOLOG_CMAKE,
                              TRIBOLOG_BUILD_DIR, scratch_.file("first")));
    ASSERT_EQ(installed.status, 0) << installed.err;
    fs::rename(scratch_.file("first"), prefix_);
  }

  /// Runs the example: its status is 1, as the log's verdict is doubtful.
  void expect_works(const std::string& program) const {
    const std::string out = scratch_.file("out");
    const ProgramRun run = run_shell(fmt::format("'{}' '{}' '{}'", program, dataset, out));
    ASSERT_EQ(run.status, 1) << run.out << run.err;
    EXPECT_NE(run.out.find("Coulomb torque at the joint: 12."), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("doubtful: "), std::string::npos) << run.out;
    EXPECT_NE(run.out.find(" N·m (95 %: "), std::string::npos) << run.out;
    for (const char* file :
         {"report.html", "calibration.json", "figures/fig-11-rough-motion.png"}) {
      EXPECT_TRUE(fs::exists(out + "/" + file)) << file;
    }
    const ProgramRun refused = run_shell(fmt::format("'{}' /no/such.toml '{}'", program, out));
    EXPECT_EQ(refused.status, 3) << refused.err;
  }

  ScratchDirectory scratch_;
  std::string prefix_{scratch_.file("second")};
};

TEST_F(TheInstalledLibrary, IsFoundByFindPackage) {
  const std::string build = scratch_.file("build");
  const ProgramRun configured = run_shell(
      fmt::format("'{}' -S '{}' -B '{}' -DCMAKE_PREFIX_PATH='{}' -DCMAKE_CXX_COMPILER='{}' "
                  "-DCMAKE_CXX_FLAGS='-Wall -Wextra -pedantic -Werror {}' && '{}' --build '{}'",
                  TRIBOLOG_CMAKE, example, build, prefix_, TRIBOLOG_CXX, TRIBOLOG_CXX_FLAGS,
                  TRIBOLOG_CMAKE, build));
  ASSERT_EQ(configured.status, 0) << configured.out << configured.err;
  expect_works(build + "/joint_check");
}

TEST_F(TheInstalledLibrary, IsFoundByPkgConfig) {
  const std::string program = scratch_.file("joint_check");
  const std::string library = prefix_ + "/" TRIBOLOG_LIBDIR;
  const ProgramRun built = run_shell(fmt::format(
      "export PKG_CONFIG_PATH='{0}/pkgconfig'; '{1}' -std=c++20 {4} '{2}/main.cpp' -o '{3}' "
      "$(pkg-config --cflags --libs tribolog) -Wl,-rpath,'{0}'",
      library, TRIBOLOG_CXX, example, program, TRIBOLOG_CXX_FLAGS));
  ASSERT_EQ(built.status, 0) << built.err;
  expect_works(program);
}

TEST_F(TheInstalledLibrary, RefusesAnotherVersion) {
  const std::string source = scratch_.file("other");
  fs::create_directory(source);
  scratch_.write("other/CMakeLists.txt",
                 "cmake_minimum_required(VERSION 3.22)\nproject(other LANGUAGES CXX)\n"
                 "find_package(tribolog 0.1 REQUIRED)\n");
  const ProgramRun configured =
      run_shell(fmt::format("'{}' -S '{}' -B '{}/build' -DCMAKE_PREFIX_PATH='{}'", TRIBOLOG_CMAKE,
                            source, source, prefix_));
  EXPECT_NE(configured.status, 0);
  EXPECT_NE(configured.err.find("compatible"), std::string::npos) << configured.err;
}

}  // namespace
}  // namespace tribolog::test::installed_library_test
