// The level of loops that creep is no break-away torque.

#include <gtest/gtest.h>

#include "method/hysteresis/break_away.h"
#include "wording/words.h"

namespace tribolog::level_against_ramps_test {
namespace {

method::hysteresis::LuGreFit fit_with_level(double static_Nm) {
  method::hysteresis::LuGreParameter level;
  level.name = "static_Nm";
  level.estimate = statistics::symmetric_estimate(static_Nm, 0.1);
  method::hysteresis::LuGreFit fit;
  fit.converged = true;
  fit.parameters = {level};
  return fit;
}

method::hysteresis::BreakAwayResult ramps_that_held(double rising_Nm, double falling_Nm) {
  method::hysteresis::BreakAwayRamp up;
  up.is_rising = true;
  up.friction_Nm = rising_Nm;
  method::hysteresis::BreakAwayRamp down;
  down.friction_Nm = falling_Nm;
  method::hysteresis::BreakAwayResult out;
  out.ramps = {up, down};
  return out;
}

TEST(LevelAgainstRamps, IsNoStaticTorqueWhereTheJointHoldsMore) {
  const method::hysteresis::LuGreFit fit =
      method::hysteresis::against_ramps(fit_with_level(5.5), ramps_that_held(12, 11));
  EXPECT_FALSE(fit.shown("static_Nm"));
  EXPECT_NE(wording::words(fit.parameters[0].why_not).find("holds 11 N·m without sliding"),
            std::string::npos);
  EXPECT_FALSE(fit.parameters[0].experiment.empty());
}

TEST(LevelAgainstRamps, TakesWhatWasReadFromItAlong) {
  method::hysteresis::LuGreFit fit = fit_with_level(5.5);
  for (const char* name : {"bristle_stiffness_Nm_rad", "coulomb_Nm", "stribeck_speed_rad_s"}) {
    method::hysteresis::LuGreParameter p = fit.parameters[0];
    p.name = name;
    fit.parameters.push_back(p);
  }
  method::hysteresis::LuGreParameter held;
  held.name = "speed_weakening_Nms2_rad2";
  held.why_not = Statement::verbatim("friction is the same at all speeds of the loops");
  fit.parameters.push_back(held);
  fit = method::hysteresis::against_ramps(fit, ramps_that_held(12, 11));
  EXPECT_TRUE(fit.shown("bristle_stiffness_Nm_rad"))
      << "the slope behind a reversal needs no level";
  EXPECT_FALSE(fit.shown("coulomb_Nm"));
  EXPECT_FALSE(fit.shown("stribeck_speed_rad_s"));
  for (const method::hysteresis::LuGreParameter& p : fit.parameters)
    EXPECT_EQ(p.estimate.has_value(), p.why_not.empty());
  EXPECT_EQ(fit.parameters.back().why_not, held.why_not);
}

TEST(LevelAgainstRamps, StaysWhereTheyAgreeOrSayNothing) {
  EXPECT_TRUE(method::hysteresis::against_ramps(fit_with_level(5.5), ramps_that_held(5.5, 5.4))
                  .shown("static_Nm"));
  EXPECT_TRUE(method::hysteresis::against_ramps(fit_with_level(5.5), {}).shown("static_Nm"));
  // One direction alone may have been helped by gravity.
  EXPECT_TRUE(method::hysteresis::against_ramps(fit_with_level(5.5), ramps_that_held(12, 0))
                  .shown("static_Nm"));
}

// Ten readings about one torque: the largest of them is noise, not friction.
TEST(LevelAgainstRamps, StaysWhereRampsScatterAboutIt) {
  method::hysteresis::BreakAwayResult ramps;
  for (const double off : {-0.3, -0.1, 0.0, 0.1, 0.3}) {
    for (const bool is_rising : {true, false}) {
      method::hysteresis::BreakAwayRamp ramp;
      ramp.is_rising = is_rising;
      ramp.broke_away = true;
      ramp.friction_Nm = 5.5 + off;
      ramps.ramps.push_back(ramp);
    }
  }
  ramps.rising_Nm = ramps.falling_Nm = statistics::symmetric_estimate(5.5, 0.28);
  EXPECT_TRUE(method::hysteresis::against_ramps(fit_with_level(5.5), ramps).shown("static_Nm"));
  // One that ended without sliding is a bound, whatever the others say.
  ramps.ramps[0].broke_away = ramps.ramps[1].broke_away = false;
  ramps.ramps[0].friction_Nm = ramps.ramps[1].friction_Nm = 7;
  EXPECT_FALSE(method::hysteresis::against_ramps(fit_with_level(5.5), ramps).shown("static_Nm"));
}

}  // namespace
}  // namespace tribolog::level_against_ramps_test
