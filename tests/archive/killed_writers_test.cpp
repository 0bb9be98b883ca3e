// Processes that are killed while they archive: what one of them was told is archived is there.

#include <array>
#include <csignal>
#include <cstdio>
#include <set>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "archive/sample_calibration.h"
#include "archive/store/archive_location.h"
#include "base/temporary_directory.h"
#include "statistics/random_stream.h"
#include "support/breadth.h"

namespace tribolog::archive::killed_writers_test {
namespace {

const std::string now = "2026-12-24T12:00:00Z";
constexpr std::size_t id_digits = 64;

/// Archives one calibration after the other, and writes each id to the pipe once add() is back.
[[noreturn]] void archive_until_killed(const std::string& path, int pipe, int writer) {
  for (int k = 0;; ++k) {
    calibration::NewCalibration c =
        test::sample_calibration(writer, k % 6, k % 300, 0.4 + 1e-6 * k);
    c.documents.front().bytes += std::string(20000, static_cast<char>('a' + k % 26));
    const store::Added added =
        store::open_archive(path, sql::Access::write, 60'000).add(c, false, now);
    if (::write(pipe, added.id.data(), id_digits) != static_cast<ssize_t>(id_digits)) ::_exit(1);
  }
}

/// Empties the pipe into the set.
void take_acknowledged(int pipe, std::set<std::string>& ids) {
  std::array<char, id_digits> id{};
  while (::read(pipe, id.data(), id.size()) == static_cast<ssize_t>(id.size())) {
    ids.emplace(id.data(), id.size());
  }
}

TEST(KilledWriters, LoseNothingThatWasAcknowledged) {
  const auto kills = static_cast<int>(test::seeds_of(125, 1000));
  constexpr std::size_t writers = 4;
  constexpr double longest_life_ms = 160;
  const test::TemporaryDirectory directory;
  const std::string path = directory.path("a.tribolog");
  (void)store::open_archive(path, sql::Access::write);
  int pipe[2];
  ASSERT_EQ(::pipe2(pipe, O_CLOEXEC), 0);
  ::fcntl(pipe[0], F_SETFL, O_NONBLOCK);
  std::array<pid_t, writers> children{};
  int started = 0;
  const auto start = [&] {
    const int writer = started++;
    const pid_t child = ::fork();
    if (child == 0) archive_until_killed(path, pipe[1], writer);
    return child;
  };
  for (pid_t& child : children) child = start();
  statistics::RandomStream random(20261122, 0);
  std::set<std::string> acknowledged;
  int unexpected = 0;
  for (int k = 0; k < kills; ++k) {
    ::usleep(static_cast<useconds_t>(1e3 * longest_life_ms / writers * random.uniform()));
    pid_t& victim = children[static_cast<std::size_t>(k) % writers];
    ::kill(victim, SIGKILL);
    int status = 0;
    ::waitpid(victim, &status, 0);
    unexpected += WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL ? 0 : 1;
    take_acknowledged(pipe[0], acknowledged);
    victim = start();
  }
  for (const pid_t child : children) {
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }
  take_acknowledged(pipe[0], acknowledged);
  EXPECT_EQ(unexpected, 0) << "a writer ended by itself";

  store::CalibrationArchive archive = store::open_archive(path, sql::Access::write);
  const store::Verification outcome = archive.verify("", {});
  EXPECT_TRUE(outcome.faults.empty()) << outcome.faults.front();
  std::set<std::string> kept;
  for (const calibration::Measured& measured : archive.measured({})) {
    kept.insert(measured.entry.id);
    EXPECT_EQ(measured.quantities.size(), 2U);
  }
  std::size_t lost = 0;
  for (const std::string& id : acknowledged) lost += kept.count(id) == 0 ? 1 : 0;
  EXPECT_EQ(lost, 0U);
  EXPECT_GT(acknowledged.size(), test::seeds_of(6, 50)) << "too busy a machine to show anything";
  // Each writer has at most one that was kept and not told any more.
  EXPECT_LE(kept.size(), acknowledged.size() + static_cast<std::size_t>(started));
  std::printf("%d kills, %zu acknowledged, %zu kept\n", kills, acknowledged.size(), kept.size());
  archive.add(test::sample_calibration(-1, 0, 0, 0.4), false, now);  // and the journal goes
  for (const auto& entry : std::filesystem::directory_iterator(directory.path())) {
    EXPECT_EQ(entry.path().filename(), "a.tribolog");
  }
}

}  // namespace
}  // namespace tribolog::archive::killed_writers_test
