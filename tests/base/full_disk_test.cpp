// Faults of the disk itself, on small file systems in memory; needs the right to mount one.

#include <cerrno>
#include <cstring>

#include <gtest/gtest.h>
#include <sys/mount.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/temporary_directory.h"

namespace tribolog::full_disk_test {
namespace {

using test::refusal_of;
using test::TemporaryDirectory;

class SmallDisk : public testing::Test {
 protected:
  void SetUp() override {
    if (mount("tmpfs", disk_.path().c_str(), "tmpfs", 0, "size=64k") != 0) {
      GTEST_SKIP() << "cannot mount a file system here: " << std::strerror(errno);
    }
    is_mounted_ = true;
  }
  void TearDown() override {
    if (is_mounted_) umount(disk_.path().c_str());
  }
  bool make_read_only() {
    return mount("tmpfs", disk_.path().c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, "size=64k") == 0;
  }

  test::TemporaryDirectory disk_;
  bool is_mounted_{false};
};

TEST_F(SmallDisk, FullKeepsTheOldFileAndLeavesNoTemporaryOne) {
  const std::string path = disk_.path("report.html");
  write_file_atomically(path, "old");
  const std::string said = test::refusal_of<OutputError>([&] {
    write_file_atomically(path, std::string(1 << 20, 'x'));
    return 0;
  });
  EXPECT_EQ(said, path + ": cannot write: No space left on device");
  EXPECT_EQ(disk_.contents("report.html"), "old");
  EXPECT_EQ(disk_.entries(), 1U);
  write_file_atomically(path, "it fits again");
  EXPECT_EQ(disk_.contents("report.html"), "it fits again");
}

TEST_F(SmallDisk, FullKeepsEveryOldFileOfASet) {
  write_file_atomically(disk_.path("a.csv"), "old a");
  const std::string said = test::refusal_of<OutputError>([&] {
    AtomicFiles files;
    files.add(disk_.path("a.csv"), "new a");
    files.add(disk_.path("b.csv"), std::string(1 << 20, 'x'));
    files.commit();
    return 0;
  });
  EXPECT_EQ(said, disk_.path("b.csv") + ": cannot write: No space left on device");
  EXPECT_EQ(disk_.contents("a.csv"), "old a");
  EXPECT_EQ(disk_.entries(), 1U);
}

TEST_F(SmallDisk, ReadOnlyIsFoundBeforeTheComputation) {
  const std::string path = disk_.path("report.html");
  write_file_atomically(path, "old");
  if (!make_read_only()) GTEST_SKIP() << "cannot mount read-only: " << std::strerror(errno);
  const std::string reason = path + ": cannot write: Read-only file system";
  EXPECT_EQ(test::refusal_of<OutputError>([&] {
              check_output_can_be_written(path);
              return 0;
            }),
            reason);
  EXPECT_EQ(test::refusal_of<OutputError>([&] {
              write_file_atomically(path, "new");
              return 0;
            }),
            reason);
  EXPECT_EQ(disk_.contents("report.html"), "old");
}

}  // namespace
}  // namespace tribolog::full_disk_test
