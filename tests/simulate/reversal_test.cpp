#include <cmath>

#include <gtest/gtest.h>

#include "simulate/motion.h"

namespace tribolog::reversal_test {
namespace {

TEST(Reversal, IsFoundToTheLastBit) {
  // cos(w t) changes its sign at a quarter of the period; the next number below is still before it.
  for (const double frequency : {0.1, 1.0, 7.3, 2000.0}) {
    const simulate::HarmonicMotion motion = simulate::HarmonicMotion::sine(0, 0.01, frequency);
    const double quarter = 0.25 / frequency;
    const double turn = simulate::reversal_time(motion, 0.3 * quarter, 1.9 * quarter, false);
    EXPECT_NEAR(turn, quarter, 1e-15 / frequency);
    EXPECT_LE(motion.speed(turn), 0);
    EXPECT_GE(motion.speed(std::nextafter(turn, 0)), 0);
  }
}

TEST(Reversal, AtTheStartIsThereWhateverSignRoundingGivesIt) {
  const simulate::HarmonicMotion motion = simulate::HarmonicMotion::sine(0, 0.01, 1);
  const double turn = std::nextafter(0.25, 1);  // the speed is backward here already
  ASSERT_LT(motion.speed(turn), 0);
  EXPECT_NEAR(simulate::reversal_time(motion, turn, 0.3, false), turn, 1e-15);
}

}  // namespace
}  // namespace tribolog::reversal_test
