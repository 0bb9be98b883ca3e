#include <nlohmann/json.hpp>

#include "base/shown_text.h"
#include "calibration/archived_calibration.h"
#include "calibration/friction_speeds.h"
#include "calibration/read_calibration.h"
#include "exports/results/archived_joint.h"
#include "exports/results/calibration_exports.h"
#include "exports/results/friction_table.h"

namespace tribolog::exports::results {
namespace {

using Json = nlohmann::ordered_json;

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json number_or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

Json json_of(const calibration::SidedQuantity& sided) {
  const calibration::Quantity& q = sided.quantity;
  const auto& e = q.estimate;
  return {{"quantity", q.name},
          {"words", q.words},
          {"value", e ? Json(e->value) : Json()},
          {"low", e ? Json(e->low) : Json()},
          {"high", e ? Json(e->high) : Json()},
          {"unit", q.unit},
          {"side", joint::to_string(sided.side)},
          {"verdict", calibration::to_string(q.verdict)},
          {"conversion", calibration::conversion_words(sided.gear_power)}};
}

Json rows_of(const FrictionTable& table) {
  Json rows = Json::array();
  for (const FrictionRow& row : table.rows) {
    rows.push_back(Json::array({row.speed_rad_s, row.friction_Nm}));
  }
  return rows;
}

/// A row for each speed: speed, torque, the ends of its interval, verdict.
Json rows_of(const std::vector<calibration::FrictionAtSpeed>& friction) {
  Json rows = Json::array();
  for (const calibration::FrictionAtSpeed& f : friction) {
    rows.push_back(Json::array({f.speed_rad_s, f.torque_Nm.value, f.torque_Nm.low, f.torque_Nm.high,
                                calibration::to_string(f.verdict)}));
  }
  return rows;
}

/// Null where there is none.
Json friction_at_speed(const ArchivedJoint& joint) {
  const auto at_motor = calibration::read_curves(joint.calibration).friction_at_speed;
  if (at_motor.empty()) return nullptr;
  std::vector<calibration::FrictionAtSpeed> there;
  for (const calibration::FrictionAtSpeed& f : at_motor) {
    there.push_back(calibration::at_joint(f, joint.entry.facts.gear_ratio));
  }
  const char* const torque = joint.is_in_amperes() ? "friction_A" : "friction_Nm";
  return {{"columns", {"speed_rad_s", torque, "low", "high", "verdict"}},
          {"motor", rows_of(at_motor)},
          {"joint", rows_of(there)}};
}

}  // namespace

std::string json_document(const ArchivedJoint& joint, bool is_on_one_line) {
  const calibration::Facts& f = joint.entry.facts;
  Json json{{"schema", "tribolog-export-1"},
            {"comment", comment_lines(joint)},
            {"id", joint.entry.id},
            {"robot", text_or_null(f.of.robot)},
            {"serial", text_or_null(f.of.serial)},
            {"joint", text_or_null(f.of.joint)},
            {"measured_at", f.measured_at},
            {"time_is_stated", f.time_is_stated},
            {"temperature_C", number_or_null(f.temperature_C)},
            {"payload_kg", number_or_null(f.payload_kg)},
            {"gear_ratio", f.gear_ratio},
            {"verdict", calibration::to_string(f.verdict)},
            {"tool_version", f.tool_version}};
  json["quantities"] = Json::array();
  for (const calibration::SidedQuantity& sided :
       calibration::on_both_sides(joint.quantities, f.gear_ratio)) {
    json["quantities"].push_back(json_of(sided));
  }
  const FrictionTable curve = friction_table(joint);
  json["friction_curve"] = nullptr;
  if (!curve.rows.empty()) {
    json["friction_curve"] = {
        {"columns", {"speed_rad_s", joint.is_in_amperes() ? "friction_A" : "friction_Nm"}},
        {"source", curve.source},
        {"motor", rows_of(curve)},
        {"joint", rows_of(at_joint(curve, f.gear_ratio))}};
  }
  json["friction_at_speed"] = friction_at_speed(joint);
  return json_without_hidden(
             json.dump(is_on_one_line ? -1 : 2, ' ', false, Json::error_handler_t::replace)) +
         "\n";
}

}  // namespace tribolog::exports::results
