#include "export/truth_json.h"

#include <nlohmann/json.hpp>

namespace tribolog {
namespace {

using Json = nlohmann::ordered_json;

Json contact(const std::string& model, const LuGreFriction::Parameters& p) {
  return {{"model", model},
          {"bristle_stiffness_Nm_rad", p.bristle_stiffness_Nm_rad},
          {"bristle_damping_Nms_rad", p.bristle_damping_Nms_rad},
          {"viscous_Nms_rad", p.viscous_Nms_rad},
          {"coulomb_Nm", p.coulomb_Nm},
          {"static_Nm", p.static_Nm},
          {"stribeck_speed_rad_s", p.stribeck_speed_rad_s}};
}

Json waiboer(const WaiboerFriction::Parameters& p) {
  return {{"model", "waiboer"},
          {"asperity_torque_Nm", p.asperity_torque_Nm},
          {"stribeck_speed_rad_s", p.stribeck_speed_rad_s},
          {"stribeck_power", p.stribeck_power},
          {"viscous_coefficient", p.viscous_coefficient},
          {"viscous_power", p.viscous_power},
          {"smoothing_s_rad", p.smoothing_s_rad}};
}

Json noise(const Noise& n) {
  Json ripple = Json::array();
  for (const Noise::Ripple& r : n.ripple) {
    ripple.push_back(Json{{"amplitude_Nm", r.amplitude_Nm},
                          {"periods_per_turn", r.periods_per_turn},
                          {"phase_rad", r.phase_rad}});
  }
  return {{"torque_white_Nm", n.torque_white_Nm},
          {"torque_step_Nm", n.torque_step_Nm},
          {"encoder_counts_per_turn", n.encoder_counts_per_turn},
          {"speed_filter_Hz", n.speed_filter_Hz},
          {"ripple", ripple},
          {"seed", n.seed}};
}

}  // namespace

std::string truth_json(const Scenario& scenario) {
  const GravityLoad& load = scenario.load;
  const double motor_torque_Nm = load.amplitude_Nm() / scenario.gear_ratio;
  const Json truth = {
      {"schema", "tribolog-truth-1"},
      {"scenario", scenario.name},
      {"robot", scenario.robot},
      {"serial", scenario.serial},
      {"joint", scenario.joint},
      {"gear_ratio", scenario.gear_ratio},
      {"q_peak_rad", load.q_peak_rad()},
      {"q_c_rad", -load.q_peak_rad()},
      {"mass_kg", load.mass_kg()},
      {"distance_m", load.distance_m()},
      {"gravity_m_s2", load.gravity_m_s2()},
      {"gravity_torque_joint_Nm", load.amplitude_Nm()},
      {"gravity_torque_motor_Nm", motor_torque_Nm},
      {"surrogate_distance_m", scenario.surrogate_distance_m},
      {"surrogate_mass_kg",
       surrogate_mass_kg(motor_torque_Nm, scenario.gear_ratio, scenario.surrogate_distance_m,
                         load.gravity_m_s2(), 1.0)},
      {"motor_inertia_kgm2", scenario.motor_inertia_kgm2},
      {"arm_inertia_kgm2", scenario.arm_inertia_kgm2},
      {"presliding", contact(scenario.presliding_model, scenario.presliding.parameters())},
      {"sliding", waiboer(scenario.sliding.parameters())},
      {"noise", noise(scenario.noise)}};
  return truth.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tribolog
