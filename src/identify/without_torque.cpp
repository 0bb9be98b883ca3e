#include "identify/without_torque.h"

namespace tribolog {

void refuse_for_want_of_torque(Calibration& c) {
  const auto refuse = [](StageReport& stage, const char* name, const char* needed) {
    stage = {name, StageState::not_identifiable, std::string("no torque was recorded; ") + needed};
  };
  const char* const column =
      "log the motor's torque, or its present current with the torque constant, in a column beside "
      "the angle";
  refuse(c.rough.stage, "cog_rough", column);
  refuse(c.precise.stage, "cog_precise", column);
  refuse(c.hysteresis.stage, "hysteresis", "the loop is torque against angle");
  refuse(c.masses.stage, "surrogate_masses", "a mass is read off a torque");
  refuse(c.viscous.stage, "viscous_curves", "the curve is torque against speed");
  refuse(c.quality.stage, "quality_errors", "there is no curve to check");
  refuse(c.selection.stage, "selection", "there is no mass to select");
  refuse(c.friction.stage, "friction_parameters", "there is no curve to fit");
}

}  // namespace tribolog
