// Which files of a folder are logs, and folders that are something else.

#include <filesystem>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "inspect/survey/log_survey.h"
#include "support/run_program.h"

namespace tribolog::log_files_test {
namespace {

TEST(LogFiles, FilesOfMeasurementSystemsAreLogsAndTheirIndexIsNot) {
  const test::ScratchDirectory scratch;
  for (const char* name : {"a.mf4", "b.tdms", "b.tdms_index", "c.xml"}) scratch.write(name, "x");
  EXPECT_EQ(inspect::survey::log_files_in(scratch.path()),
            (std::vector<std::string>{scratch.file("a.mf4"), scratch.file("b.tdms")}));
}

TEST(LogFiles, AZarrStoreIsRefusedWithWhatToRun) {
  for (const char* name : {".zgroup", "zarr.json"}) {
    const test::ScratchDirectory scratch;
    scratch.write(name, "{}");
    EXPECT_EQ(
        test::refusal_of<InputError>([&] { return inspect::survey::log_files_in(scratch.path()); }),
        scratch.path() +
            ": is a Zarr store, which is not read; hint: in a Python with zarr (pip install zarr): "
            "python3 -c \"import numpy, zarr; numpy.savez('LOG.npz', **{n: a[:] for n, a in "
            "zarr.open_group('LOG', mode='r').arrays()})\"");
  }
}

}  // namespace
}  // namespace tribolog::log_files_test
