// The level of loops that creep is no break-away torque.

#include <gtest/gtest.h>

#include "method/hysteresis/break_away.h"
#include "wording/words.h"

namespace tribolog::level_against_ramps_test {
namespace {

using method::hysteresis::LuGreParameterName;

method::hysteresis::LuGreFit fit_with_level(double static_Nm) {
  method::hysteresis::LuGreParameter level;
  level.name = LuGreParameterName::static_torque;
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
  EXPECT_FALSE(fit.shown(LuGreParameterName::static_torque));
  EXPECT_NE(wording::words(fit.parameters[0].why_not).find("holds 11 N·m without sliding"),
            std::string::npos);
  EXPECT_FALSE(fit.parameters[0].experiment.empty());
}

TEST(LevelAgainstRamps, TakesWhatWasReadFromItAlong) {
  method::hysteresis::LuGreFit fit = fit_with_level(5.5);
  for (const LuGreParameterName name :
       {LuGreParameterName::bristle_stiffness, LuGreParameterName::coulomb_torque,
        LuGreParameterName::stribeck_speed}) {
    method::hysteresis::LuGreParameter p = fit.parameters[0];
    p.name = name;
    fit.parameters.push_back(p);
  }
  method::hysteresis::LuGreParameter held;
  held.name = LuGreParameterName::speed_weakening;
  held.why_not = Statement::verbatim("friction is the same at all speeds of the loops");
  fit.parameters.push_back(held);
  fit = method::hysteresis::against_ramps(fit, ramps_that_held(12, 11));
  EXPECT_TRUE(fit.shown(LuGreParameterName::bristle_stiffness))
      << "the slope behind a reversal needs no level";
  EXPECT_FALSE(fit.shown(LuGreParameterName::coulomb_torque));
  EXPECT_FALSE(fit.shown(LuGreParameterName::stribeck_speed));
  for (const method::hysteresis::LuGreParameter& p : fit.parameters)
    EXPECT_EQ(p.estimate.has_value(), p.why_not.empty());
  EXPECT_EQ(fit.parameters.back().why_not, held.why_not);
}

TEST(LevelAgainstRamps, StaysWhereTheyAgreeOrSayNothing) {
  EXPECT_TRUE(method::hysteresis::against_ramps(fit_with_level(5.5), ramps_that_held(5.5, 5.4))
                  .shown(LuGreParameterName::static_torque));
  EXPECT_TRUE(method::hysteresis::against_ramps(fit_with_level(5.5), {})
                  .shown(LuGreParameterName::static_torque));
  // One direction alone may have been helped by gravity.
  EXPECT_TRUE(method::hysteresis::against_ramps(fit_with_level(5.5), ramps_that_held(12, 0))
                  .shown(LuGreParameterName::static_torque));
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
  EXPECT_TRUE(method::hysteresis::against_ramps(fit_with_level(5.5), ramps)
                  .shown(LuGreParameterName::static_torque));
  // One that ended without sliding is a bound, whatever the others say.
  ramps.ramps[0].broke_away = ramps.ramps[1].broke_away = false;
  ramps.ramps[0].friction_Nm = ramps.ramps[1].friction_Nm = 7;
  EXPECT_FALSE(method::hysteresis::against_ramps(fit_with_level(5.5), ramps)
                   .shown(LuGreParameterName::static_torque));
}

}  // namespace
}  // namespace tribolog::level_against_ramps_test
