#include "calibration/calibration_json.h"

#include "base/shown_text.h"
#include "calibration/parts.h"
#include "wording/language.h"
#include "wording/words.h"

namespace tribolog::calibration {
namespace {

Json stage_list(const Calibration& c) {
  Json list = Json::array();
  for (const statistics::StageReport& s : c.stages()) {
    list.push_back({{"name", s.name},
                    {"status", statistics::to_string(s.state)},
                    {"reason", words_or_null(s.reason)},
                    {"reason_code", code_of(s.reason)}});
  }
  return list;
}

const char* const units =
    "SI: rad, rad/s, N·m, kg, s. Joint angles q are on the arm's side. Torques, bristle "
    "deflections z and motor speeds are on the motor's side of the gear unless the key says joint.";

}  // namespace

std::string calibration_json(const Calibration& c, const Provenance& provenance) {
  const wording::WordsIn english({});
  const double n = c.manifest.drive.gear_ratio();
  Json all;
  all["schema"] = "tribolog-calibration-1";
  all["units"] = units;
  all["robot"] = robot(c.manifest);
  all["drive"] = drive(c.manifest);
  all["verdict"] = verdict(c.judgement);
  all["data_checks"] = data_checks(c.data_checks);
  all["inputs"] = inputs(c.inputs);
  all["conversions"] = conversions(c.inputs);
  all["speeds"] = speeds(c.speed_sources);
  all["notes"] = wording::words(c.notes);
  all["stages"] = stage_list(c);
  all["cog"] = {
      {"rough", cog(c.rough, n)},
      {"precise", cog(c.precise, n)},
      {"q_peak_rad", interval(c.q_peak_rad)},
      {"q_peak_source", c.q_peak_source ? Json(to_string(*c.q_peak_source)) : Json(nullptr)}};
  all["hysteresis"] = hysteresis(c.hysteresis, c.curves);
  all["surrogate"] = {{"distance_m", number(c.manifest.surrogate_distance_m)},
                      {"gravity_m_s2", number(c.manifest.gravity_m_s2)}};
  all["surrogate_masses"] = surrogate_masses(c.masses);
  all["viscous"] = viscous(c.viscous);
  all["quality"] = quality(c.quality);
  all["selection"] = selection(c.selection);
  all["friction"] = friction(c, n);
  all["curve_model"] = curve_model(c.curve_model);
  all["direction_lines"] = direction_lines(c.direction_lines, n);
  all["direction_asymmetry"] = direction_asymmetry(c.direction_asymmetry);
  all["load_dependence"] = load_dependence(c.load_dependence);
  all["run_gravity"] = run_gravity(c.run_gravity, n);
  all["known_loads"] = known_loads(c.manifest.known_loads);
  all["known_gravity"] = known_gravity(c.manifest.known_gravity);
  all["loop_shapes"] = loop_shapes(c.loop_shapes);
  all["break_away"] = break_away(c.break_away, n);
  all["intervals"] = intervals(c.intervals);
  all["cross_checks"] = cross_checks(c.cross_checks);
  all["ripple"] = ripple(c.rough.ripple);
  all["position_plan"] = position_plan(c.position_plan);
  all["truth_check"] = truth_check(c.truth_check);
  all["provenance"] = provenance_json(provenance);
  return json_without_hidden(all.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace tribolog::calibration
