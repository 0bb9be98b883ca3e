// A disk that is full or read-only: one clear line, and nothing changed.

#include <cerrno>
#include <csignal>
#include <cstring>

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include "archive/sample_calibration.h"
#include "archive/store/archive_location.h"
#include "base/error.h"
#include "base/temporary_directory.h"

namespace tribolog::archive::archive_faults_test {
namespace {

using test::refusal_of;

const std::string now = "2026-12-24T12:00:00Z";

/// Text that does not compress.
std::string noise(std::size_t bytes) {
  std::string text;
  for (int k = 0; text.size() < bytes; ++k) text += sha256_hex(std::to_string(k));
  return text;
}

class ArchiveOnASmallDisk : public testing::Test {
 protected:
  void SetUp() override {
    if (mount("tmpfs", disk_.path().c_str(), "tmpfs", 0, "size=1m") != 0) {
      GTEST_SKIP() << "cannot mount a file system here: " << std::strerror(errno);
    }
    is_mounted_ = true;
  }
  void TearDown() override {
    if (is_mounted_) umount(disk_.path().c_str());
  }
  [[nodiscard]] std::string path() const { return disk_.path("a.tribolog"); }

  test::TemporaryDirectory disk_;
  bool is_mounted_{false};
};

TEST_F(ArchiveOnASmallDisk, FullKeepsWhatWasAcknowledged) {
  std::size_t kept = 0;
  std::string said;
  store::CalibrationArchive archive = store::open_archive(path(), sql::Access::write);
  for (int day = 0; said.empty() && day < 100; ++day) {
    calibration::NewCalibration c = test::sample_calibration(1, 1, day, 0.4);
    c.documents.front().bytes += noise(80'000);
    try {
      archive.add(c, false, now);
      ++kept;
    } catch (const OutputError& error) {
      said = error.what();
    }
  }
  EXPECT_EQ(said, path() + ": no space left for the archive; nothing was changed");
  EXPECT_GT(kept, 2U);
  store::CalibrationArchive again = store::open_archive(path(), sql::Access::read);
  EXPECT_EQ(again.list({}).size(), kept);
  EXPECT_TRUE(again.verify("", {}).faults.empty());
  EXPECT_EQ(disk_.entries(), 1U);
}

TEST_F(ArchiveOnASmallDisk, FullMakesNoArchive) {
  (void)disk_.file("filler", std::string(1'040'000, 'x'));
  EXPECT_THROW((void)store::open_archive(path(), sql::Access::write), OutputError);
  EXPECT_EQ(disk_.entries(), 1U);
}

TEST(ArchiveBehindTheLimitOfFileSize, IsLeftAsItIsWithoutAJournal) {
  const test::TemporaryDirectory directory;
  const std::string path = directory.path("a.tribolog");
  store::open_archive(path, sql::Access::write)
      .add(test::sample_calibration(1, 1, 1, 0.4), false, now);
  const std::string before = directory.contents("a.tribolog");
  rlimit usual{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &usual), 0);
  const rlimit small{before.size() / 2, usual.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string said = test::refusal_of<OutputError>([&] {
    store::open_archive(path, sql::Access::write)
        .add(test::sample_calibration(1, 1, 2, 0.4), false, now);
    return 0;
  });
  setrlimit(RLIMIT_FSIZE, &usual);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(said, path + ": the archive cannot be written: File too large; nothing was changed");
  EXPECT_TRUE(directory.contents("a.tribolog") == before);
  EXPECT_EQ(directory.entries(), 1U);
}

TEST_F(ArchiveOnASmallDisk, ReadOnlyIsReadAndNotWritten) {
  store::open_archive(path(), sql::Access::write)
      .add(test::sample_calibration(1, 1, 1, 0.4), false, now);
  ASSERT_EQ(mount("tmpfs", disk_.path().c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, "size=1m"), 0);
  const std::string said = test::refusal_of<OutputError>([&] {
    (void)store::open_archive(path(), sql::Access::write);
    return 0;
  });
  EXPECT_EQ(said, path() +
                      ": the archive cannot be written: Read-only file system; nothing was "
                      "changed");
  store::CalibrationArchive readable = store::open_archive(path(), sql::Access::read);
  EXPECT_EQ(readable.list({}).size(), 1U);
  EXPECT_TRUE(readable.verify("", {}).faults.empty());
}

}  // namespace
}  // namespace tribolog::archive::archive_faults_test
