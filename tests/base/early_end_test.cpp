// Processes that are ended by signals; each is a child of the test.

#include "base/early_end.h"

#include <algorithm>
#include <csignal>
#include <functional>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/atomic_file.h"
#include "base/temporary_directory.h"

namespace tribolog::early_end_test {
namespace {

using test::TemporaryDirectory;

/// What a process said to standard error, and how it ended.
struct Ended {
  std::string said;
  int status{};
};

/// A child that works until it says that it is ready, and then gets signals until it has ended.
Ended ended_by(int signal, int times, const std::function<void()>& work) {
  int ready[2];
  int errors[2];
  EXPECT_EQ(pipe(ready), 0);
  EXPECT_EQ(pipe(errors), 0);
  const pid_t child = fork();
  if (child == 0) {
    dup2(errors[1], STDERR_FILENO);
    close(errors[0]);
    close(errors[1]);
    std::signal(signal, SIG_DFL);  // a shell's job in the background ignores SIGINT
    end_cleanly_on_signals();
    work();
    EXPECT_EQ(write(ready[1], "r", 1), 1);
    while (true) pause();
  }
  close(ready[1]);
  close(errors[1]);
  char byte = 0;
  EXPECT_EQ(read(ready[0], &byte, 1), 1);
  close(ready[0]);
  Ended ended;
  for (int k = 0; k < times; ++k) {
    kill(child, signal);
    usleep(100'000);  // two at once would be one
  }
  waitpid(child, &ended.status, 0);
  char text[4096];
  const ssize_t got = read(errors[0], text, sizeof text);
  ended.said.assign(text, static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  close(errors[0]);
  return ended;
}

TEST(EarlyEnd, RemembersNothingForAProgramThatDoesNotAsk) {
  const test::TemporaryDirectory directory;
  write_file_atomically(directory.path("page"), "new");
  EXPECT_FALSE(is_something_kept()) << kept_in_words();
}

TEST(EarlyEnd, RemovesWhatIsUnfinishedAndSaysThatNothingWasChanged) {
  const test::TemporaryDirectory directory;
  ASSERT_NE(directory.file("page", "old"), "");
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
    const Ended ended = ended_by(signal, 1, [&] {
      auto* files = new AtomicFiles;
      files->make_directory(directory.path("new/folder"));
      files->add(directory.path("new/folder/a"), "a");
      files->add(directory.path("page"), "new");
    });
    EXPECT_TRUE(WIFSIGNALED(ended.status) && WTERMSIG(ended.status) == signal) << ended.status;
    EXPECT_EQ(ended.said.find("tribolog: ended by signal " + std::to_string(signal) + " ("), 0U)
        << ended.said;
    EXPECT_TRUE(ended.said.ends_with("); nothing was changed\n")) << ended.said;
    EXPECT_EQ(directory.contents("page"), "old");
    EXPECT_EQ(directory.entries(), 1U);
  }
}

TEST(EarlyEnd, SaysWhatWasKept) {
  const test::TemporaryDirectory directory;
  const Ended ended =
      ended_by(SIGTERM, 1, [&] { write_file_atomically(directory.path("page"), "new"); });
  EXPECT_TRUE(ended.said.ends_with("; kept: " + directory.path("page") + "\n")) << ended.said;
  EXPECT_EQ(directory.contents("page"), "new");
}

TEST(EarlyEnd, WaitsForWhatBelongsTogetherButNotAtTheSecondSignal) {
  const test::TemporaryDirectory directory;
  const Ended ended = ended_by(SIGINT, 2, [&] { new Uninterrupted; });
  EXPECT_TRUE(WIFSIGNALED(ended.status) && WTERMSIG(ended.status) == SIGINT) << ended.status;
  EXPECT_EQ(ended.said, "");
}

TEST(EarlyEnd, LeavesASignalThatIsIgnoredIgnored) {
  const test::TemporaryDirectory directory;
  const auto before = std::signal(SIGHUP, SIG_IGN);
  const pid_t child = fork();
  if (child == 0) {
    end_cleanly_on_signals();
    kill(getpid(), SIGHUP);
    usleep(100'000);
    _exit(7);
  }
  std::signal(SIGHUP, before);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 7) << status;
}

}  // namespace
}  // namespace tribolog::early_end_test
