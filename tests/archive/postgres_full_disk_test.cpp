// A server whose disk is full.

#include <filesystem>
#include <random>

#include <pwd.h>
#include <sys/mount.h>
#include <unistd.h>

#include "archive/postgres_archive.h"
#include "archive/sample_calibration.h"

namespace tribolog::archive::postgres_full_disk_test {
namespace {

using test::PostgresArchive;
using test::PostgresServer;
using test::sample_calibration;

const std::string now = "2026-12-24T12:00:00Z";

class PostgresDisk : public test::PostgresArchive {};

TEST_F(PostgresDisk, AFullDiskIsAnOutputErrorAndKeepsNothing) {
  const std::string uri = server_.new_database();
  store::CalibrationArchive archive = store::open_archive(uri, sql::Access::write);
  // What the server answers when it cannot make a file longer.
  server_.run(
      "CREATE FUNCTION no_space() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN RAISE EXCEPTION "
      "'could not extend file: No space left on device' USING ERRCODE = 'disk_full'; END $$;"
      "CREATE TRIGGER no_space BEFORE INSERT ON event EXECUTE FUNCTION no_space()",
      uri);
  expect(refusal_of([&] { archive.add(test::sample_calibration(1, 2, 3, 0.45), false, now); }),
         ExitStatus::output_failed, "no space left");
  EXPECT_TRUE(archive.list({}).empty());
  server_.run("DROP TRIGGER no_space ON event", uri);
  EXPECT_TRUE(archive.add(test::sample_calibration(1, 2, 3, 0.45), false, now).is_new);
  EXPECT_TRUE(archive.verify("", {}).faults.empty());
}

/// A disk of its own for a database; the server's log of changes is elsewhere.
class SmallTablespace {
 public:
  explicit SmallTablespace(test::PostgresServer& server) : server_(server) {
    is_mounted_ = mount("tmpfs", disk_.path().c_str(), "tmpfs", 0, "size=20m,mode=777") == 0;
    if (!is_mounted_) return;
    const passwd* const owner = getpwnam("postgres");
    const std::string own = disk_.file("own");
    std::filesystem::create_directory(own);
    if (owner == nullptr || chown(own.c_str(), owner->pw_uid, owner->pw_gid) != 0) {
      throw std::runtime_error("no directory for the server");
    }
    std::filesystem::permissions(disk_.path(), std::filesystem::perms{0755});
    server_.run("CREATE TABLESPACE small LOCATION '" + own + "'", server_.uri("postgres"));
    uri_ = server_.new_database("TABLESPACE small");
  }
  SmallTablespace(const SmallTablespace&) = delete;
  SmallTablespace& operator=(const SmallTablespace&) = delete;
  ~SmallTablespace() {
    if (!is_mounted_) return;
    // A server from which a disk is taken away stops.
    const std::string name = uri_.substr(uri_.rfind('/') + 1);
    for (const std::string& drop : {"DATABASE " + name, std::string("TABLESPACE small")}) {
      EXPECT_NO_THROW(server_.run("DROP " + drop, server_.uri("postgres")));
    }
    EXPECT_EQ(umount(disk_.path().c_str()), 0);
  }
  [[nodiscard]] bool is_mounted() const { return is_mounted_; }
  [[nodiscard]] const std::string& uri() const { return uri_; }

 private:
  test::PostgresServer& server_;
  test::ScratchDirectory disk_;
  bool is_mounted_{false};
  std::string uri_;
};

TEST_F(PostgresDisk, ADiskThatBecomesFullKeepsWhatWasAcknowledged) {
  const SmallTablespace small(server_);
  if (!small.is_mounted()) GTEST_SKIP() << "cannot mount a file system here";
  store::CalibrationArchive archive = store::open_archive(small.uri(), sql::Access::write);
  std::mt19937_64 random(3);
  std::size_t kept = 0;
  const Refusal refused = refusal_of([&] {
    for (;; ++kept) {
      calibration::NewCalibration large =
          test::sample_calibration(1, 2, static_cast<int>(kept), 0.45);
      std::string log;
      while (log.size() < 1'000'000) log += std::to_string(random());
      large.documents.push_back({calibration::DocumentKind::input, "log.csv", log});
      archive.add(large, false, now);
    }
  });
  expect(refused, ExitStatus::output_failed, "no space left for the archive");
  EXPECT_GT(kept, 2U);
  EXPECT_EQ(archive.list({}).size(), kept);
  EXPECT_TRUE(archive.verify("", {}).faults.empty());
}

}  // namespace
}  // namespace tribolog::archive::postgres_full_disk_test
