// Gravity from the runs, what was stated about loads, and friction against load.

#include <utility>

#include "calibration/parts.h"

namespace tribolog::json {

Json run_gravity(const RunGravityResult& r, double n) {
  const auto if_found = [&](double value) { return r.found ? number(value) : Json(nullptr); };
  return {{"found", r.found},
          {"reason", text_or_null(r.reason)},
          {"q_peak_rad", interval_if(r.found, r.q_peak_rad)},
          {"gravity_Nm", interval_if(r.found, r.gravity_Nm)},
          {"gravity_joint_Nm", r.found ? interval(scaled(r.gravity_Nm, n)) : Json(nullptr)},
          {"residual_Nm", if_found(r.residual_Nm)},
          {"lowest_rad", if_found(r.lowest_rad)},
          {"highest_rad", if_found(r.highest_rad)},
          {"runs_used", r.runs_used},
          {"runs_left_out", r.runs_left_out},
          {"samples_used", r.samples_used},
          {"always_lifts", r.found ? Json(r.always_lifts) : Json(nullptr)}};
}

Json load_dependence(const LoadDependenceResult& l) {
  const auto if_examined = [&](double value) { return l.examined ? number(value) : Json(nullptr); };
  Json points = Json::array();
  for (const LoadPoint& p : l.points) {
    points.push_back({{"q_rad", number(p.q_rad)},
                      {"load_Nm", number(p.load_Nm)},
                      {"speed_rad_s", number(p.speed_rad_s)},
                      {"friction_Nm", number(p.friction_Nm)},
                      {"fit_Nm", number(p.fit_Nm)}});
  }
  return {{"examined", l.examined},
          {"found", l.found},
          {"sentence", l.sentence},
          {"per_load", interval_if(l.examined, l.per_load)},
          {"unloaded_Nm", interval_if(l.examined, l.unloaded_Nm)},
          {"viscous_Nms_rad", interval(l.viscous_Nms_rad)},
          {"lowest_load_Nm", if_examined(l.lowest_load_Nm)},
          {"highest_load_Nm", if_examined(l.highest_load_Nm)},
          {"held_out_Nm", if_examined(l.held_out_Nm)},
          {"held_out_without_load_Nm", if_examined(l.held_out_without_load_Nm)},
          {"held_out_speed_alone_Nm", if_examined(l.held_out_speed_alone_Nm)},
          {"points", std::move(points)}};
}

Json known_loads(const std::vector<KnownLoad>& loads) {
  Json list = Json::array();
  for (const KnownLoad& load : loads) {
    Json roles = Json::array();
    for (const Role role : load.roles) roles.push_back(to_string(role));
    list.push_back({{"amplitude_joint_Nm", number(load.amplitude_Nm)},
                    {"angles", load.angles},
                    {"phase_rad", number(load.phase_rad)},
                    {"roles", std::move(roles)},
                    {"note", text_or_null(load.note)},
                    {"samples", load.samples},
                    {"largest_joint_Nm", number(load.largest_Nm)}});
  }
  return list;
}

Json known_gravity(const std::optional<StatedGravity>& g) {
  if (!g) return nullptr;
  return {{"amplitude_joint_Nm", number(g->amplitude_Nm())},
          {"q_peak_rad", number(g->q_peak_rad())}};
}

}  // namespace tribolog::json
