#include "simulate/break_away_ramp.h"

#include <cmath>
#include <utility>

#include "base/requirements.h"
#include "base/statement.h"
#include "simulate/forced_motion.h"

namespace tribolog::simulate {

joint::Recording simulate_break_away_ramp(const Scenario& s, const BreakAwayExperiment& e,
                                          double direction, std::string name) {
  require_positive(e.rate_Nm_s, "rate_Nm_s", "N·m/s");
  require_positive(e.largest_torque_Nm, "largest_torque_Nm", "N·m");
  require_positive(e.largest_travel_rad, "largest_travel", "rad");
  require_positive(e.sample_rate_Hz, "sample_rate_Hz", "Hz");
  const double n = s.gear_ratio;
  const double inertia = s.motor_inertia_kgm2 + s.arm_inertia_kgm2 / (n * n);
  require_positive(inertia, Code{"parameter.inertia_of_motor_and_arm"}, "kg·m²");
  const double held_Nm = s.load.torque_Nm(e.centre_rad) / n;
  const auto torque_at = [&](double t) { return held_Nm + direction * e.rate_Nm_s * t; };
  ForcedMotionSetup setup;
  setup.inertia_kgm2 = inertia;
  setup.angle_rad = n * e.centre_rad;
  setup.applied_Nm = [&](double t, double motor_rad, double) {
    return torque_at(t) - s.load.torque_Nm(motor_rad / n) / n;
  };
  setup.duration_s = e.largest_torque_Nm / e.rate_Nm_s;
  setup.sample_s = 1 / e.sample_rate_Hz;
  setup.relative_tolerance = 1e-8;
  const ForcedMotion motion = simulate_forced_motion(*s.presliding, setup);

  joint::Recording r;
  r.name = std::move(name);
  r.role = joint::Role::break_away;
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    const double q = motion.angle_rad[i] / n;
    if (std::abs(q - e.centre_rad) > e.largest_travel_rad) break;
    r.t_s.push_back(motion.t_s[i]);
    r.q_rad.push_back(q);
    r.dq_rad_s.push_back(motion.speed_rad_s[i] / n);
    r.torque_Nm.push_back(torque_at(motion.t_s[i]));
  }
  r.rows_read = r.size();
  return r;
}

}  // namespace tribolog::simulate
