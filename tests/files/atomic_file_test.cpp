#include "files/atomic_file.h"

#include <chrono>
#include <csignal>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "error.h"
#include "files/temporary_directory.h"

namespace tribolog {
namespace {

namespace fs = std::filesystem;
using test::refusal_of;
using test::TemporaryDirectory;

std::string check_refusal(const std::string& path) {
  return refusal_of<OutputError>([&] {
    check_output_can_be_written(path);
    return 0;
  });
}

std::string write_refusal(const std::string& path) {
  return refusal_of<OutputError>([&] {
    write_file_atomically(path, "new");
    return 0;
  });
}

TEST(WriteFileAtomically, WritesAndReplaces) {
  const TemporaryDirectory directory;
  const std::string path = directory.path("report.html");
  check_output_can_be_written(path);
  write_file_atomically(path, "old");
  EXPECT_EQ(directory.contents("report.html"), "old");
  const std::string bytes("n\0w", 3);
  check_output_can_be_written(path);
  write_file_atomically(path, bytes);
  EXPECT_EQ(directory.contents("report.html"), bytes);
  EXPECT_EQ(directory.entries(), 1U) << "no temporary file is left";
}

TEST(WriteFileAtomically, LeavesThePermissionsToTheUmask) {
  const TemporaryDirectory directory;
  const mode_t before = umask(027);
  write_file_atomically(directory.path("a"), "a");
  umask(before);
  struct stat status {};
  ASSERT_EQ(stat(directory.path("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST(WriteFileAtomically, FollowsALinkToAFile) {
  const TemporaryDirectory directory;
  const std::string target = directory.file("real.html", "old");
  fs::create_symlink("real.html", directory.path("link.html"));
  write_file_atomically(directory.path("link.html"), "new");
  EXPECT_TRUE(fs::is_symlink(directory.path("link.html")));
  EXPECT_EQ(directory.contents("real.html"), "new");
}

TEST(WriteFileAtomically, TakesNamesAsLongAsTheFileSystemDoes) {
  const TemporaryDirectory directory;
  const std::string name(255, 'x');
  write_file_atomically(directory.path(name), "long");
  EXPECT_EQ(directory.contents(name), "long");
  const std::string too_long = directory.path(std::string(256, 'x'));
  EXPECT_EQ(write_refusal(too_long), too_long + ": cannot write: File name too long");
  EXPECT_EQ(directory.entries(), 1U);
}

TEST(WriteFileAtomically, RefusesWhatIsNoFile) {
  const TemporaryDirectory directory;
  fs::create_directory(directory.path("folder"));
  const std::string folder = directory.path("folder");
  EXPECT_EQ(write_refusal(folder), folder + ": cannot write: is a directory");
  EXPECT_EQ(check_refusal(folder), folder + ": cannot write: is a directory");
  EXPECT_EQ(check_refusal("/dev/null"), "/dev/null: cannot write: is not a regular file");
  EXPECT_EQ(check_refusal(""), ": cannot write: the file name is empty");
  const std::string nowhere = directory.path("no/such/report.html");
  EXPECT_EQ(check_refusal(nowhere), nowhere + ": cannot write: the directory does not exist");
  EXPECT_EQ(write_refusal(nowhere), nowhere + ": cannot write: No such file or directory");
}

TEST(WriteFileAtomically, ShowsStrangeNamesEscaped) {
  const TemporaryDirectory directory;
  const std::string path = directory.path("a\nb/c");
  EXPECT_EQ(check_refusal(path),
            directory.path() + R"(/a\x0ab/c: cannot write: the directory does not exist)");
}

TEST(WriteFileAtomically, KeepsTheOldFileWhereTheNewOneIsTooLarge) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("report.html", "old");
  struct rlimit before {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  struct rlimit small = before;
  small.rlim_cur = 4096;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string said = refusal_of<OutputError>([&] {
    write_file_atomically(path, std::string(100'000, 'x'));
    return 0;
  });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(said, path + ": cannot write: File too large");
  EXPECT_EQ(directory.contents("report.html"), "old");
  EXPECT_EQ(directory.entries(), 1U);
}

TEST(WriteFileAtomically, RemovesItsOwnTemporaryFilesOnceTheyAreOld) {
  const TemporaryDirectory directory;
  const std::string old_own = directory.file(".report.html.tmp-aB3xYz", "left by a killed run");
  const std::string new_own = directory.file(".report.html.tmp-cD4xYz", "of a run still going");
  const std::string other = directory.file(".other.html.tmp-aB3xYz", "not ours");
  const auto two_days_ago = fs::file_time_type::clock::now() - std::chrono::hours(48);
  fs::last_write_time(old_own, two_days_ago);
  fs::last_write_time(other, two_days_ago);
  write_file_atomically(directory.path("report.html"), "new");
  EXPECT_FALSE(fs::exists(old_own));
  EXPECT_TRUE(fs::exists(new_own));
  EXPECT_TRUE(fs::exists(other));
}

TEST(AtomicFiles, TakeTheirPlacesTogether) {
  const TemporaryDirectory directory;
  write_file_atomically(directory.path("a"), "old a");
  {
    AtomicFiles files;
    files.add(directory.path("a"), "new a");
    files.add(directory.path("b"), "new b");
    EXPECT_EQ(directory.contents("a"), "old a");
    EXPECT_FALSE(fs::exists(directory.path("b")));
    files.commit();
  }
  EXPECT_EQ(directory.contents("a"), "new a");
  EXPECT_EQ(directory.contents("b"), "new b");
  EXPECT_EQ(directory.entries(), 2U);
  { AtomicFiles().add(directory.path("a"), "never committed"); }
  EXPECT_EQ(directory.contents("a"), "new a");
  EXPECT_EQ(directory.entries(), 2U);
}

TEST(CheckOutput, RefusesToOverwriteAnInput) {
  const TemporaryDirectory directory;
  const std::string input = directory.file("run.csv", "t");
  fs::create_symlink("run.csv", directory.path("link"));
  fs::create_hard_link(input, directory.path("hard"));
  for (const char* name : {"run.csv", "./run.csv", "link", "hard"}) {
    const std::string path = directory.path() + "/" + name;
    EXPECT_EQ(refusal_of<UsageError>([&] {
                check_output_can_be_written(path, {"nowhere", input});
                return 0;
              }),
              path + ": is also an input; it would be overwritten");
  }
  check_output_can_be_written(directory.path("other"), {input});
}

TEST(CreateDirectory, MakesThoseAboveToo) {
  const TemporaryDirectory directory;
  create_directory(directory.path("a/b/c"));
  EXPECT_TRUE(fs::is_directory(directory.path("a/b/c")));
  create_directory(directory.path("a/b/c"));
  const std::string file = directory.file("file", "");
  EXPECT_EQ(refusal_of<OutputError>([&] {
              create_directory(file);
              return 0;
            }),
            file + ": cannot create the directory: Not a directory");
}

}  // namespace
}  // namespace tribolog
