// Stamps of writing in place of sampling must be found, and no clock that scatters as its samples
// did.

#include "method/motion/false_stamps.h"

#include <cmath>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"

namespace tribolog::false_stamps_test {
namespace {

constexpr double interval_s = 0.004;

double angle(double t) { return 0.3 * std::sin(2 * M_PI * 0.4 * t); }

struct Log {
  joint::Recording stamped;
  std::vector<double> sampled_s;
};

/// @param of_sampling whether the joint was sampled when the stamps say.
Log scattered(double scatter_s, bool of_sampling, double lost_share = 0) {
  statistics::RandomStream random(5, 1);
  Log log;
  log.stamped.name = "log.csv";
  for (int i = 0; i < 4000; ++i) {
    const double even = 10 + interval_s * i;
    const double stamp = even + scatter_s * random.normal();
    const double sampled = of_sampling ? stamp : even;
    const double q = angle(sampled) + 1e-6 * random.normal();
    if (random.uniform() < lost_share) continue;
    log.sampled_s.push_back(sampled);
    log.stamped.t_s.push_back(stamp);
    log.stamped.q_rad.push_back(q);
    log.stamped.torque_Nm.push_back(1);
  }
  return log;
}

TEST(FalseStamps, GiveWayToTheClockOfTheSampling) {
  for (const double lost : {0.0, 0.01}) {
    const Log log = scattered(0.1 * interval_s, false, lost);
    std::vector<joint::Recording> recordings{log.stamped};
    const auto found = method::motion::replace_false_stamps(recordings);
    EXPECT_EQ(found.replaced, log.stamped.size());
    EXPECT_EQ(found.recording, "log.csv");
    EXPECT_NEAR(found.worst_percent, 10, 0.5);
    EXPECT_NEAR(found.interval_s, interval_s, 1e-7);
    for (std::size_t i = 0; i < log.sampled_s.size(); ++i) {
      EXPECT_NEAR(recordings[0].t_s[i], log.sampled_s[i], 0.02 * interval_s) << i;
    }
  }
}

/// Some stamps lie behind the next sample then; readers sort them.
TEST(FalseStamps, OfMoreThanAQuarterOfTheIntervalToo) {
  Log log = scattered(0.28 * interval_s, false);
  std::vector<joint::Recording> recordings{log.stamped};
  EXPECT_EQ(method::motion::replace_false_stamps(recordings).replaced, log.stamped.size());
  EXPECT_NEAR(recordings[0].t_s.back(), log.sampled_s.back(), 0.1 * interval_s);
}

TEST(FalseStamps, AClockThatScattersAsItsSamplesDidIsNone) {
  std::vector<joint::Recording> recordings{scattered(0.1 * interval_s, true).stamped};
  const std::vector<double> stamps = recordings[0].t_s;
  EXPECT_EQ(method::motion::replace_false_stamps(recordings).replaced, 0U);
  EXPECT_EQ(recordings[0].t_s, stamps);
}

TEST(FalseStamps, NothingIsKnownOfAJointAtRestOrAClockTooWild) {
  Log resting = scattered(0.1 * interval_s, false);
  for (double& q : resting.stamped.q_rad) q = 0.1;
  std::vector<joint::Recording> recordings{resting.stamped, scattered(0, false).stamped};
  EXPECT_EQ(method::motion::replace_false_stamps(recordings).replaced, 0U);
  joint::Recording gap = scattered(0, false).stamped;  // an even clock with a hole is even
  gap.t_s.erase(gap.t_s.begin() + 1000, gap.t_s.begin() + 1300);
  gap.q_rad.erase(gap.q_rad.begin() + 1000, gap.q_rad.begin() + 1300);
  gap.torque_Nm.erase(gap.torque_Nm.begin() + 1000, gap.torque_Nm.begin() + 1300);
  recordings = {gap};
  EXPECT_EQ(method::motion::replace_false_stamps(recordings).replaced, 0U);
}

}  // namespace
}  // namespace tribolog::false_stamps_test
