// The mean over a joint's ramps: its interval holds the truth as often as it says, and is not wider
// than that takes.

#include "method/hysteresis/ramp_mean.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"

namespace tribolog::ramp_mean_test {
namespace {

using method::hysteresis::FrictionOverTurn;
using method::hysteresis::mean_of_ramps;
using method::hysteresis::RampMeans;
using method::hysteresis::RampRow;

constexpr double true_Nm = 2.5;

/// Ramps of either direction at each of some motor angles, equally far from one another.
struct Plan {
  std::size_t angles{1};
  std::size_t each{3};
  double scatter{0.01};    ///< Standard deviation, as a share.
  double of_turn{0};       ///< Amplitude, once a turn, as a share.
  double of_angle{0};      ///< Of each angle's own, standard deviation.
  double largest_Nm{1e9};  ///< Ramps end there.
  bool both_directions{true};
};

std::vector<RampRow> ramps_of(const Plan& plan, statistics::RandomStream& random) {
  std::vector<RampRow> rows;
  const double phase = 2 * std::numbers::pi * random.uniform();
  for (std::size_t a = 0; a < plan.angles; ++a) {
    const double angle = 2.3 * static_cast<double>(a);
    const double here =
        true_Nm * (1 + plan.of_turn * std::cos(angle + phase) + plan.of_angle * random.normal());
    for (std::size_t k = 0; k < plan.each; ++k) {
      for (const bool is_rising : {true, false}) {
        if (!is_rising && !plan.both_directions) continue;
        RampRow row;
        row.is_rising = is_rising;
        row.position = a;
        row.motor_angle_rad = angle;
        row.held_Nm = here + true_Nm * plan.scatter * random.normal();
        row.broke_away = row.held_Nm < plan.largest_Nm;
        row.held_Nm = std::min(row.held_Nm, plan.largest_Nm);
        rows.push_back(row);
      }
    }
  }
  return rows;
}

struct Record {
  double inside{};      ///< Share.
  double half_width{};  ///< Mean, as a share.
  double error{};       ///< Mean, as a share.
  double rms{};
};

Record record_of(const Plan& plan, const FrictionOverTurn& over_turn) {
  statistics::RandomStream random(11, 4);
  Record all;
  constexpr int times = 300;
  int made = 0;
  for (int k = 0; k < times; ++k) {
    const RampMeans means = mean_of_ramps(ramps_of(plan, random), over_turn);
    const auto& found = plan.both_directions ? means.both_Nm : means.rising_Nm;
    if (!found) continue;
    ++made;
    all.inside += found->low <= true_Nm && true_Nm <= found->high ? 1 : 0;
    all.half_width += found->half_width() / true_Nm;
    all.error += found->value / true_Nm - 1;
    all.rms += std::pow(found->value / true_Nm - 1, 2);
  }
  for (double* one : {&all.inside, &all.half_width, &all.error, &all.rms}) *one /= made;
  all.rms = std::sqrt(all.rms);
  return all;
}

TEST(RampMean, ScatterAlone) {
  for (const std::size_t each : {1U, 2U, 4U, 12U}) {
    const Record found = record_of({each == 1 ? 2U : 1U, each}, {});
    EXPECT_NEAR(found.inside, 0.95, 0.035) << each;
    // Student's, of the freedom that two directions leave.
    const double ideal = 1.96 * found.rms;
    EXPECT_GT(found.half_width, 0.9 * ideal) << each;
    EXPECT_LT(found.half_width, (each == 1 ? 4 : each == 2 ? 2.4 : 1.4) * ideal) << each;
  }
}

TEST(RampMean, OneDirection) {
  Plan plan{1, 3};
  plan.both_directions = false;
  EXPECT_NEAR(record_of(plan, {}).inside, 0.95, 0.035);
  statistics::RandomStream random(1, 1);
  const RampMeans means = mean_of_ramps(ramps_of(plan, random), {});
  EXPECT_FALSE(means.falling_Nm);
  EXPECT_FALSE(means.both_Nm);
}

TEST(RampMean, OfAnOrderThatTheSweepShows) {
  FrictionOverTurn over_turn;
  over_turn.orders = {{1, 0.08, 0}};
  for (const std::size_t angles : {1U, 2U, 3U, 6U}) {
    Plan plan{angles, 2};
    plan.of_turn = 0.08;
    const Record found = record_of(plan, over_turn);
    EXPECT_GE(found.inside, 0.9) << angles;  // of a sine, whose ends are most likely
    // A phase that three angles show costs no width.
    EXPECT_LT(found.half_width, angles < 3 ? 0.13 : 0.025) << angles;
  }
}

TEST(RampMean, AnglesThatDifferOfThemselves) {
  FrictionOverTurn over_turn;
  over_turn.share = 0.01;
  for (const double of_angle : {0.003, 0.01, 0.03}) {
    Plan plan{6, 2};
    plan.of_angle = of_angle;
    const Record found = record_of(plan, over_turn);
    // Three times as large as is typical happens, but not often.
    EXPECT_GE(found.inside, of_angle > 0.02 ? 0.87 : 0.92) << of_angle;
    EXPECT_LT(found.half_width, 1.7 * 1.96 * found.rms + 0.002) << of_angle;
  }
  // At one angle that is not seen: as wide as it may be.
  Plan plan{1, 3};
  plan.of_angle = 0.01;
  EXPECT_GE(record_of(plan, over_turn).inside, 0.95);
}

/// Half of the ramps end before: the others are the weaker half.
TEST(RampMean, RampsThatEndEarlyDoNotPullTheMeanDown) {
  Plan plan{1, 12, 0.03};
  plan.largest_Nm = true_Nm;
  const Record found = record_of(plan, {});
  EXPECT_NEAR(found.error, 0, 0.006);  // of those that broke away alone: -2.4 %
  EXPECT_GE(found.inside, 0.9);
  EXPECT_LT(found.half_width, 0.05);
}

/// A ramp that held far more than the others broke away at is a contradiction, and no certainty.
TEST(RampMean, ABoundFarAbove) {
  std::vector<RampRow> rows;
  for (const double held : {1.0, 1.01, 0.99, 1.005}) {
    RampRow row;
    row.held_Nm = held;
    rows.push_back(row);
  }
  const double alone = mean_of_ramps(rows, {}).falling_Nm->half_width();
  for (const double bound : {1.5, 100.0}) {
    std::vector<RampRow> with = rows;
    with.push_back(rows.front());
    with.back().broke_away = false;
    with.back().held_Nm = bound;
    const RampMeans means = mean_of_ramps(with, {});
    ASSERT_TRUE(means.falling_Nm);
    EXPECT_TRUE(std::isfinite(means.falling_Nm->value));
    EXPECT_GT(means.falling_Nm->half_width(), 5 * alone) << bound;
  }
  // One far below says nothing.
  rows.push_back(rows.front());
  rows.back().broke_away = false;
  rows.back().held_Nm = 0.5;
  EXPECT_NEAR(mean_of_ramps(rows, {}).falling_Nm->half_width(), alone, 0.1 * alone);
}

/// What shifts all ramps together does not average; gravity cancels between the directions.
TEST(RampMean, InCommon) {
  std::vector<RampRow> rows;
  for (int k = 0; k < 40; ++k) {
    RampRow row;
    row.is_rising = k % 2 == 0;
    row.held_Nm = true_Nm * (1 + 1e-3 * ((k / 2) % 2 == 0 ? 1 : -1));
    row.inertia_Nm = 0.1;
    row.gravity_Nm = row.is_rising ? 0.2 : -0.2;
    rows.push_back(row);
  }
  const RampMeans means = mean_of_ramps(rows, {});
  ASSERT_TRUE(means.both_Nm && means.rising_Nm);
  EXPECT_NEAR(means.both_Nm->half_width(), 0.1, 0.01);
  EXPECT_NEAR(means.rising_Nm->half_width(), std::hypot(0.1, 0.2), 0.02);
  EXPECT_NEAR(means.both_Nm->value, true_Nm, 1e-3);
}

/// Units, and which direction is called rising, change nothing.
TEST(RampMean, Symmetries) {
  statistics::RandomStream random(5, 2);
  Plan plan{4, 2};
  plan.of_angle = 0.02;
  const FrictionOverTurn over_turn{{{1, 0.03, 0}}, 0.01, 0.005};
  const std::vector<RampRow> rows = ramps_of(plan, random);
  const RampMeans plain = mean_of_ramps(rows, over_turn);
  std::vector<RampRow> other = rows;
  for (RampRow& row : other) {
    row.held_Nm *= 1000;
    row.is_rising = !row.is_rising;
  }
  const RampMeans turned = mean_of_ramps(other, over_turn);
  EXPECT_NEAR(turned.both_Nm->value, 1000 * plain.both_Nm->value, 1e-4 * turned.both_Nm->value);
  EXPECT_NEAR(turned.rising_Nm->value, 1000 * plain.falling_Nm->value,
              1e-4 * turned.rising_Nm->value);
  EXPECT_NEAR(turned.both_Nm->half_width(), 1000 * plain.both_Nm->half_width(),
              0.02 * turned.both_Nm->half_width());
  EXPECT_NEAR(plain.between_positions, 0.02, 0.02);
  EXPECT_EQ(plain.positions, 4U);
}

TEST(RampMean, TooFew) {
  EXPECT_FALSE(mean_of_ramps({}, {}).both_Nm);
  RampRow one;
  one.held_Nm = true_Nm;
  EXPECT_FALSE(mean_of_ramps({one}, {}).falling_Nm);
  RampRow bound = one;
  bound.broke_away = false;
  EXPECT_FALSE(mean_of_ramps({one, bound, bound}, {}).falling_Nm);
  EXPECT_TRUE(mean_of_ramps({one, one}, {}).falling_Nm);
}

}  // namespace
}  // namespace tribolog::ramp_mean_test
