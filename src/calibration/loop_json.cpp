// Stages 3 and 4.

#include <algorithm>
#include <cmath>
#include <utility>

#include "calibration/parts.h"
#include "method/hysteresis/steady_loop.h"
#include "wording/words.h"

namespace tribolog::calibration {

namespace {

Json loop_points(const std::vector<method::hysteresis::LoopPoint>& points) {
  if (points.empty()) return nullptr;
  Json named = Json::object();
  for (const method::hysteresis::Estimator point : method::hysteresis::loop_points) {
    named[to_string(point)] = nullptr;
  }
  for (const method::hysteresis::LoopPoint& p : points) {
    named[to_string(p.name)] = {{"t_s", number(p.t_s)},
                                {"q_rad", number(p.q_rad)},
                                {"torque_Nm", number(p.torque_Nm)},
                                {"torque_low_Nm", number(p.torque_low_Nm)},
                                {"torque_high_Nm", number(p.torque_high_Nm)},
                                {"z_rad", number(p.z_rad)},
                                {"dz_dt_rad_s", number(p.dz_rad_s)}};
  }
  return named;
}

/// Points of each loop: many positions share what three would have.
std::size_t points_of_each(std::size_t loops) {
  return std::clamp<std::size_t>(600 / std::max<std::size_t>(loops, 1), 40, 200);
}

Json drawn_loop(const method::hysteresis::HysteresisResult& h, const Curves& curves,
                std::size_t k) {
  if (k >= curves.loops.size()) return nullptr;
  const auto loop = method::hysteresis::steady_loop(curves.loops[k], h.oscillations[k],
                                                    points_of_each(h.oscillations.size()));
  if (!loop) return nullptr;
  return {{"centre_rad", number(loop->centre_rad)},
          {"angle_from_centre_rad", short_numbers(loop->from_centre_rad)},
          {"torque_Nm", short_numbers(loop->torque_Nm)}};
}

}  // namespace

Json hysteresis(const method::hysteresis::HysteresisResult& h, const Curves& curves) {
  Json oscillations = Json::array();
  for (std::size_t k = 0; k < h.oscillations.size(); ++k) {
    const method::hysteresis::Oscillation& o = h.oscillations[k];
    oscillations.push_back({{"centre_rad", number(o.centre_rad)},
                            {"amplitude_rad", number(o.amplitude_rad)},
                            {"frequency_Hz", number(o.frequency_Hz)},
                            {"cycles", number(o.cycles)},
                            {"steady_cycles", number(o.steady_cycles)},
                            {"encoder_step_rad", number(o.encoder_step_rad)},
                            {"step_is_of_print", o.step_is_of_print},
                            {"steady_loop", drawn_loop(h, curves, k)}});
  }
  return {{"found", h.found},
          {"bristle_source", words_or_null(h.bristle_source)},
          {"bristle_source_code", code_of(h.bristle_source)},
          {"oscillations", std::move(oscillations)},
          {"points", loop_points(h.points)},
          {"steady_points", loop_points(h.steady_points)},
          {"midline_Nm", interval(h.midline_Nm)},
          {"midline_q_rad", h.midline_Nm ? number(h.midline_q_rad) : Json(nullptr)},
          {"loop_height_Nm", h.found ? number(h.loop_height_Nm) : Json(nullptr)},
          {"presliding_travel_rad", number(h.presliding_travel_rad)},
          {"encoder_step_rad", number(h.encoder_step_rad)},
          {"step_is_of_print", h.encoder_step_rad ? Json(h.step_is_of_print) : Json(nullptr)}};
}

Json surrogate_masses(const method::hysteresis::SurrogateMassesResult& result) {
  Json list = Json::array();
  for (const method::hysteresis::SurrogateMass& m : result.masses) {
    list.push_back({{"estimator", to_string(m.estimator)},
                    {"torque_Nm", interval(m.torque_Nm)},
                    {"q_rad", number(m.q_rad)},
                    {"mass_kg", interval(m.mass_kg)},
                    {"gravity_Nm", interval(m.gravity_Nm)},
                    {"offset_taken_Nm", number(m.offset.value_Nm)},
                    {"offset_ambiguity_Nm", number(m.offset.ambiguity_Nm)}});
  }
  return list;
}

// Stage 8, the LuGre fit of the loops.

namespace {

using method::hysteresis::LuGreParameterName;

/// Factor from the motor's side to the joint's, by the quantity's powers of torque and speed.
double to_joint(LuGreParameterName name, double n) {
  switch (name) {
    case LuGreParameterName::static_torque:
    case LuGreParameterName::coulomb_torque:
      return n;
    case LuGreParameterName::stribeck_speed:
      return 1 / n;
    case LuGreParameterName::speed_weakening:
      return n * n * n;
    default:
      return n * n;
  }
}

Json sides_if_shown(const std::optional<statistics::Estimate>& motor, double motor_to_joint) {
  if (motor) return both_sides(*motor, motor_to_joint);
  return {{"motor", nullptr}, {"joint", nullptr}};
}

Json parameter(const method::hysteresis::LuGreParameter& p) {
  return {{"name", to_string(p.name)},
          {"shown", p.estimate.has_value()},
          {"held_at", number(p.held_at)},
          {"relative_standard_error", number(p.relative_error)},
          {"effect_Nm", number(p.effect_Nm)},
          {"why_not", words_or_null(p.why_not)},
          {"why_not_code", code_of(p.why_not)},
          {"experiment", words_or_null(p.experiment)},
          {"experiment_code", code_of(p.experiment)}};
}

Json identifiability(const method::hysteresis::LuGreIdentifiability& i) {
  Json correlation = Json::array();
  for (const auto& row : i.correlation) correlation.push_back(numbers(row));
  return {{"names", wording::words(i.names)},
          {"names_code", code_of(i.names)},
          {"singular_values_Nm", numbers(i.singular_values_Nm)},
          {"condition", number(i.condition)},
          {"weakest_direction", numbers(i.weakest)},
          {"weakest_in_words", words_or_null(i.weakest_statement)},
          {"weakest_in_words_code", code_of(i.weakest_statement)},
          {"correlation", std::move(correlation)}};
}

Json traced(const std::optional<method::hysteresis::TracedLoop>& loop) {
  if (!loop) return nullptr;
  return {{"noise_rad", number(loop->noise_rad)},
          {"noise_from", wording::words(loop->noise_source)},
          {"noise_from_code", code_of(loop->noise_source)},
          {"strokes", loop->strokes},
          {"explained_Nm", number(loop->explained_Nm)},
          {"turn_stiffness_Nm_rad", interval(loop->turn_stiffness_Nm_rad)},
          {"model_turn_stiffness_Nm_rad", interval(loop->model_turn_stiffness_Nm_rad)}};
}

Json contacts(const method::hysteresis::ContactContest& contest) {
  Json rivals = Json::array();
  for (const method::hysteresis::ContactRival& rival : contest.rivals) {
    rivals.push_back({{"law", to_string(rival.law)},
                      {"stiffness_Nm_rad", number(rival.stiffness_Nm_rad)},
                      {"static_Nm", number(rival.static_Nm)},
                      {"residual_Nm", number(rival.residual_Nm)}});
  }
  return {{"winner", contest.winner ? Json(to_string(*contest.winner)) : Json(nullptr)},
          {"rivals", std::move(rivals)}};
}

Json recording(const method::hysteresis::LuGreLoop& loop) {
  return {{"recording", loop.recording},
          {"gravity_Nm", interval(loop.gravity_Nm)},
          {"start_deflection_rad", number(loop.start_deflection_rad)},
          {"samples_left_out", loop.samples_left_out},
          {"left_out_s", number(loop.left_out_s)},
          {"residual_Nm", number(loop.residual_Nm)},
          {"height_Nm", number(loop.height_Nm)},
          {"systematic_Nm", number(loop.systematic_Nm)},
          {"motion", to_string(loop.motion)},
          {"motion_residual_rad", number(loop.motion_residual_rad)},
          {"traced", traced(loop.traced)}};
}

}  // namespace

Json lugre(const method::hysteresis::LuGreFit& f, double n) {
  Json made{{"converged", f.converged},
            {"rung", f.rung ? Json(to_string(*f.rung)) : Json(nullptr)}};
  for (const LuGreParameterName name : method::hysteresis::lugre_parameters) {
    made[to_string(name)] = sides_if_shown(f.shown(name), to_joint(name, n));
  }
  made["gravity_Nm"] = sides_if_shown(f.gravity_Nm, n);
  made["residual_Nm"] = number(f.residual_Nm);
  made["contacts"] = contacts(f.contacts);
  made["damping_fall"] = nullptr;
  if (f.damping_fall) {
    made["damping_fall"] = {{"half_at_rad_s", number(f.damping_fall->half_at_rad_s)},
                            {"stiffness_share", number(f.damping_fall->stiffness_share)}};
  }
  made["iterations"] = f.iterations;
  made["reason"] = words_or_null(f.reason);
  made["reason_code"] = code_of(f.reason);
  made["parameters"] = Json::array();
  for (const method::hysteresis::LuGreParameter& p : f.parameters)
    made["parameters"].push_back(parameter(p));
  made["identifiability"] = nullptr;
  if (!f.identifiability.names.empty())
    made["identifiability"] = identifiability(f.identifiability);
  made["recordings"] = Json::array();
  for (const method::hysteresis::LuGreLoop& loop : f.loops)
    made["recordings"].push_back(recording(loop));
  return made;
}

// Break-away ramps and the shape of the loops, which are not in the paper.

Json break_away(const method::hysteresis::BreakAwayResult& result, double gear_ratio) {
  Json ramps = Json::array();
  for (const method::hysteresis::BreakAwayRamp& r : result.ramps) {
    ramps.push_back({{"recording", r.recording},
                     {"direction", r.is_rising ? "rising" : "falling"},
                     {"broke_away", r.broke_away},
                     {"rate_Nm_s", number(r.rate_Nm_s)},
                     {"torque_Nm", number(r.torque_Nm)},
                     {"friction_Nm", number(r.friction_Nm)},
                     {"inertia_Nm", number(r.inertia_Nm)},
                     {"inertia_half_width_Nm", number(r.inertia_half_width_Nm)},
                     {"level_Nm", number(r.level_Nm)},
                     {"q_start_rad", number(r.q_start_rad)},
                     {"travel_rad", number(r.travel_rad)},
                     {"first_slip_rad", number(r.first_slip_rad)},
                     {"even_slide_rad_s", number(r.even_slide_rad_s)},
                     {"largest_yield", number(r.largest_yield)},
                     {"samples_used", r.samples_used},
                     {"samples_left_out", r.samples_left_out}});
  }
  const auto on_both_sides = [&](const std::optional<statistics::Estimate>& e) {
    return e ? both_sides(*e, gear_ratio) : Json(nullptr);
  };
  return {{"gravity_taken_off", result.gravity.has_value()},
          {"censored", result.censored},
          {"rising_Nm", on_both_sides(result.rising_Nm)},
          {"falling_Nm", on_both_sides(result.falling_Nm)},
          {"mean_Nm", on_both_sides(result.mean_Nm)},
          {"ramps", std::move(ramps)}};
}

Json loop_shapes(const std::vector<method::hysteresis::LoopShape>& shapes) {
  Json list = Json::array();
  for (const method::hysteresis::LoopShape& s : shapes) {
    list.push_back({{"recording", s.recording},
                    {"width_rad", number(s.width_rad)},
                    {"height_Nm", number(s.height_Nm)},
                    {"cycles", number(s.cycles)},
                    {"closing_gap", number(s.closing_gap)},
                    {"closes", s.closes},
                    {"dissipated_J", number(s.dissipated_J)},
                    {"stiffness_Nm_rad", interval(s.stiffness_Nm_rad)},
                    {"strokes", s.strokes}});
  }
  return list;
}

}  // namespace tribolog::calibration
