#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"
#include "base/input_file.h"
#include "base/temporary_directory.h"

namespace tribolog::file_contents_test {
namespace {

using test::refusal_of;
using test::TemporaryDirectory;

std::string refusal(const std::string& path) {
  return test::refusal_of<InputError>([&] { return read_file(path); });
}

TEST(ReadFile, GivesEveryByte) {
  const test::TemporaryDirectory directory;
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes += static_cast<char>(i);
  EXPECT_EQ(read_file(directory.file("bytes", bytes)), bytes);
  EXPECT_EQ(read_file(directory.file("empty", "")), "");
  const std::string large(40'000'001, 'x');
  EXPECT_EQ(read_file(directory.file("large", large)), large);
}

TEST(ReadFile, SaysWhyAFileCannotBeRead) {
  const test::TemporaryDirectory directory;
  EXPECT_EQ(refusal(directory.path("no.csv")),
            directory.path("no.csv") + ": cannot open: No such file or directory");
  EXPECT_EQ(refusal(directory.path()), directory.path() + ": cannot read: is a directory");
  EXPECT_EQ(refusal(std::string("a\0b", 3)), R"(a\x00b: cannot open: NUL byte in the file name)");
  EXPECT_EQ(refusal(""), "cannot open: No such file or directory");
}

TEST(ReadFile, RefusesDevicesAndPipesWithoutWaiting) {
  const test::TemporaryDirectory directory;
  const std::string pipe = directory.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string hint = "; hint: save what comes through it as a file first";
  EXPECT_EQ(refusal(pipe), pipe + ": cannot read: is a pipe" + hint);
  EXPECT_EQ(refusal("/dev/zero"), "/dev/zero: cannot read: is a device; hint: a log is a file");
  EXPECT_EQ(refusal("-"), "-: standard input is not read" + hint);
}

TEST(ReadFile, RefusesAFileWithoutPermission) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read every file";
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("secret.csv", "t");
  ASSERT_EQ(chmod(path.c_str(), 0), 0);
  EXPECT_EQ(refusal(path), path + ": cannot open: Permission denied");
}

TEST(ReadFile, RefusesWhatIsLargerThanTheBound) {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("large", "123456");
  EXPECT_EQ(read_file(path, 6), "123456");
  EXPECT_EQ(test::refusal_of<InputError>([&] { return read_file(path, 5); }),
            path +
                ": file is larger than the bound of 5 bytes; hint: split it, or leave out "
                "columns that are not needed");
}

TEST(ReadFile, ReadsFilesThatHaveNoSize) {  // such as those of /proc
  if (!std::filesystem::exists("/proc/self/status")) GTEST_SKIP() << "no /proc here";
  EXPECT_NE(read_file("/proc/self/status").find("Name:"), std::string::npos);
}

TEST(InputFileSource, LeavesWhatIsAddedWhileItReads) {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("log.csv", "12345");
  InputFileSource source(path);
  EXPECT_FALSE(source.has_grown());
  std::ofstream(path, std::ios::app) << "6789";
  std::string bytes(100, '\0');
  EXPECT_EQ(source.read(bytes.data(), bytes.size()), 5U);
  EXPECT_EQ(source.read(bytes.data(), bytes.size()), 0U);
  EXPECT_EQ(bytes.substr(0, 6), std::string("12345\0", 6));
  EXPECT_TRUE(source.has_grown());
}

TEST(InputFileSource, RefusesAFileThatBecomesShorterWhileItReads) {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("log.csv", "12345");
  InputFileSource source(path);
  std::filesystem::resize_file(path, 3);
  std::string bytes(100, '\0');
  EXPECT_EQ(
      test::refusal_of<InputError>([&] { return source.read(bytes.data(), bytes.size()); }),
      path +
          ": file has become shorter while it was read, found 3 bytes, expected 5; hint: is it "
          "still being written? read a copy of it");
}

}  // namespace
}  // namespace tribolog::file_contents_test
