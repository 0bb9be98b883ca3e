#include "files/file_contents.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "error.h"
#include "files/temporary_directory.h"

namespace tribolog {
namespace {

using test::refusal_of;
using test::TemporaryDirectory;

std::string refusal(const std::string& path) {
  return refusal_of<InputError>([&] { return read_file(path); });
}

TEST(ReadFile, GivesEveryByte) {
  const TemporaryDirectory directory;
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes += static_cast<char>(i);
  EXPECT_EQ(read_file(directory.file("bytes", bytes)), bytes);
  EXPECT_EQ(read_file(directory.file("empty", "")), "");
  const std::string large(40'000'001, 'x');
  EXPECT_EQ(read_file(directory.file("large", large)), large);
}

TEST(ReadFile, SaysWhyAFileCannotBeRead) {
  const TemporaryDirectory directory;
  EXPECT_EQ(refusal(directory.path("no.csv")),
            directory.path("no.csv") + ": cannot open: No such file or directory");
  EXPECT_EQ(refusal(directory.path()), directory.path() + ": cannot read: is a directory");
  EXPECT_EQ(refusal(std::string("a\0b", 3)), R"(a\x00b: cannot open: NUL byte in the file name)");
  EXPECT_EQ(refusal(""), "cannot open: No such file or directory");
}

TEST(ReadFile, RefusesDevicesAndPipesWithoutWaiting) {
  const TemporaryDirectory directory;
  const std::string pipe = directory.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string reason =
      ": cannot read: is not a regular file; hint: devices and pipes are not read";
  EXPECT_EQ(refusal(pipe), pipe + reason);
  EXPECT_EQ(refusal("/dev/zero"), "/dev/zero" + reason);
}

TEST(ReadFile, RefusesAFileWithoutPermission) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read every file";
  const TemporaryDirectory directory;
  const std::string path = directory.file("secret.csv", "t");
  ASSERT_EQ(chmod(path.c_str(), 0), 0);
  EXPECT_EQ(refusal(path), path + ": cannot open: Permission denied");
}

TEST(ReadFile, RefusesWhatIsLargerThanTheBound) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("large", "123456");
  EXPECT_EQ(read_file(path, 6), "123456");
  EXPECT_EQ(refusal_of<InputError>([&] { return read_file(path, 5); }),
            path +
                ": file is larger than the bound of 5 bytes; hint: split it, or leave out "
                "columns that are not needed");
}

TEST(ReadFile, ReadsFilesThatHaveNoSize) {  // such as those of /proc
  if (!std::filesystem::exists("/proc/self/status")) GTEST_SKIP() << "no /proc here";
  EXPECT_NE(read_file("/proc/self/status").find("Name:"), std::string::npos);
}

}  // namespace
}  // namespace tribolog
