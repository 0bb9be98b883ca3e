#include "export/dataset/truth_json.h"

#include <nlohmann/json.hpp>

#include "base/shown_text.h"

namespace tribolog {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::vector<MaxwellElement>& elements) {
  Json list = Json::array();
  for (const MaxwellElement& one : elements) {
    list.push_back(Json{{"stiffness_Nm_rad", one.stiffness_Nm_rad}, {"share", one.share}});
  }
  return list;
}

template <class Number>
Json json_of(Number number) {
  return number;
}

Json friction(const FrictionModel& model) {
  Json json;
  json["model"] = model.name();
  for (const NamedParameter& one : model.named_parameters()) {
    json[one.key] = std::visit([](const auto& value) { return json_of(value); }, one.value);
  }
  return json;
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
          {"clock_jitter_s", n.clock_jitter_s},
          {"lost_percent", n.lost_percent},
          {"seed", n.seed}};
}

}  // namespace

std::string truth_json(const Scenario& scenario) {
  const GravityLoad& load = scenario.load;
  const double motor_torque_Nm = load.amplitude_Nm() / scenario.gear_ratio;
  const Json truth = {{"schema", "tribolog-truth-1"},
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
                       surrogate_mass_kg(motor_torque_Nm, scenario.gear_ratio,
                                         scenario.surrogate_distance_m, load.gravity_m_s2(), 1.0)},
                      {"motor_inertia_kgm2", scenario.motor_inertia_kgm2},
                      {"arm_inertia_kgm2", scenario.arm_inertia_kgm2},
                      {"presliding", friction(*scenario.presliding)},
                      {"sliding", friction(scenario.sliding_model())},
                      {"noise", noise(scenario.noise)}};
  return json_without_hidden(truth.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace tribolog
