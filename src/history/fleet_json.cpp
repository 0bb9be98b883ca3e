#include "history/fleet_json.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "base/shown_text.h"

namespace tribolog::archive {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::optional<Distance>& d) {
  if (!d) return nullptr;
  return {{"z", d->z}, {"median", d->median}, {"scatter", d->scatter}, {"count", d->count}};
}

Json json_of(const FleetCell& cell, const Fleet& fleet) {
  const Estimate& latest = cell.results.back().estimate;
  const FleetColumn& column = fleet.columns[cell.column];
  return {{"quantity", column.name},
          {"unit", column.unit},
          {"verdict", tribolog::to_string(cell.verdict)},
          {"value", latest.value},
          {"low", latest.low},
          {"high", latest.high},
          {"is_outlier", cell.furthest() > fleet.limit},
          {"to_others", json_of(cell.to_others)},
          {"to_history", json_of(cell.to_history)}};
}

}  // namespace

std::string fleet_json(const Fleet& fleet) {
  Json json{{"schema", "tribolog-fleet-1"},
            {"joints", fleet.joints},
            {"calibrations", fleet.calibrations},
            {"distances", fleet.distances},
            {"limit", fleet.limit},
            {"robots", Json::array()}};
  for (const FleetRobot& robot : fleet.robots) {
    Json joints = Json::array();
    for (const FleetJoint& joint : robot.joints) {
      Json quantities = Json::array();
      for (const FleetCell& cell : joint.cells) quantities.push_back(json_of(cell, fleet));
      joints.push_back({{"joint", joint.latest.facts.of.joint},
                        {"id", joint.latest.id},
                        {"measured_at", joint.latest.facts.measured_at},
                        {"decision", joint.decision ? Json(to_string(*joint.decision)) : Json()},
                        {"gear_ratio", joint.latest.facts.gear_ratio},
                        {"calibrations", joint.calibrations},
                        {"furthest_z", joint.furthest},
                        {"quantities", std::move(quantities)}});
    }
    json["robots"].push_back({{"robot", robot.robot},
                              {"serial", robot.serial},
                              {"furthest_z", robot.furthest},
                              {"joints", std::move(joints)}});
  }
  return json_without_hidden(json.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace tribolog::archive
