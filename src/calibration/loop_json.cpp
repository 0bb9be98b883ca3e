// Stages 3 and 4.

#include <algorithm>

#include "calibration/parts.h"
#include "method/hysteresis/steady_loop.h"

namespace tribolog::json {
namespace {

Json loop_points(const std::vector<LoopPoint>& points) {
  if (points.empty()) return nullptr;
  Json named = Json::object();
  for (const char name : loop_point_names) named[std::string(1, name)] = nullptr;
  for (const LoopPoint& p : points) {
    named[std::string(1, p.name)] = {{"t_s", number(p.t_s)},
                                     {"q_rad", number(p.q_rad)},
                                     {"torque_Nm", number(p.torque_Nm)},
                                     {"torque_low_Nm", number(p.torque_low_Nm)},
                                     {"torque_high_Nm", number(p.torque_high_Nm)},
                                     {"z_rad", number(p.z_rad)},
                                     {"dz_dt_rad_s", number(p.dz_rad_s)}};
  }
  return named;
}

/// Many positions share the room of three.
std::size_t points_of_each(std::size_t loops) {
  return std::clamp<std::size_t>(600 / std::max<std::size_t>(loops, 1), 40, 200);
}

Json drawn_loop(const HysteresisResult& h, std::size_t k) {
  if (k >= h.traces.size()) return nullptr;
  const auto loop =
      steady_loop(h.traces[k], h.oscillations[k], points_of_each(h.oscillations.size()));
  if (!loop) return nullptr;
  return {{"centre_rad", number(loop->centre_rad)},
          {"angle_from_centre_rad", short_numbers(loop->from_centre_rad)},
          {"torque_Nm", short_numbers(loop->torque_Nm)}};
}

}  // namespace

Json hysteresis(const HysteresisResult& h) {
  Json oscillations = Json::array();
  for (std::size_t k = 0; k < h.oscillations.size(); ++k) {
    const Oscillation& o = h.oscillations[k];
    oscillations.push_back({{"centre_rad", number(o.centre_rad)},
                            {"amplitude_rad", number(o.amplitude_rad)},
                            {"frequency_Hz", number(o.frequency_Hz)},
                            {"cycles", number(o.cycles)},
                            {"steady_cycles", number(o.steady_cycles)},
                            {"encoder_step_rad", number(o.encoder_step_rad)},
                            {"step_is_of_print", o.step_is_of_print},
                            {"steady_loop", drawn_loop(h, k)}});
  }
  return {{"found", h.found},
          {"bristle_source", text_or_null(h.bristle_source)},
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

Json surrogate_masses(const SurrogateMassesResult& result) {
  Json list = Json::array();
  for (const SurrogateMass& m : result.masses) {
    list.push_back({{"estimator", m.estimator},
                    {"torque_Nm", interval(m.torque_Nm)},
                    {"q_rad", number(m.q_rad)},
                    {"mass_kg", interval(m.mass_kg)},
                    {"gravity_Nm", interval(m.gravity_Nm)}});
  }
  return list;
}

}  // namespace tribolog::json
