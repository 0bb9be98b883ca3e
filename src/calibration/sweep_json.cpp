// Stages 1 and 2.

#include "calibration/parts.h"

namespace tribolog::json {

Json cog(const CogSweepResult& r, double gear_ratio) {
  const auto if_found = [&r](double value) { return r.found ? number(value) : Json(nullptr); };
  const Json joint = r.found ? interval(scaled(r.gravity_Nm, gear_ratio)) : Json(nullptr);
  return {{"found", r.found},
          {"method", text_or_null(r.method)},
          {"argmax_rad", if_found(r.argmax_rad)},
          {"argmax_low_rad", if_found(r.argmax_low_rad)},
          {"argmax_high_rad", if_found(r.argmax_high_rad)},
          {"argmax_torque_Nm", if_found(r.argmax_torque_Nm)},
          {"argmax_at_end", r.argmax_at_end},
          {"q_peak_rad", interval_if(r.found, r.q_peak_rad)},
          {"gravity_Nm", interval_if(r.found, r.gravity_Nm)},
          {"gravity_joint_Nm", joint},
          {"coulomb_Nm", interval(r.coulomb_Nm)},
          {"unloaded_coulomb_Nm", interval(r.unloaded_coulomb_Nm)},
          {"load_coulomb_Nm", interval(r.load_coulomb_Nm)},
          {"viscous_Nms_rad", interval(r.viscous_Nms_rad)},
          {"inertia_kgm2", interval(r.inertia_kgm2)},
          {"offset_Nm", if_found(r.offset_Nm)},
          {"residual_Nm", if_found(r.residual_Nm)},
          {"lowest_rad", if_found(r.lowest_rad)},
          {"highest_rad", if_found(r.highest_rad)},
          {"both_directions", r.both_directions},
          {"constant_speed", r.constant_speed},
          {"samples_used", r.samples_used},
          {"samples_left_out", r.samples_left_out}};
}

}  // namespace tribolog::json
