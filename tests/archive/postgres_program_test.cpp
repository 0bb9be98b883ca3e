// The program itself with an archive on a server, and what remains when it is killed.

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <mutex>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "archive/killed_writer.h"
#include "archive/store/archive_location.h"
#include "cli/small_dataset.h"
#include "support/breadth.h"
#include "support/postgres_server.h"

namespace tribolog::test::postgres_program_test {
namespace {

class PostgresProgram : public testing::Test {
 protected:
  void SetUp() override {
    if (!server_.why_not().empty()) GTEST_SKIP() << server_.why_not();
    uri_ = server_.new_database();
    const ProgramRun run = run_shell(program + "identify '" + dataset_.file("dataset.toml") +
                                     "' -o '" + calibration() + "' --truth-runs 0 --quiet");
    ASSERT_EQ(run.status, 0) << run.err;
  }
  [[nodiscard]] std::string calibration() const { return dataset_.file("calibration.json"); }
  [[nodiscard]] ProgramRun archive(const std::string& command) const {
    return run_shell(program + "archive " + command + " --archive '" + uri_ + "'");
  }

  PostgresServer& server_{PostgresServer::of_this_program()};
  SmallDataset dataset_;
  std::string uri_;
};

TEST_F(PostgresProgram, EveryCommandDoesTheSame) {
  EXPECT_EQ(archive("list").status, 3);
  const std::string report = dataset_.scratch().write("report.html", "<html>&#8451;</html>\r\n");
  const ProgramRun added = archive("add '" + calibration() + "' --report '" + report +
                                   "' --inputs '" + dataset_.scratch().path() + "'");
  ASSERT_EQ(added.status, 0) << added.err;
  const std::string id = added.out.substr(added.out.find(": ") + 2, calibration::shown_digits);
  EXPECT_NE(archive("add '" + calibration() + "'").out.find("already archived: " + id),
            std::string::npos);
  EXPECT_NE(archive("list --robot 'test robot'").out.find(id), std::string::npos);
  EXPECT_NE(archive("show " + id).out.find("test robot"), std::string::npos);
  EXPECT_NE(archive("show --json " + id).out.find("\"id\": \"" + id), std::string::npos);
  const std::string back = dataset_.file("back");
  const ProgramRun written =
      archive("report " + id + " -o '" + back + ".html' --calibration '" + back + ".json'");
  EXPECT_EQ(written.status, 0) << written.err;
  EXPECT_EQ(read_text(back + ".html"), read_text(report));
  EXPECT_EQ(read_text(back + ".json"), read_text(calibration()));
  const ProgramRun whole = archive("verify");
  EXPECT_EQ(whole.status, 0) << whole.err;
  const std::string head = whole.out.substr(whole.out.find("head: ") + 6, 64);
  EXPECT_EQ(archive("remove " + id).status, 2);
  EXPECT_EQ(archive("remove --yes " + id).status, 0);
  EXPECT_EQ(archive("verify --head " + head).status, 0);
  EXPECT_NE(archive("list").out.find("no calibrations"), std::string::npos);
  EXPECT_EQ(archive("backup -o '" + back + ".tribolog'").status, 2);
  server_.run("DELETE FROM event WHERE number = 1", uri_);
  EXPECT_EQ(archive("verify").status, 6);
}

TEST_F(PostgresProgram, NoPasswordInAnyOutput) {
  const std::string wrong = "postgresql://tribolog:secret@127.0.0.1:1/x";
  for (const char* const command : {"list", "verify", "add calibration.json", "show 0123456789"}) {
    const ProgramRun run = run_shell("cd '" + dataset_.scratch().path() + "' && " + program +
                                     "archive " + command + " --archive " + wrong);
    EXPECT_EQ(run.status, 6) << run.err;
    EXPECT_EQ((run.out + run.err).find("secret"), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
}

TEST_F(PostgresProgram, KilledAtAnyMomentItLosesNothingItAcknowledged) {
  using Time = std::chrono::microseconds;
  constexpr int writers = 4;
  const int kills_of_each = every_case() ? 80 : 6;
  constexpr std::size_t at_a_time = 3;
  const ScratchDirectory scratch;
  const std::vector<std::string> files =
      calibrations_like(read_text(calibration()), scratch.path(), every_case() ? 150 : 24);
  const WriterRun undisturbed = archive_and_kill({files[0]}, uri_, Time(60'000'000));
  ASSERT_EQ(undisturbed.ids.size(), 1U);

  std::mutex mutex;
  std::set<std::string> acknowledged = undisturbed.ids;
  int kills = 0;
  int kills_between_two = 0;  // something was acknowledged, something was not
  std::vector<std::thread> threads;
  for (int writer = 0; writer < writers; ++writer) {
    threads.emplace_back([&, writer] {
      std::mt19937 random(static_cast<unsigned>(writer));
      Time longest = undisturbed.took * 4;
      for (int killed = 0; killed < kills_of_each;) {
        std::vector<std::string> some;
        std::sample(files.begin(), files.end(), std::back_inserter(some), at_a_time, random);
        const WriterRun run =
            archive_and_kill(some, uri_, Time(random() % static_cast<unsigned>(longest.count())));
        killed += run.was_killed ? 1 : 0;
        if (!run.was_killed) longest = longest * 9 / 10;
        const std::lock_guard lock(mutex);
        EXPECT_EQ(run.status, 0);
        kills += run.was_killed ? 1 : 0;
        kills_between_two += run.was_killed && !run.ids.empty() ? 1 : 0;
        acknowledged.insert(run.ids.begin(), run.ids.end());
      }
    });
  }
  for (std::thread& thread : threads) thread.join();

  archive::store::CalibrationArchive kept =
      archive::store::open_archive(uri_, archive::sql::Access::read);
  const archive::store::Verification outcome = kept.verify("", {});
  EXPECT_TRUE(outcome.faults.empty()) << outcome.faults.front();
  EXPECT_EQ(outcome.documents, outcome.entries);
  std::set<std::string> there;
  for (const calibration::Entry& entry : kept.list({})) {
    there.insert(entry.id.substr(0, calibration::shown_digits));
  }
  std::vector<std::string> lost;
  std::set_difference(acknowledged.begin(), acknowledged.end(), there.begin(), there.end(),
                      std::back_inserter(lost));
  EXPECT_TRUE(lost.empty()) << lost.size() << " of " << acknowledged.size() << " are lost";
  EXPECT_EQ(kills, writers * kills_of_each);
  EXPECT_GT(kills_between_two, 0);
  EXPECT_GT(acknowledged.size(), every_case() ? files.size() / 4 : 2U)
      << "too busy a machine to show anything";
  std::printf("%d kills, %d of them between two calibrations; %zu acknowledged, %zu there\n", kills,
              kills_between_two, acknowledged.size(), there.size());

  // What was cut off is archived again, and nothing twice.
  const WriterRun rest = archive_and_kill(files, uri_, Time(600'000'000));
  EXPECT_EQ(rest.status, 0);
  EXPECT_EQ(kept.list({}).size(), files.size());
  EXPECT_TRUE(kept.verify(outcome.head, {}).faults.empty());
}

}  // namespace
}  // namespace tribolog::test::postgres_program_test
