#include "method/intervals/stated_intervals.h"

namespace tribolog {

void state_intervals(const IntervalsResult& intervals, FrictionParametersResult& friction) {
  const auto state = [&](const char* name, Estimate& estimate) {
    const TwoIntervals* both = intervals.find(name);
    if (both == nullptr || !both->bootstrap || !both->bootstrap_is_stated) return;
    estimate.low = both->bootstrap->low;
    estimate.high = both->bootstrap->high;
    estimate.method = "curve fit, bootstrap of the runs with gravity's error";
  };
  if (friction.waiboer) {
    state("waiboer.asperity_torque_Nm", friction.waiboer->asperity_torque_Nm);
    state("waiboer.stribeck_speed_rad_s", friction.waiboer->stribeck_speed_rad_s);
    state("waiboer.stribeck_power", friction.waiboer->stribeck_power);
    state("waiboer.viscous_coefficient", friction.waiboer->viscous_coefficient);
    state("waiboer.viscous_power", friction.waiboer->viscous_power);
  }
  if (friction.coulomb_viscous) {
    state("line.coulomb_Nm", friction.coulomb_viscous->coulomb_Nm);
    state("line.viscous_Nms_rad", friction.coulomb_viscous->viscous_Nms_rad);
  }
}

}  // namespace tribolog
