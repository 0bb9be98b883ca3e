// 40 and 41: files that are large, or that change while they are read.

#include <atomic>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/inotify.h>
#include <sys/resource.h>
#include <unistd.h>

#include "cli/input_cases/case_log.h"
#include "cli/small_dataset.h"

namespace tribolog::test::changing_files_test {
namespace {

ProgramRun identify(const SmallDataset& dataset) {
  return run_shell("cd '" + dataset.scratch().path() + "' && " + program +
                   "--quiet identify dataset.toml -o c.json --truth-runs 0");
}

/// As long as the log, and some thirty times longer than what is read at a time at first.
std::string long_log() {
  std::string log = case_log();
  constexpr std::size_t bytes = 40'000'000;
  std::string rows;
  for (int i = 0; i < 1000; ++i) rows += "# a comment of a line, of which a log may have many\n";
  while (log.size() < bytes) log += rows;
  return log;
}

/// Does something to a file at the moment at which it is first read, and again until the end.
class WhileItIsRead {
 public:
  WhileItIsRead(const std::string& path, const std::function<void()>& change)
      : watch_(inotify_init1(IN_CLOEXEC)) {
    is_watched_ = watch_ >= 0 && inotify_add_watch(watch_, path.c_str(), IN_ACCESS) >= 0;
    thread_ = std::thread([this, change] {
      while (!is_done_) {
        pollfd ready{watch_, POLLIN, 0};
        constexpr int a_while_ms = 20;
        if (poll(&ready, 1, a_while_ms) < 1) continue;
        change();
        return;
      }
    });
  }
  ~WhileItIsRead() {
    is_done_ = true;
    thread_.join();
    if (watch_ >= 0) close(watch_);
  }
  WhileItIsRead(const WhileItIsRead&) = delete;
  WhileItIsRead& operator=(const WhileItIsRead&) = delete;
  [[nodiscard]] bool is_watched() const { return is_watched_; }

 private:
  int watch_;
  bool is_watched_{};
  std::atomic<bool> is_done_{false};
  std::thread thread_;
};

TEST(InputCase40, AnEndlessLineIsRefusedAtOnceAndInLittleMemory) {
  const SmallDataset dataset(case_manifest(), "t,q,tau\n0,0," + std::string(5'000'000, '1'));
  std::filesystem::resize_file(dataset.file("log.csv"), 800'000'000);  // takes no room on the disk
  const auto start = std::chrono::steady_clock::now();
  const ProgramRun run = identify(dataset);
  const auto took = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.err,
            "tribolog: error: log.csv:2: line is longer than 1 MiB, expected a text file of "
            "columns; hint: do its rows end with line ends?\n");
  EXPECT_LT(took, std::chrono::seconds(5));
#ifndef __SANITIZE_ADDRESS__  // which keeps what was freed
  rusage used{};
  ASSERT_EQ(getrusage(RUSAGE_CHILDREN, &used), 0);
  EXPECT_LT(used.ru_maxrss, 400'000) << "kB, of a file of 800 MB";
#endif
}

TEST(InputCase41, AGrowingLogIsReadAsFarAsItReachedAtTheStart) {
  const SmallDataset dataset(case_manifest(), long_log());
  const WhileItIsRead writer(dataset.file("log.csv"), [&dataset] {
    std::ofstream(dataset.file("log.csv"), std::ios::app) << "40.05,-0.8,2\n40.10,-0.8,2\n";
  });
  if (!writer.is_watched()) GTEST_SKIP() << "no inotify here";
  const ProgramRun run = identify(dataset);
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err,
            "tribolog: note: log.csv: the log is still being written; what was written after "
            "reading began is not included\n");
  const auto calibration = nlohmann::json::parse(read_text(dataset.file("c.json")));
  EXPECT_EQ(calibration.at("inputs").at(1).at("rows_read"), case_rows);
  EXPECT_EQ(calibration.at("inputs").at(1).at("bytes"), long_log().size());
}

TEST(InputCase41, ALogThatIsTruncatedMeanwhileIsRefused) {
  const SmallDataset dataset(case_manifest(), long_log());
  dataset.scratch().write("c.json", "last year's numbers");
  const std::string path = dataset.file("log.csv");
  const WhileItIsRead cutter(path, [&path] { std::filesystem::resize_file(path, 30'000); });
  if (!cutter.is_watched()) GTEST_SKIP() << "no inotify here";
  const ProgramRun run = identify(dataset);
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.err.find("tribolog: error: log.csv: file has become shorter while it was read, "
                         "found "),
            0U)
      << run.err;
  EXPECT_NE(run.err.find(" bytes, expected " + std::to_string(long_log().size()) +
                         "; hint: is it still being written? read a copy of it\n"),
            std::string::npos)
      << run.err;
  EXPECT_EQ(read_text(dataset.file("c.json")), "last year's numbers");
}

}  // namespace
}  // namespace tribolog::test::changing_files_test
