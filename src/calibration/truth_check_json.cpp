// The known-truth check.

#include <utility>

#include "calibration/parts.h"

namespace tribolog::json {
namespace {

Json returned(const ReturnedQuantity& q) {
  return {{"name", q.name},
          {"unit", q.unit},
          {"put_in", number(q.put_in)},
          {"came_back", number(q.came_back)},
          {"scatter", number(q.scatter)},
          {"half_width", number(q.half_width)},
          {"found", q.found},
          {"inside", q.inside},
          {"in_half_widths", numbers(q.in_half_widths)},
          {"comes_back", q.comes_back}};
}

}  // namespace

Json truth_check(const TruthCheckResult& t) {
  if (t.runs == 0) return nullptr;
  Json quantities = Json::array();
  for (const ReturnedQuantity& q : t.quantities) quantities.push_back(returned(q));
  Json findings = Json::array();
  for (const TruthFinding& finding : t.findings) findings.push_back(finding.words);
  return {{"runs", t.runs},
          {"seed", t.seed},
          {"noise",
           {{"white_Nm", number(t.white_Nm)},
            {"torque_step_Nm", number(t.torque_step_Nm)},
            {"ripple_Nm", number(t.ripple_Nm)}}},
          {"quantities", std::move(quantities)},
          {"left_out", t.left_out},
          {"findings", std::move(findings)}};
}

}  // namespace tribolog::json
