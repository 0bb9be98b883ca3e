#include "base/atomic_file.h"

#include <chrono>
#include <csignal>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "base/error.h"
#include "base/temporary_directory.h"

namespace tribolog::atomic_file_test {
namespace {

namespace fs = std::filesystem;
using test::refusal_of;
using test::TemporaryDirectory;

std::string check_refusal(const std::string& path) {
  return test::refusal_of<OutputError>([&] {
    check_output_can_be_written(path);
    return 0;
  });
}

std::string write_refusal(const std::string& path) {
  return test::refusal_of<OutputError>([&] {
    write_file_atomically(path, "new");
    return 0;
  });
}

TEST(WriteFileAtomically, WritesAndReplaces) {
  const test::TemporaryDirectory directory;
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
  const test::TemporaryDirectory directory;
  const mode_t before = umask(027);
  write_file_atomically(directory.path("a"), "a");
  umask(before);
  struct stat status{};
  ASSERT_EQ(stat(directory.path("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST(WriteFileAtomically, FollowsALinkToAFile) {
  const test::TemporaryDirectory directory;
  const std::string target = directory.file("real.html", "old");
  fs::create_symlink("real.html", directory.path("link.html"));
  write_file_atomically(directory.path("link.html"), "new");
  EXPECT_TRUE(fs::is_symlink(directory.path("link.html")));
  EXPECT_EQ(directory.contents("real.html"), "new");
}

TEST(WriteFileAtomically, TakesNamesAsLongAsTheFileSystemDoes) {
  const test::TemporaryDirectory directory;
  const std::string name(255, 'x');
  write_file_atomically(directory.path(name), "long");
  EXPECT_EQ(directory.contents(name), "long");
  const std::string too_long = directory.path(std::string(256, 'x'));
  EXPECT_EQ(write_refusal(too_long), too_long + ": cannot write: File name too long");
  EXPECT_EQ(directory.entries(), 1U);
}

TEST(WriteFileAtomically, RefusesWhatIsNoFile) {
  const test::TemporaryDirectory directory;
  fs::create_directory(directory.path("folder"));
  const std::string folder = directory.path("folder");
  EXPECT_EQ(write_refusal(folder), folder + ": cannot write: is a directory");
  EXPECT_EQ(check_refusal(folder), folder + ": cannot write: is a directory");
  EXPECT_EQ(check_refusal(""), ": cannot write: the file name is empty");
  const std::string nowhere = directory.path("no/such/report.html");
  EXPECT_EQ(check_refusal(nowhere), nowhere + ": cannot write: the directory does not exist");
  EXPECT_EQ(write_refusal(nowhere), nowhere + ": cannot write: No such file or directory");
}

TEST(WriteFileAtomically, WritesToDevicesAndPipesAsTheyAre) {
  const test::TemporaryDirectory directory;
  for (const char* device : {"/dev/null", "/dev/full"}) check_output_can_be_written(device);
  write_file_atomically("/dev/null", "gone");
  EXPECT_EQ(write_refusal("/dev/full"), "/dev/full: cannot write: No space left on device");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  EXPECT_FALSE(is_file_output("/dev/full"));
  const std::string pipe = directory.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  check_output_can_be_written(pipe);
  write_file_atomically(pipe, "through");
  char got[16] = {};
  EXPECT_EQ(read(reader, got, sizeof got), 7);
  EXPECT_EQ(std::string(got), "through");
  close(reader);
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(directory.entries(), 1U);
}

TEST(WriteFileAtomically, WritesIntoADescriptorThatIsOpenBehindWhatIsThere) {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("log", "before ");
  const int file = open(path.c_str(), O_WRONLY | O_APPEND);
  ASSERT_GE(file, 0);
  for (const char* folder : {"/dev/fd/", "/proc/self/fd/"}) {
    const std::string name = folder + std::to_string(file);
    check_output_can_be_written(name);
    write_file_atomically(name, "new ");
  }
  fs::create_symlink("/dev/fd/" + std::to_string(file), directory.path("link"));
  write_file_atomically(directory.path("link"), "end");
  close(file);
  EXPECT_EQ(directory.contents("log"), "before new new end");
  const int reader = open(path.c_str(), O_RDONLY);
  const std::string name = "/dev/fd/" + std::to_string(reader);
  EXPECT_EQ(write_refusal(name), name + ": cannot write: is open only for reading");
  close(reader);
}

TEST(WriteFileAtomically, RefusesALinkThatLeadsNowhere) {
  const test::TemporaryDirectory directory;
  fs::create_symlink("nothing", directory.path("dangling"));
  fs::create_symlink("loop", directory.path("loop"));
  const std::string dangling = directory.path("dangling");
  const std::string loop = directory.path("loop");
  for (const auto& refusal : {check_refusal, write_refusal}) {
    EXPECT_EQ(refusal(dangling), dangling + ": cannot write: is a link to " +
                                     directory.path("nothing") + ", which does not exist");
    EXPECT_EQ(refusal(loop), loop + ": cannot write: Too many levels of symbolic links");
  }
  EXPECT_TRUE(fs::is_symlink(loop));
  EXPECT_EQ(directory.entries(), 2U);
}

TEST(WriteFileAtomically, KeepsPermissionsAndOwnerOfWhatItReplaces) {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("a", "old");
  fs::create_symlink("a", directory.path("link"));
  const bool is_root = geteuid() == 0;
  if (is_root) {
    ASSERT_EQ(chown(path.c_str(), 12, 34), 0);
  }
  for (const mode_t mode : {0640U, 0606U, 0444U}) {
    ASSERT_EQ(chmod(path.c_str(), mode), 0);
    write_file_atomically(directory.path("link"), "new");
    struct stat status{};
    ASSERT_EQ(stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777U, mode);
    EXPECT_EQ(status.st_uid, is_root ? 12U : geteuid());
    EXPECT_EQ(status.st_gid, is_root ? 34U : status.st_gid);
  }
  EXPECT_EQ(directory.contents("a"), "new");
}

TEST(WriteFileAtomically, ShowsStrangeNamesEscaped) {
  const test::TemporaryDirectory directory;
  const std::string path = directory.path("a\nb/c");
  EXPECT_EQ(check_refusal(path),
            directory.path() + R"(/a\x0ab/c: cannot write: the directory does not exist)");
}

TEST(WriteFileAtomically, KeepsTheOldFileWhereTheNewOneIsTooLarge) {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("report.html", "old");
  struct rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  struct rlimit small = before;
  small.rlim_cur = 4096;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string said = test::refusal_of<OutputError>([&] {
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
  const test::TemporaryDirectory directory;
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
  const test::TemporaryDirectory directory;
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
  {
    AtomicFiles().add(directory.path("a"), "never committed");
  }
  EXPECT_EQ(directory.contents("a"), "new a");
  EXPECT_EQ(directory.entries(), 2U);
}

TEST(AtomicFiles, GetTheirOldContentsBackWhereOneCannotTakeItsPlace) {
  const test::TemporaryDirectory directory;
  write_file_atomically(directory.path("a"), "old a");
  AtomicFiles files;
  files.add(directory.path("a"), "new a");
  files.add(directory.path("new"), "n");
  files.add(directory.path("b"), "b");
  fs::create_directory(directory.path("b"));  // meanwhile
  EXPECT_EQ(test::refusal_of<OutputError>([&] {
              files.commit();
              return 0;
            }),
            directory.path("b") + ": cannot write: Is a directory");
  EXPECT_EQ(directory.contents("a"), "old a");
  EXPECT_FALSE(fs::exists(directory.path("new")));
}

TEST(AtomicFiles, TakeTheirDirectoryBackWithThem) {
  const test::TemporaryDirectory directory;
  const std::string made = directory.path("out/2026");
  {
    AtomicFiles files;
    files.make_directory(made);
    files.add(made + "/a", "a");
  }
  EXPECT_EQ(directory.entries(), 0U);
  fs::create_directory(directory.path("out"));
  {
    AtomicFiles files;
    files.make_directory(made);
  }
  EXPECT_TRUE(fs::exists(directory.path("out"))) << "it was there before";
  EXPECT_FALSE(fs::exists(made));
  {
    AtomicFiles files;
    files.make_directory(made);
    files.add(made + "/a", "a");
    files.commit();
  }
  EXPECT_EQ(directory.contents("out/2026/a"), "a");
}

TEST(AtomicFiles, AreDifferentFiles) {
  const test::TemporaryDirectory directory;
  AtomicFiles files;
  files.add(directory.path("a"), "a");
  EXPECT_EQ(test::refusal_of<UsageError>([&] {
              files.add(directory.path() + "/./a", "b");
              return 0;
            }),
            directory.path() + "/./a: is stated for two outputs");
}

TEST(CheckOutput, RefusesOneFileForTwoOutputs) {
  const test::TemporaryDirectory directory;
  const auto is_refused = [&](const std::string& a, const std::string& b) {
    return !test::refusal_of<UsageError>([&] {
              check_outputs_differ({a, "", b});
              return 0;
            }).empty();
  };
  const std::string a = directory.path("a");
  EXPECT_TRUE(is_refused(a, a)) << "that does not exist";
  EXPECT_TRUE(is_refused(a, directory.path() + "/./a"));
  EXPECT_FALSE(is_refused(a, directory.path("b")));
  ASSERT_EQ(directory.file("a", ""), a);
  fs::create_symlink("a", directory.path("link"));
  fs::create_hard_link(a, directory.path("hard"));
  fs::create_symlink(".", directory.path("here"));
  for (const char* name : {"a", "link", "hard", "here/a"}) {
    EXPECT_TRUE(is_refused(a, directory.path(name))) << name;
  }
  EXPECT_TRUE(is_refused(directory.path("b"), directory.path("here/b")));
  EXPECT_TRUE(is_refused("-", "-"));
  EXPECT_TRUE(is_refused("-", "/dev/stdout"));
  EXPECT_FALSE(is_refused("/dev/null", "/dev/null"));
}

TEST(CheckOutput, RefusesToOverwriteAnInput) {
  const test::TemporaryDirectory directory;
  const std::string input = directory.file("run.csv", "t");
  fs::create_symlink("run.csv", directory.path("link"));
  fs::create_hard_link(input, directory.path("hard"));
  for (const char* name : {"run.csv", "./run.csv", "link", "hard"}) {
    const std::string path = directory.path() + "/" + name;
    EXPECT_EQ(test::refusal_of<UsageError>([&] {
                check_output_can_be_written(path, {"nowhere", input});
                return 0;
              }),
              path + ": is also an input; it would be overwritten");
  }
  check_output_can_be_written(directory.path("other"), {input, ""});
  EXPECT_NE(test::refusal_of<UsageError>([&] {
              check_output_can_be_written(directory.path("new"), {directory.path() + "/./new"});
              return 0;
            }),
            "");
}

TEST(CreateDirectory, MakesThoseAboveToo) {
  const test::TemporaryDirectory directory;
  create_directory(directory.path("a/b/c"));
  EXPECT_TRUE(fs::is_directory(directory.path("a/b/c")));
  create_directory(directory.path("a/b/c"));
  const std::string file = directory.file("file", "");
  EXPECT_EQ(test::refusal_of<OutputError>([&] {
              create_directory(file);
              return 0;
            }),
            file + ": cannot create the directory: Not a directory");
}

}  // namespace
}  // namespace tribolog::atomic_file_test
