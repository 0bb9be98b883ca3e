#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "friction/static_laws.h"
#include "support/paper_joint.h"

namespace tribolog::waiboer_test {
namespace {

TEST(Waiboer, PaperJointHasItsStatedStribeckCurve) {
  const friction::WaiboerFriction f = test::paper_curve();
  // Stated: 0.88 N·m at rest, 0.45 at the dip near 15 to 25 rad/s, 1.17 at 300 rad/s.
  EXPECT_NEAR(f.magnitude_Nm(0), 0.88, 0.005);
  EXPECT_NEAR(f.magnitude_Nm(300), 1.17, 0.01);
  double dip = 1e9;
  double at = 0;
  for (double w = 1; w < 300; w += 0.1) {
    if (f.magnitude_Nm(w) < dip) {
      dip = f.magnitude_Nm(w);
      at = w;
    }
  }
  EXPECT_NEAR(dip, 0.45, 0.05);
  EXPECT_GT(at, 10);
  EXPECT_LT(at, 25);
}

TEST(Waiboer, IsOddDissipativeAndStillAtRest) {
  const friction::WaiboerFriction f = test::paper_curve();
  EXPECT_EQ(f.torque_Nm(0), 0);
  for (double w = 1e-9; w < 1e3; w *= 3) {
    EXPECT_DOUBLE_EQ(f.torque_Nm(w), -f.torque_Nm(-w));
    EXPECT_GT(f.torque_Nm(w) * w, 0);
    EXPECT_LE(f.torque_Nm(w), f.magnitude_Nm(w));
  }
}

TEST(Waiboer, RefusesWhatCannotBe) {
  using P = friction::WaiboerFriction::Parameters;
  EXPECT_THROW(friction::WaiboerFriction(P{-1, 1, 1, 1, 0, 1e6}), std::invalid_argument);
  EXPECT_THROW(friction::WaiboerFriction(P{1, 0, 1, 1, 0, 1e6}), std::invalid_argument);
  EXPECT_THROW(friction::WaiboerFriction(P{1, 1, 1, 1, 1.0, 1e6}), std::invalid_argument);
  EXPECT_THROW(friction::WaiboerFriction(P{1, 1, std::nan(""), 1, 0, 1e6}), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::waiboer_test
