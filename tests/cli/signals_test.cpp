// Signals that end the program while it draws: what they leave, and what is said.

#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/small_dataset.h"

namespace tribolog::test::signals_test {
namespace {

namespace fs = std::filesystem;

bool comes_true(const std::function<bool()>& condition) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::seconds(60);
  while (Clock::now() < deadline) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

/// A report that hangs in drawing a figure.
class HangingReport : public testing::Test {
 protected:
  void start(const std::string& figure, const std::string& options = "") {
    dataset_.scratch().write("r.html", "old page");
    dataset_.scratch().write("r.calibration.json", "old numbers");
    const std::string command =
        "cd '" + folder() + "' && exec env TRIBOLOG_TEST_HANG_FIGURE=" + figure +
        " TRIBOLOG_TEST_MARK='" + folder() + "' " + program +
        "report --truth-runs 0 dataset.toml -o r.html " + options + " 2>err";
    process_ = fork();
    if (process_ == 0) {
      std::signal(SIGINT, SIG_DFL);  // a shell's job in the background ignores it
      execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      _exit(127);
    }
  }
  void TearDown() override {
    if (process_ <= 0) return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }

  int end_by(int signal) {
    kill(process_, signal);
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    return status;
  }

  [[nodiscard]] std::string folder() const { return dataset_.scratch().path(); }
  [[nodiscard]] std::string errors() const { return read_text(dataset_.file("err")); }
  [[nodiscard]] int temporary_files() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder())) {
      count += entry.path().string().find(".tmp-") != std::string::npos ? 1 : 0;
    }
    return count;
  }
  [[nodiscard]] int processes() const {
    int count = 0;
    const std::string mark = "TRIBOLOG_TEST_MARK=" + folder();
    std::error_code error;
    for (const auto& entry : fs::directory_iterator("/proc", error)) {
      const std::string environment = read_text((entry.path() / "environ").string());
      count += environment.find(mark) != std::string::npos ? 1 : 0;
    }
    return count;
  }
  void expect_old_files() const {
    EXPECT_EQ(read_text(dataset_.file("r.html")), "old page");
    EXPECT_EQ(read_text(dataset_.file("r.calibration.json")), "old numbers");
  }
  void expect_last_words(const std::string& words) const {
    const std::string said = errors();
    EXPECT_TRUE(said.ends_with(words + "\n")) << said;
  }

  SmallDataset dataset_;
  pid_t process_{-1};
};

TEST_F(HangingReport, LeavesTheOldFilesAndNoOthersAtEverySignal) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
    start("warm-up");
    ASSERT_TRUE(comes_true([&] { return temporary_files() > 0; })) << errors();
    const int status = end_by(signal);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_EQ(temporary_files(), 0);
    expect_old_files();
    expect_last_words("; nothing was changed");
    EXPECT_TRUE(comes_true([&] { return processes() == 0; }));
  }
}

TEST_F(HangingReport, SaysThatTheArchiveKeepsTheNumbers) {
  start("warm-up", "--archive a.tribolog");
  ASSERT_TRUE(comes_true([&] { return temporary_files() > 0; }));
  ASSERT_TRUE(comes_true([&] {
    return run_shell(program + "archive list --archive '" + dataset_.file("a.tribolog") + "'")
               .out.find("test robot") != std::string::npos;
  })) << errors();
  end_by(SIGTERM);
  expect_old_files();
  EXPECT_NE(
      errors().find(
          "; kept: the new archive a.tribolog, changes of the archive a.tribolog, its entry "),
      std::string::npos)
      << errors();
}

TEST_F(HangingReport, TakesItsDrawingProcessesWithItEvenWhenKilled) {
  const ProgramRun figures = run_shell("cd '" + folder() + "' && " + program +
                                       "figures --truth-runs 0 --format svg dataset.toml -o f");
  ASSERT_EQ(figures.status, 0) << figures.err;
  const std::string first = fs::directory_iterator(dataset_.file("f"))->path().stem().string();
  start(first);
  // The program, the process that started the graphics stack, and the one that draws.
  ASSERT_TRUE(comes_true([&] { return processes() >= 3; })) << errors();
  end_by(SIGKILL);
  EXPECT_TRUE(comes_true([&] { return processes() == 0; })) << processes();
  expect_old_files();
}

}  // namespace
}  // namespace tribolog::test::signals_test
