// Which libraries a command loads, and what it does where one is missing.

#include <cstddef>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cli/small_dataset.h"
#include "support/mcap_writer.h"
#include "support/parquet_writer.h"

namespace tribolog::test::loaded_libraries_test {
namespace {

namespace fs = std::filesystem;

/// File names of all libraries that the program and the processes that it starts load.
std::set<std::string> loaded_by(const std::string& arguments) {
  const ScratchDirectory scratch;
  const ProgramRun run = run_shell("LD_DEBUG=files LD_DEBUG_OUTPUT='" + scratch.file("ld") + "' " +
                                   program + arguments);
  EXPECT_EQ(run.status, 0) << arguments << "\n" << run.err;
  std::set<std::string> names;
  for (const fs::directory_entry& one : fs::directory_iterator(scratch.path())) {
    std::istringstream lines(read_text(one.path().string()));
    const std::string marker = "calling init: ";
    for (std::string line; std::getline(lines, line);) {
      const std::size_t at = line.find(marker);
      if (at != std::string::npos) {
        names.insert(fs::path(line.substr(at + marker.size())).filename().string());
      }
    }
  }
  EXPECT_TRUE(names.count("libc.so.6")) << "the loader told nothing";
  return names;
}

/// Those of them in whose name one of the words stands.
std::string named(const std::set<std::string>& libraries, const std::set<std::string>& words) {
  std::string found;
  for (const std::string& library : libraries) {
    for (const std::string& word : words) {
      if (library.find(word) != std::string::npos) found += library + " ";
    }
  }
  return found;
}

const std::set<std::string> graphics{"vtk", "OSMesa", "EGL", "GL.so", "GLX", "LLVM", "X11"};
const std::set<std::string> of_some_logs_or_archives{
    "libpq", "ldap", "krb5", "curl", "hdf5", "matio", "sundials", "libmpi", "snappy", "protobuf"};

TEST(LoadedLibraries, AreThoseOfACommandAlone) {
  const SmallDataset dataset;
  const std::string manifest = fmt::format("'{}' ", dataset.file("dataset.toml"));
  const std::string archive = fmt::format("'{}' ", dataset.file("kept.tribolog"));
  const std::string calibration = fmt::format("'{}' ", dataset.file("c.json"));
  ASSERT_EQ(
      run_shell(program + "identify " + manifest + "-o " + calibration + "--archive " + archive)
          .status,
      0);
  for (const std::string& arguments :
       {std::string("--version"), "archive list --archive " + archive,
        "archive verify --archive " + archive, "inspect '" + dataset.file("log.csv") + "'",
        "identify " + manifest + "-o " + calibration,
        "figures " + manifest + "--format svg,pdf -o '" + dataset.file("figures") + "'"}) {
    const std::set<std::string> libraries = loaded_by(arguments);
    EXPECT_EQ(named(libraries, graphics), "") << arguments;
    EXPECT_EQ(named(libraries, of_some_logs_or_archives), "") << arguments;
  }
}

TEST(LoadedLibraries, DrawWhereAPictureIsDrawn) {
  const SmallDataset dataset;
  const std::set<std::string> libraries = loaded_by("figures '" + dataset.file("dataset.toml") +
                                                    "' -o '" + dataset.file("figures") + "'");
  EXPECT_NE(named(libraries, graphics), "");
  EXPECT_EQ(named(libraries, of_some_logs_or_archives), "");
}

/// A copy of the program with its modules, as an installation that something is missing from.
class ProgramElsewhere {
 public:
  ProgramElsewhere() {
    fs::create_directories(scratch_.file("bin"));
    fs::copy_file(TRIBOLOG_PROGRAM, scratch_.file("bin/tribolog"));
    fs::create_directories(scratch_.file(modules));
    fs::copy(TRIBOLOG_MODULE_DIR, scratch_.file(modules));
  }
  [[nodiscard]] std::string command() const {
    return fmt::format("'{}' ", scratch_.file("bin/tribolog"));
  }
  [[nodiscard]] std::string module(const std::string& name) const {
    return scratch_.file(modules + "/lib" + name + ".so");
  }
  /// As if a library that the module stands on were not installed: "libpq" is "nibpq".
  void lose_library_of(const std::string& module_name, const std::string& library) const {
    alter(module_name, library);
  }
  /// Its first letter becomes an n.
  void alter(const std::string& module_name, const std::string& text) const {
    std::string bytes = read_text(module(module_name));
    const std::size_t at = bytes.find(text);
    ASSERT_NE(at, std::string::npos) << module_name << " does not hold " << text;
    bytes[at] = 'n';
    scratch_.write(modules + "/lib" + module_name + ".so", bytes);
  }

