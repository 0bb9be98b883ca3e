#include "plan/assumed_joint.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "friction/lugre.h"
#include "friction/static_laws.h"
#include "joint/degrees.h"

namespace tribolog::plan {
namespace {

// Shares of the torque limit, of the size that geared robot joints show.
constexpr double usual_gravity_share = 0.4;
constexpr double usual_static_share = 0.1;
constexpr double usual_noise_share = 1 / 400.0;
constexpr double usual_step_share = 1 / 1600.0;
/// Torque limit left for acceleration where the acceleration limit is reached.
constexpr double usual_inertia_share = 0.25;
// The paper's joint, as shares of its break-away torque.
constexpr double coulomb_share = 0.68;
constexpr double viscous_share = 0.136;
constexpr double viscous_at_rest_share = 1.1e-3;
constexpr double damping_time_s = 1.656e-3;  // sigma1 / sigma0
constexpr double usual_deflection_rad = 1.9e-3;
constexpr double usual_stribeck_rad_s = 5;
constexpr double usual_stribeck_share = 0.1;  // of the speed limit, at most
constexpr double stribeck_power = 0.7;
constexpr double viscous_power = 0.6;
constexpr double smoothing_s_rad = 1e6;

class Assumer {
 public:
  Assumer(const joint::JointFacts& facts, std::vector<Assumption>& list)
      : facts_(facts), list_(list) {}

  /// @param name of the fact. @param why the usual value is what it is.
  double take(const char* name, const std::optional<double>& stated, double usual, Code what,
              const char* unit, Code why, double shown_per_si = 1) {
    const double value = stated.value_or(usual);
    list_.push_back(
        {what, value * shown_per_si, unit, stated ? known_from(name) : why, stated.has_value()});
    return value;
  }

  [[nodiscard]] Code known_from(const char* name) const {
    return facts_.identified.count(name) > 0 ? Code("assumed_from.identified")
                                             : Code("assumed_from.stated");
  }

