#include "method/motion/moving_part.h"

#include <cmath>

#include <gtest/gtest.h>

namespace tribolog::moving_part_test {
namespace {

TEST(MovingPart, CutsRestAndCountsIt) {
  joint::Recording r;
  for (int i = 0; i < 3000; ++i) {
    const double t = i * 1e-3;
    r.t_s.push_back(t);
    r.q_rad.push_back(t < 0.5 || t > 2.5 ? 0.2 : 0.2 + 0.01 * std::sin(2 * M_PI * (t - 0.5)));
    r.torque_Nm.push_back(t);
  }
  const joint::Recording moving = method::motion::moving_part(r);
  EXPECT_NEAR(moving.t_s.front(), 0.5, 0.01);
  EXPECT_NEAR(moving.t_s.back(), 2.5, 0.01);
  EXPECT_EQ(moving.torque_Nm.front(), moving.t_s.front());
  ASSERT_EQ(moving.skipped.size(), 1U);
  EXPECT_EQ(moving.size() + moving.skipped.front().count, r.size());
}

TEST(MovingPart, LeavesMotionFromTheFirstSampleAlone) {
  joint::Recording r;
  for (int i = 0; i < 1000; ++i) {
    r.t_s.push_back(i * 1e-3);
    r.q_rad.push_back(std::sin(2 * M_PI * i * 1e-3));
    r.torque_Nm.push_back(0);
  }
  EXPECT_EQ(method::motion::moving_part(r).size(), r.size());
}

}  // namespace
}  // namespace tribolog::moving_part_test
