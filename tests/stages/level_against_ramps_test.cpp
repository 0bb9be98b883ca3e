// The level of loops that creep is no break-away torque.

#include "stages/level_against_ramps.h"

#include <gtest/gtest.h>

namespace tribolog {
namespace {

LuGreFit fit_with_level(double static_Nm) {
  LuGreParameter level;
  level.name = "static_Nm";
  level.estimate = symmetric_estimate(static_Nm, 0.1, "fit");
  LuGreFit fit;
  fit.converged = true;
  fit.parameters = {level};
  return fit;
}

BreakAwayResult ramps_that_held(double rising_Nm, double falling_Nm) {
  BreakAwayRamp up;
  up.is_rising = true;
  up.friction_Nm = rising_Nm;
  BreakAwayRamp down;
  down.friction_Nm = falling_Nm;
  BreakAwayResult out;
  out.ramps = {up, down};
  return out;
}

TEST(LevelAgainstRamps, IsNoStaticTorqueWhereTheJointHoldsMore) {
  const LuGreFit fit = against_ramps(fit_with_level(5.5), ramps_that_held(12, 11));
  EXPECT_FALSE(fit.shown("static_Nm"));
  EXPECT_NE(fit.parameters[0].why_not.find("holds 11 N·m without sliding"), std::string::npos);
  EXPECT_FALSE(fit.parameters[0].experiment.empty());
}

TEST(LevelAgainstRamps, StaysWhereTheyAgreeOrSayNothing) {
  EXPECT_TRUE(against_ramps(fit_with_level(5.5), ramps_that_held(5.5, 5.4)).shown("static_Nm"));
  EXPECT_TRUE(against_ramps(fit_with_level(5.5), {}).shown("static_Nm"));
  // One direction alone may have been helped by gravity.
  EXPECT_TRUE(against_ramps(fit_with_level(5.5), ramps_that_held(12, 0)).shown("static_Nm"));
}

// Ten readings about one torque: the largest of them is noise, not friction.
TEST(LevelAgainstRamps, StaysWhereRampsScatterAboutIt) {
  BreakAwayResult ramps;
  for (const double off : {-0.3, -0.1, 0.0, 0.1, 0.3}) {
    for (const bool is_rising : {true, false}) {
      BreakAwayRamp ramp;
      ramp.is_rising = is_rising;
      ramp.broke_away = true;
      ramp.friction_Nm = 5.5 + off;
      ramps.ramps.push_back(ramp);
    }
  }
  ramps.rising_Nm = ramps.falling_Nm = symmetric_estimate(5.5, 0.28, "scatter of the ramps");
  EXPECT_TRUE(against_ramps(fit_with_level(5.5), ramps).shown("static_Nm"));
  // One that ended without sliding is a bound, whatever the others say.
  ramps.ramps[0].broke_away = ramps.ramps[1].broke_away = false;
  ramps.ramps[0].friction_Nm = ramps.ramps[1].friction_Nm = 7;
  EXPECT_FALSE(against_ramps(fit_with_level(5.5), ramps).shown("static_Nm"));
}

}  // namespace
}  // namespace tribolog