 private:
  const std::string modules =
      fs::relative(TRIBOLOG_MODULE_DIR, fs::path(TRIBOLOG_PROGRAM).parent_path().parent_path());
  ScratchDirectory scratch_;
};

void expect_numbers_without_pictures(const ProgramElsewhere& installed, const std::string& reason) {
  const SmallDataset dataset;
  const std::string manifest = fmt::format("'{}' ", dataset.file("dataset.toml"));
  const ProgramRun report = run_shell(installed.command() + "report " + manifest + "-o '" +
                                      dataset.file("report.html") + "'");
  EXPECT_EQ(report.status, 5) << report.err;
  EXPECT_NE(report.err.find(reason), std::string::npos) << report.err;
  EXPECT_TRUE(fs::exists(dataset.file("report.calibration.json")));
  EXPECT_NE(read_text(dataset.file("report.html")).find("missing"), std::string::npos);
  const ProgramRun vectors = run_shell(installed.command() + "figures " + manifest +
                                       "--format svg -o '" + dataset.file("figures") + "'");
  EXPECT_EQ(vectors.status, 0) << vectors.err;
  EXPECT_EQ(run_shell(installed.command() + "--version").status, 0);
}

TEST(MissingLibraries, WithoutTheModuleThatDrawsTheNumbersAreKept) {
  const ProgramElsewhere installed;
  fs::remove(installed.module("tribolog_vtk"));
  expect_numbers_without_pictures(installed,
                                  "libtribolog_vtk.so is missing; install tribolog again");
}

TEST(MissingLibraries, AModuleOfAnotherVersionDrawsNothing) {
  const ProgramElsewhere installed;
  installed.alter("tribolog_vtk", "tribolog module ");
  expect_numbers_without_pictures(installed, "libtribolog_vtk.so is of another version; install");
}

TEST(MissingLibraries, WithoutVtkTheNumbersAreKept) {
  const ProgramElsewhere installed;
  installed.lose_library_of("tribolog_vtk", "libvtkCommonCore");
  expect_numbers_without_pictures(installed, " is missing; install the packages libvtk");
}

TEST(MissingLibraries, AreNamedWhereTheyAreNeeded) {
  const ProgramElsewhere installed;
  installed.lose_library_of("tribolog_postgres", "libpq.so");
  const ProgramRun list =
      run_shell(installed.command() + "archive list --archive postgresql://nobody@localhost/none");
  EXPECT_EQ(list.status, 6) << list.err;
  EXPECT_NE(list.err.find("nibpq.so.5 is missing; install the packages libpq5"), std::string::npos)
      << list.err;

  installed.lose_library_of("tribolog_ode", "libsundials_cvode");
  const ScratchDirectory scratch;
  const std::string scenario =
      scratch.write("ramps.toml", read_text(TRIBOLOG_SOURCE_DIR "/examples/ur_like/scenario.toml") +
                                      "[break_away]\ncentre_deg = -130\nrate_Nm_s = 0.5\n"
                                      "largest_torque_Nm = 3\nrepeats = 1\n");
  const ProgramRun ramps = run_shell(installed.command() + "simulate '" + scenario + "' -o '" +
                                     scratch.file("out") + "'");
  EXPECT_EQ(ramps.status, 70) << ramps.err;
  EXPECT_NE(ramps.err.find("tribolog: error: nibsundials_cvode"), std::string::npos) << ramps.err;

  installed.lose_library_of("tribolog_arrays", "libmatio.so");
  const std::string log = scratch.write("log.h5", "\x89HDF\r\n\x1a\n and nothing more");
  const ProgramRun inspect = run_shell(installed.command() + "inspect '" + log + "'");
  EXPECT_EQ(inspect.status, 3) << inspect.err;
  EXPECT_NE(inspect.err.find("logs of HDF5 and MATLAB cannot be read here; hint: nibmatio"),
            std::string::npos)
      << inspect.err;

  installed.lose_library_of("tribolog_parquet", "libsnappy");
  WrittenParquet file;
  add_doubles("q", {1, 2}, file);
  file.columns.front().codec = 1;
  const std::string parquet = scratch.write("log.parquet", write_parquet(file));
  const ProgramRun packed = run_shell(installed.command() + "inspect '" + parquet + "'");
  EXPECT_EQ(packed.status, 3) << packed.err;
  EXPECT_NE(packed.err.find("Parquet compressed with snappy cannot be read here; hint: nibsnappy"),
            std::string::npos)
      << packed.err;
  installed.lose_library_of("tribolog_protobuf", "libprotobuf.so");
  McapWriter writer({});
  writer.add_schema(1, "arm.State", "protobuf", "");
  writer.add_channel(1, 1, "/state", "protobuf");
  writer.add_message(1, 0, "");
  const std::string bag = scratch.write("log.mcap", writer.finish());
  const ProgramRun messages = run_shell(installed.command() + "inspect '" + bag + "'");
  EXPECT_EQ(messages.status, 3) << messages.err;
  EXPECT_NE(messages.err.find("/state is not read: protobuf cannot be read here: nibprotobuf"),
            std::string::npos)
      << messages.err;
  EXPECT_NE(messages.err.find(" is missing; install the packages libprotobuf"), std::string::npos)
      << messages.err;
}

}  // namespace
}  // namespace tribolog::test::loaded_libraries_test
