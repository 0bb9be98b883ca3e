// Stage 8, the LuGre fit of the loops.

#include <cmath>
#include <utility>

#include "calibration/parts.h"

namespace tribolog::json {
namespace {

/// From the motor to the joint, by the quantity's powers of torque and speed.
double to_joint(const std::string& name, double n) {
  if (name == "static_Nm" || name == "coulomb_Nm") return n;
  if (name == "stribeck_speed_rad_s") return 1 / n;
  if (name == "speed_weakening_Nms2_rad2") return n * n * n;
  return n * n;
}

Json sides_if_shown(const std::optional<Estimate>& motor, double motor_to_joint) {
  if (motor) return both_sides(*motor, motor_to_joint);
  return {{"motor", nullptr}, {"joint", nullptr}};
}

Json parameter(const LuGreParameter& p) {
  return {{"name", p.name},
          {"shown", p.estimate.has_value()},
          {"held_at", number(p.held_at)},
          {"relative_standard_error", number(p.relative_error)},
          {"effect_Nm", number(p.effect_Nm)},
          {"why_not", text_or_null(p.why_not)},
          {"experiment", text_or_null(p.experiment)}};
}

Json identifiability(const LuGreIdentifiability& i) {
  Json correlation = Json::array();
  for (const auto& row : i.correlation) correlation.push_back(numbers(row));
  return {{"names", i.names},
          {"singular_values_Nm", numbers(i.singular_values_Nm)},
          {"condition", number(i.condition)},
          {"weakest_direction", numbers(i.weakest)},
          {"weakest_in_words", text_or_null(i.weakest_in_words)},
          {"correlation", std::move(correlation)}};
}

Json traced(const std::optional<TracedLoop>& loop) {
  if (!loop) return nullptr;
  return {{"noise_rad", number(loop->noise_rad)},
          {"noise_from", loop->noise_in_words},
          {"strokes", loop->strokes},
          {"explained_Nm", number(loop->explained_Nm)},
          {"turn_stiffness_Nm_rad", interval(loop->turn_stiffness_Nm_rad)},
          {"model_turn_stiffness_Nm_rad", interval(loop->model_turn_stiffness_Nm_rad)}};
}

Json recording(const LuGreLoop& loop) {
  return {{"recording", loop.recording},
          {"gravity_Nm", interval(loop.gravity_Nm)},
          {"start_deflection_rad", number(loop.start_deflection_rad)},
          {"residual_Nm", number(loop.residual_Nm)},
          {"height_Nm", number(loop.height_Nm)},
          {"systematic_Nm", number(loop.systematic_Nm)},
          {"motion", loop.motion},
          {"motion_residual_rad", number(loop.motion_residual_rad)},
          {"traced", traced(loop.traced)}};
}

}  // namespace

Json lugre(const LuGreFit& f, double n) {
  Json made{{"converged", f.converged}, {"rung", text_or_null(f.rung)}};
  for (const char* name : lugre_parameter_names) {
    made[name] = sides_if_shown(f.shown(name), to_joint(name, n));
  }
  made["gravity_Nm"] = sides_if_shown(f.gravity_Nm, n);
  made["residual_Nm"] = number(f.residual_Nm);
  made["iterations"] = f.iterations;
  made["reason"] = text_or_null(f.reason);
  made["parameters"] = Json::array();
  for (const LuGreParameter& p : f.parameters) made["parameters"].push_back(parameter(p));
  made["identifiability"] = nullptr;
  if (!f.identifiability.names.empty())
    made["identifiability"] = identifiability(f.identifiability);
  made["recordings"] = Json::array();
  for (const LuGreLoop& loop : f.loops) made["recordings"].push_back(recording(loop));
  return made;
}

}  // namespace tribolog::json
