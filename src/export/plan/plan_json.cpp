#include "export/plan/plan_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "base/shown_text.h"
#include "export/plan/plan_table.h"

namespace tribolog {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json part_json(const PlannedPart& part) {
  return {{"role", to_string(part.role)},        {"state", to_string(part.state)},
          {"recordings", part.recordings},       {"duration_s", number(part.duration_s)},
          {"motion", text_or_null(part.motion)}, {"gives", part.gives},
          {"why", text_or_null(part.why)},       {"help", text_or_null(part.help)}};
}

Json segment_json(const PlannedSegment& s) {
  Json made{{"name", s.name},
            {"role", s.role ? Json(to_string(*s.role)) : Json(nullptr)},
            {"start_s", number(s.start_s)},
            {"end_s", number(s.end_s())}};
  if (s.role) {
    made["from_s"] = number(s.from_s);
    made["to_s"] = number(s.to_s);
  }
  if (s.ramp) {
    made["ramp"] = {{"direction", s.ramp->direction},
                    {"rate_Nm_s", number(s.ramp->rate_Nm_s)},
                    {"largest_change_Nm", number(s.ramp->largest_change_Nm)},
                    {"largest_travel_joint_rad", number(s.ramp->largest_travel_rad)}};
  }
  return made;
}

Json expectation_json(const ExpectedInterval& e) {
  return {{"name", e.name},
          {"unit", unit_of(e.quantity)},
          {"assumed_truth", number(e.truth)},
          {"half_width", number(e.half_width)},
          {"scatter", number(e.scatter)},
          {"runs", e.runs},
          {"identified_in", e.found},
          {"held_by_interval_in", e.inside}};
}

template <class List, class ToJson>
Json list_json(const List& list, const ToJson& to_json) {
  Json all = Json::array();
  for (const auto& one : list) all.push_back(to_json(one));
  return all;
}

}  // namespace

std::string plan_json(const ExperimentPlan& plan, const ExpectedIntervals& expected,
                      const Provenance& provenance) {
  const JointFacts& f = plan.joint.facts;
  const Json all{{"schema", "tribolog-plan-1"},
                 {"tool", provenance.tool_version},
                 {"created_utc", provenance.created_utc},
                 {"robot", f.robot},
                 {"joint", f.joint},
                 {"gear_ratio", f.gear_ratio},
                 {"sentence", plan_sentence(plan)},
                 {"duration_s", number(plan.duration_s())},
                 {"effort", plan.effort},
                 {"first_of_two", plan.is_first_of_two()},
                 {"parts", list_json(plan.parts, part_json)},
                 {"remarks", plan.remarks},
                 {"instructions", plan_instructions(plan)},
                 {"positions_joint_rad", plan.positions_rad},
                 {"ripple_left_share", number(plan.ripple_left_share)},
                 {"amplitude_joint_rad", number(plan.amplitude_rad)},
                 {"frequency_Hz", number(plan.frequency_Hz)},
                 {"motor_speeds_rad_s", plan.motor_speeds_rad_s},
                 {"segments", list_json(plan.segments, segment_json)},
                 {"assumptions", list_json(plan.joint.assumptions,
                                           [](const Assumption& a) {
                                             return Json{{"what", a.what},
                                                         {"value", number(a.value)},
                                                         {"unit", text_or_null(a.unit)},
                                                         {"source", a.source},
                                                         {"known", a.is_known}};
                                           })},
                 {"expected",
                  {{"runs", expected.runs},
                   {"seed", expected.seed},
                   {"quantities", list_json(expected.quantities, expectation_json)}}}};
  return json_without_hidden(all.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace tribolog
