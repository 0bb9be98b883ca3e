#include "history/trend_json.h"

#include <utility>

#include "history/history_json.h"

namespace tribolog::history {
namespace {

const char* key_of(TrendState state) {
  static const char* const keys[] = {"too_few", "steady", "recovered", "warning"};
  return keys[static_cast<std::size_t>(state)];
}

const char* key_of(TemperatureUse use) {
  static const char* const keys[] = {"corrected", "hardly_felt", "too_even", "not_recorded"};
  return keys[static_cast<std::size_t>(use)];
}

OrderedJson point(const HistoryPoint& p) {
  const bool is_charted = p.left_out == LeftOut::none;
  OrderedJson made{{"id", p.id}, {"measured_at", p.measured_at}};
  made.update(json_of(p.estimate));
  made["temperature_C"] = json_of(p.temperature_C);
  made["left_out"] = is_charted ? OrderedJson() : OrderedJson(to_string(p.left_out));
  made["corrected"] = json_of(p.corrected);
  const bool is_judged = is_charted && p.chart.is_judged;
  made["score"] = is_judged ? OrderedJson(p.chart.score) : OrderedJson();
  made["above"] = is_judged ? OrderedJson(p.chart.above) : OrderedJson();
  made["below"] = is_judged ? OrderedJson(p.chart.below) : OrderedJson();
  return made;
}

OrderedJson reference(const std::optional<ReferenceLine>& line, TemperatureUse use) {
  if (!line) return nullptr;
  const bool has_slope = use == TemperatureUse::corrected;
  return {{"calibrations", line->members},
          {"level", line->level},
          {"level_standard_error", std::sqrt(line->level_variance)},
          {"temperature_C", has_slope ? OrderedJson(line->mean_temperature_C) : OrderedJson()},
          {"per_K", has_slope ? OrderedJson(line->slope_per_K) : OrderedJson()},
          {"per_K_standard_error",
           has_slope ? OrderedJson(std::sqrt(line->slope_variance)) : OrderedJson()},
          {"scatter_between", std::sqrt(line->between_variance)},
          {"stated_standard_error", std::sqrt(line->stated_variance)},
          {"stated_share", line->stated_share},
          {"scatter", line->scatter()}};
}

OrderedJson change(const FoundChange& c) {
  return {{"kind", c.is_slow ? "drift" : "shift"},
          {"direction", c.direction > 0 ? "risen" : "fallen"},
          {"since", c.is_slow ? OrderedJson(c.from) : OrderedJson()},
          {"visible_from", c.is_slow ? c.alarm : c.from},
          {"alarm_at", c.alarm},
          {"back_from", c.back.empty() ? OrderedJson() : OrderedJson(c.back)},
          {"calibrations_to_alarm", c.calibrations_to_alarm},
          {"size", json_of(c.size)},
          {"size_percent", json_of(c.percent)}};
}

OrderedJson quantity(const QuantityTrend& q) {
  OrderedJson left_out = OrderedJson::object();
  for (const LeftOut why : {LeftOut::before_baseline, LeftOut::not_usable, LeftOut::other_gear,
                            LeftOut::other_payload, LeftOut::no_temperature}) {
    if (q.count(why) > 0) left_out[to_string(why)] = q.count(why);
  }
  if (q.without_estimate > 0) left_out["without an estimate"] = q.without_estimate;
  OrderedJson made{{"name", q.name},
                   {"words", q.words},
                   {"unit", q.unit},
                   {"state", key_of(q.state)},
                   {"learned_from", q.learned},
                   {"judged", q.judged},
                   {"left_out", std::move(left_out)},
                   {"temperature", key_of(q.temperature)},
                   {"limit", q.limit},
                   {"reference", reference(q.reference, q.temperature)},
                   {"changes", OrderedJson::array()},
                   {"points", OrderedJson::array()}};
  for (const FoundChange& c : q.changes) made["changes"].push_back(change(c));
  for (const HistoryPoint& p : q.points) made["points"].push_back(point(p));
  return made;
}

OrderedJson joint(const JointTrend& t) {
  OrderedJson made{{"robot", t.of.robot},
                   {"serial", t.of.serial},
                   {"joint", t.of.joint},
                   {"state", key_of(t.state())},
                   {"calibrations", t.calibrations},
                   {"first_at", t.first_at},
                   {"last_at", t.last_at},
                   {"quantities_watched", t.watched},
                   {"cautions", t.cautions},
                   {"quantities", OrderedJson::array()}};
  for (const QuantityTrend& q : t.quantities) made["quantities"].push_back(quantity(q));
  return made;
}

}  // namespace

std::string trend_json(const std::vector<JointTrend>& trends) {
  OrderedJson json{{"schema", "tribolog-archive-trend-1"},
                   {"allowance", cusum_allowance},
                   {"largest_score", largest_score},
                   {"joints", OrderedJson::array()}};
  for (const JointTrend& t : trends) json["joints"].push_back(joint(t));
  return text_of(json);
}

}  // namespace tribolog::history
