// Break-away ramps, and the shape of the loops: what the paper has not.

#include <utility>

#include "calibration/parts.h"

namespace tribolog::json {

Json break_away(const BreakAwayResult& result, double gear_ratio) {
  Json ramps = Json::array();
  for (const BreakAwayRamp& r : result.ramps) {
    ramps.push_back({{"recording", r.recording},
                     {"direction", r.is_rising ? "rising" : "falling"},
                     {"broke_away", r.broke_away},
                     {"rate_Nm_s", number(r.rate_Nm_s)},
                     {"torque_Nm", number(r.torque_Nm)},
                     {"friction_Nm", number(r.friction_Nm)},
                     {"q_start_rad", number(r.q_start_rad)},
                     {"travel_rad", number(r.travel_rad)},
                     {"first_slip_rad", number(r.first_slip_rad)},
                     {"largest_yield", number(r.largest_yield)},
                     {"samples_used", r.samples_used},
                     {"samples_left_out", r.samples_left_out}});
  }
  const auto on_both_sides = [&](const std::optional<Estimate>& e) {
    return e ? both_sides(*e, gear_ratio) : Json(nullptr);
  };
  return {{"gravity_taken_off", result.gravity_taken_off},
          {"censored", result.censored},
          {"rising_Nm", on_both_sides(result.rising_Nm)},
          {"falling_Nm", on_both_sides(result.falling_Nm)},
          {"mean_Nm", on_both_sides(result.mean_Nm)},
          {"ramps", std::move(ramps)}};
}

Json loop_shapes(const std::vector<LoopShape>& shapes) {
  Json list = Json::array();
  for (const LoopShape& s : shapes) {
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

}  // namespace tribolog::json
