#include "joint/joint_facts.h"

#include <cmath>

#include "base/requirements.h"
#include "base/statement.h"
#include "joint/degrees.h"

namespace tribolog::joint {
namespace {

void require_positive_if_stated(const std::optional<double>& value, const ParameterName& what,
                                const char* unit) {
  if (value) require_positive(*value, what, unit);
}

void require_not_negative_if_stated(const std::optional<double>& value, const ParameterName& what,
                                    const char* unit) {
  if (value) require_not_negative(*value, what, unit);
}

}  // namespace

void check_joint_facts(const JointFacts& f) {
  require_positive(f.gear_ratio, "gear ratio", "");
  if (!(std::isfinite(f.lowest_rad) && f.highest_rad > f.lowest_rad &&
        std::isfinite(f.highest_rad))) {
    throw Refusal({"joint.highest_angle_not_above_lowest",
                   {{"highest_deg", f.highest_rad * degrees_per_rad},
                    {"lowest_deg", f.lowest_rad * degrees_per_rad}}});
  }
  require_positive(f.speed_limit_rad_s, "speed limit", "rad/s");
  require_positive(f.acceleration_limit_rad_s2, "acceleration limit", "rad/s²");
  require_positive(f.torque_limit_Nm, "torque limit", "N·m");
  require_positive_if_stated(f.inertia_kgm2, "inertia", "kg·m²");
  require_positive_if_stated(f.gravity_Nm, "gravity torque", "N·m");
  if (f.q_peak_rad && !std::isfinite(*f.q_peak_rad)) {
    throw Refusal({"gravity_peak.not_finite"});
  }
  require_positive_if_stated(f.static_Nm, "static torque", "N·m");
  require_positive_if_stated(f.coulomb_Nm, "Coulomb torque", "N·m");
  if (f.coulomb_Nm && f.static_Nm) {
    require_not_above(*f.coulomb_Nm, "Coulomb torque", *f.static_Nm, "static torque", "N·m");
  }
  require_positive_if_stated(f.stribeck_speed_rad_s, "Stribeck velocity", "rad/s");
  require_positive_if_stated(f.bristle_stiffness_Nm_rad, "bristle stiffness", "N·m/rad");
  require_positive_if_stated(f.sample_rate_Hz, "sampling rate", "Hz");
  require_positive_if_stated(f.set_point_rate_Hz, Code{"parameter.set_point_rate"}, "Hz");
  require_positive_if_stated(f.encoder_counts_per_turn, Code{"parameter.encoder_counts"}, "");
  require_not_negative_if_stated(f.torque_noise_Nm, "torque noise", "N·m");
  require_not_negative_if_stated(f.torque_step_Nm, "torque step", "N·m");
  require_not_negative_if_stated(f.ripple_amplitude_Nm, "ripple amplitude", "N·m");
  for (const double periods : f.ripple_periods_per_turn) {
    require_positive(periods, Code{"parameter.ripple_periods"}, "");
  }
  require_positive_if_stated(f.time_budget_s, "time budget", "s");
  (void)Drive(f.gear_ratio, f.effort_kind, f.effort_side, f.torque_constant_Nm_A);
}

}  // namespace tribolog::joint