 private:
  const joint::JointFacts& facts_;
  std::vector<Assumption>& list_;
};

}  // namespace

double AssumedJoint::friction_Nm(double motor_speed_rad_s) const {
  const simulate::Scenario s = assumed_scenario(*this);
  return std::max(static_Nm, s.sliding->torque_Nm(motor_speed_rad_s));
}

AssumedJoint assume_joint(const joint::JointFacts& f) {
  joint::check_joint_facts(f);
  AssumedJoint j;
  j.facts = f;
  Assumer a(f, j.assumptions);
  const double limit = f.torque_limit_Nm;
  j.peak_is_known = f.q_peak_rad.has_value();
  j.q_peak_rad =
      a.take("q_peak_rad", f.q_peak_rad, (f.lowest_rad + f.highest_rad) / 2, "assumed.q_peak", "°",
             "assumed_from.middle_of_range", joint::degrees_per_rad);
  j.gravity_Nm = a.take("gravity_Nm", f.gravity_Nm, usual_gravity_share * limit, "assumed.gravity",
                        "N·m", "assumed_from.torque_limit_40_percent");
  const double usual_inertia =
      usual_inertia_share * limit / (f.gear_ratio * f.acceleration_limit_rad_s2);
  j.inertia_kgm2 = a.take("inertia_kgm2", f.inertia_kgm2, usual_inertia, "assumed.inertia", "kg·m²",
                          "assumed_from.torque_limit_25_percent");
  const double usual_static =
      f.coulomb_Nm ? *f.coulomb_Nm / coulomb_share : usual_static_share * limit;
  j.static_Nm = a.take("static_Nm", f.static_Nm, usual_static, "assumed.static_torque", "N·m",
                       f.coulomb_Nm ? Code("assumed_from.coulomb_torque")
                                    : Code("assumed_from.torque_limit_10_percent"));
  j.coulomb_Nm =
      a.take("coulomb_Nm", f.coulomb_Nm, coulomb_share * j.static_Nm, "assumed.coulomb_torque",
             "N·m", "assumed_from.break_away_torque_68_percent");
  // The paper's, of a motor behind a gear; a slower drive's lies as far below its fastest.
  const double by_limit = usual_stribeck_share * f.gear_ratio * f.speed_limit_rad_s;
  j.stribeck_speed_rad_s =
      a.take("stribeck_speed_rad_s", f.stribeck_speed_rad_s,
             std::min(usual_stribeck_rad_s, by_limit), "assumed.stribeck_speed", "rad/s",
             by_limit < usual_stribeck_rad_s ? Code("assumed_from.speed_limit_10_percent")
                                             : Code("assumed_from.papers_joint"));
  j.viscous_coefficient = a.take("", {}, viscous_share * j.static_Nm, "assumed.viscous_coefficient",
                                 "N·m·(s/rad)^0.4", "assumed_from.break_away_torque");
  j.bristle_stiffness_Nm_rad = a.take(
      "bristle_stiffness_Nm_rad", f.bristle_stiffness_Nm_rad, j.static_Nm / usual_deflection_rad,
      "assumed.bristle_stiffness", "N·m/rad", "assumed_from.papers_deflection");
  j.sample_rate_Hz = a.take("sample_rate_Hz", f.sample_rate_Hz, 1000, "assumed.sample_rate", "Hz",
                            "assumed_from.usual");
  j.set_point_rate_Hz =
      a.take("set_point_rate_Hz", f.set_point_rate_Hz, std::min(250.0, j.sample_rate_Hz),
             "assumed.set_point_rate", "Hz", "assumed_from.usual_interpolated");
  j.noise.encoder_counts_per_turn =
      a.take("encoder_counts_per_turn", f.encoder_counts_per_turn, 131072, "assumed.encoder_counts",
             "", "assumed_from.usual_encoder");
  j.noise.torque_white_Nm =
      a.take("torque_noise_Nm", f.torque_noise_Nm, usual_noise_share * limit,
             "assumed.torque_noise", "N·m", "assumed_from.torque_limit_400th");
  j.noise.torque_step_Nm = a.take("torque_step_Nm", f.torque_step_Nm, usual_step_share * limit,
                                  "assumed.torque_step", "N·m", "assumed_from.torque_limit_1600th");
  const double ripple =
      a.take("ripple_amplitude_Nm", f.ripple_amplitude_Nm, usual_noise_share * limit,
             "assumed.ripple_amplitude", "N·m", "assumed_from.torque_limit_400th");
  // An eccentric shaft, the wave generator of a strain wave gear, a motor of three pole pairs.
  const std::vector<double> usual_periods{1, 2, 6};
  const bool periods_are_stated = !f.ripple_periods_per_turn.empty();
  for (const double periods : periods_are_stated ? f.ripple_periods_per_turn : usual_periods) {
    j.noise.ripple.push_back({ripple, periods, 0});
    const Code source = periods_are_stated ? a.known_from("ripple_periods_per_turn")
                        : periods == 1     ? Code("assumed_from.eccentric_shaft")
                        : periods == 2     ? Code("assumed_from.wave_generator")
                                           : Code("assumed_from.pole_pairs");
    j.assumptions.push_back(
        {Code("assumed.ripple_periods"), periods, "", source, periods_are_stated});
  }
  j.noise.speed_filter_Hz = 100;
  return j;
}

simulate::Scenario assumed_scenario(const AssumedJoint& j) {
  simulate::Scenario s;
  s.name = "assumed joint of a plan";
  s.robot = j.facts.robot;
  s.joint = j.facts.joint;
  s.gear_ratio = j.facts.gear_ratio;
  s.motor_inertia_kgm2 = j.inertia_kgm2;
  constexpr double g_m_s2 = 9.81;
  constexpr double distance_m = 1;  // only m r shows in the logs
  s.load = joint::GravityLoad(j.gravity_Nm * s.gear_ratio / (g_m_s2 * distance_m), distance_m,
                              j.q_peak_rad, g_m_s2);
  s.presliding = std::make_shared<friction::LuGreFriction>(friction::LuGreFriction::Parameters{
      j.bristle_stiffness_Nm_rad, damping_time_s * j.bristle_stiffness_Nm_rad,
      viscous_at_rest_share * j.static_Nm, j.coulomb_Nm, j.static_Nm, j.stribeck_speed_rad_s});
  s.sliding = std::make_shared<friction::WaiboerFriction>(
      friction::WaiboerFriction::Parameters{j.static_Nm, j.stribeck_speed_rad_s, stribeck_power,
                                            j.viscous_coefficient, viscous_power, smoothing_s_rad});
  s.noise = j.noise;
  return s;
}

}  // namespace tribolog::plan
