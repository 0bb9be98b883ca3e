#include "friction/lugre.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "wording/words.h"

namespace tribolog::lugre_test {
namespace {

const friction::LuGreFriction joint({465.42, 0.7708, 0.001, 0.60, 0.88437633, 5.0});

TEST(LuGre, SlidesSteadilyWhereTheBristleRests) {
  for (const double w : {0.01, 1.0, 5.0, 300.0, -0.5, -80.0}) {
    const double z = (w > 0 ? 1 : -1) * joint.steady_deflection_rad(w);
    EXPECT_NEAR(joint.deflection_rate_rad_s(z, w), 0, 1e-12 * std::abs(w));
    EXPECT_NEAR(joint.torque_Nm(z, 0, w), joint.steady_torque_Nm(w), 1e-14);
  }
}

TEST(LuGre, SteadyTorqueFallsFromStaticToCoulomb) {
  // Hand-worked: at rest Ts, far beyond the Stribeck velocity Tc + s2 w.
  EXPECT_NEAR(joint.steady_torque_Nm(1e-6), 0.88437633, 1e-6);
  EXPECT_NEAR(joint.steady_torque_Nm(50), 0.60 + 0.05, 1e-12);
}

TEST(LuGre, RefusesCoulombAboveStatic) {
  try {
    friction::LuGreFriction({1, 0, 0, 1.4, 1.1, 1});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& e) {
    EXPECT_EQ(wording::words(e),
              "Coulomb torque 1.4 N·m exceeds static torque 1.1 N·m; it must not be larger");
  }
  EXPECT_THROW(friction::LuGreFriction({0, 0, 0, 1, 1, 1}), std::invalid_argument);
  EXPECT_THROW(friction::LuGreFriction({1, -1, 0, 1, 1, 1}), std::invalid_argument);
  EXPECT_THROW(friction::LuGreFriction({1, 0, 0, 1, 1, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::lugre_test
