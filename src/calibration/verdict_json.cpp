// The verdict over all, on each quantity, and against the manifest's limits.

#include <utility>

#include "calibration/parts.h"

namespace tribolog::json {
namespace {

Json limits(const std::vector<LimitOutcome>& outcomes) {
  Json list = Json::array();
  for (const LimitOutcome& o : outcomes) {
    list.push_back({{"quantity", o.key},
                    {"rule", o.rule},
                    {"limit", number(o.limit)},
                    {"unit", o.unit},
                    {"estimate", interval(o.estimate)},
                    {"state", to_string(o.state)},
                    {"words", o.words}});
  }
  return list;
}

}  // namespace

Json verdict(const Judgement& judgement) {
  Json quantities = Json::array();
  for (const QuantityVerdict& q : judgement.quantities) {
    quantities.push_back({{"key", q.key},
                          {"words", q.words},
                          {"verdict", to_string(q.verdict)},
                          {"decides", q.decides},
                          {"reasons", q.reasons},
                          {"experiment", text_or_null(q.experiment)},
                          {"estimate", interval(q.estimate)},
                          {"unit", text_or_null(q.unit)},
                          {"limits", limits(q.limits)}});
  }
  return {{"verdict", to_string(judgement.verdict)},
          {"sentence", judgement.sentence},
          {"findings", judgement.findings},
          {"quantities", std::move(quantities)}};
}

}  // namespace tribolog::json
