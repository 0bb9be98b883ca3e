#include "history/history_json.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "base/enum_text.h"
#include "base/shown_text.h"
#include "wording/language.h"
#include "wording/words.h"

namespace tribolog::history {

namespace {

OrderedJson calibration(const calibration::Entry& e) {
  const calibration::Facts& f = e.facts;
  return {{"id", e.id},
          {"robot", f.of.robot},
          {"serial", f.of.serial},
          {"joint", f.of.joint},
          {"measured_at", f.measured_at},
          {"temperature_C", json_of(f.temperature_C)},
          {"payload", f.payload},
          {"payload_kg", json_of(f.payload_kg)},
          {"gear_ratio", f.gear_ratio},
          {"sampling_Hz", json_of(f.sampling_Hz)}};
}

std::string key_of(ChangeWord word) {
  constexpr EnumTexts<ChangeWord> keys("no change seen", "changed", "not comparable");
  return std::string(keys.of(word));
}

OrderedJson quantity(const ComparedQuantity& q) {
  const bool is_comparable = q.word != ChangeWord::not_comparable;
  return {{"name", q.name},
          {"words", q.words},
          {"unit", q.unit},
          {"first", json_of(q.first)},
          {"second", json_of(q.second)},
          {"change", q.change ? json_of(q.change->absolute) : OrderedJson()},
          {"change_percent", q.change ? json_of(q.change->percent) : OrderedJson()},
          {"chance", q.change ? OrderedJson(q.change->chance) : OrderedJson()},
          {"adjusted_chance", is_comparable ? OrderedJson(q.adjusted_chance) : OrderedJson()},
          {"word", key_of(q.word)},
          {"why_not", wording::words(q.why_not)},
          {"cautions", wording::words(q.cautions)}};
}

}  // namespace

std::string comparison_json(const Comparison& c) {
  const wording::WordsIn english({});
  OrderedJson json{{"schema", "tribolog-archive-diff-1"},
                   {"first", calibration(c.first)},
                   {"second", calibration(c.second)},
                   {"allowed_temperature_difference_K", c.allowed.temperature_K},
                   {"allowed_rate_factor", c.allowed.rate_factor},
                   {"changed_at_chance", changed_chance},
                   {"changed", c.count(ChangeWord::changed)},
                   {"no_change_seen", c.count(ChangeWord::no_change_seen)},
                   {"not_comparable", c.count(ChangeWord::not_comparable)},
                   {"quantities", OrderedJson::array()},
                   {"remarks", wording::words(c.remarks)}};
  for (const ComparedQuantity& q : c.quantities) json["quantities"].push_back(quantity(q));
  return text_of(json);
}

namespace {

std::string key_of(TrendState state) { return own_name(state); }

std::string key_of(LeftOut why) {
  constexpr EnumTexts<LeftOut> keys("used", "before the baseline", "verdict not usable",
                                    "another gear ratio than the latest",
                                    "another payload than the latest", "temperature not stated");
  return std::string(keys.of(why));
}

std::string key_of(TemperatureUse use) { return own_name(use); }

OrderedJson point(const HistoryPoint& p) {
  const bool is_charted = p.left_out == LeftOut::none;
  OrderedJson made{{"id", p.id}, {"measured_at", p.measured_at}};
  made.update(json_of(p.estimate));
  made["temperature_C"] = json_of(p.temperature_C);
  made["left_out"] = is_charted ? OrderedJson() : OrderedJson(key_of(p.left_out));
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

OrderedJson dates(const LimitDates& limit) {
  const auto date = [](const std::string& day) {
    return day.empty() ? OrderedJson() : OrderedJson(day);
  };
  return {{"percent", limit.percent},
          {"expected_on", date(limit.expected)},
          {"earliest_on", date(limit.earliest)},
          {"latest_on", date(limit.latest)}};
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
          {"size_percent", json_of(c.percent)},
          {"limit", c.limit ? dates(*c.limit) : OrderedJson()}};
}

OrderedJson quantity(const QuantityTrend& q) {
  OrderedJson left_out = OrderedJson::object();
  for (const LeftOut why : {LeftOut::before_baseline, LeftOut::not_usable, LeftOut::other_gear,
                            LeftOut::other_payload, LeftOut::no_temperature}) {
    if (q.count(why) > 0) left_out[key_of(why)] = q.count(why);
  }
  if (q.without_estimate > 0) left_out["without an estimate"] = q.without_estimate;
  if (q.in_another_unit > 0) left_out["in another unit"] = q.in_another_unit;
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
                   {"apart", OrderedJson::array()},
                   {"points", OrderedJson::array()}};
  for (const FoundChange& c : q.changes) made["changes"].push_back(change(c));
  for (const FoundApart& one : q.apart) {
    made["apart"].push_back(
        {{"measured_at", one.at}, {"size", one.size}, {"size_percent", json_of(one.percent)}});
  }
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
                   {"cautions", wording::words(t.cautions)},
                   {"quantities", OrderedJson::array()}};
  for (const QuantityTrend& q : t.quantities) made["quantities"].push_back(quantity(q));
  return made;
}

}  // namespace

std::string trend_json(const std::vector<JointTrend>& trends) {
  const wording::WordsIn english({});
  OrderedJson json{{"schema", "tribolog-archive-trend-1"},
                   {"allowance", cusum_allowance},
                   {"largest_score", largest_score},
                   {"joints", OrderedJson::array()}};
  for (const JointTrend& t : trends) json["joints"].push_back(joint(t));
  return text_of(json);
}

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::optional<Distance>& d) {
  if (!d) return nullptr;
  return {{"z", d->z}, {"median", d->median}, {"scatter", d->scatter}, {"count", d->count}};
}

Json json_of(const FleetCell& cell, const Fleet& fleet) {
  const statistics::Estimate& latest = cell.results.back().estimate;
  const FleetColumn& column = fleet.columns[cell.column];
  return {{"quantity", column.name},
          {"unit", column.unit},
          {"verdict", calibration::to_string(cell.verdict)},
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
      joints.push_back(
          {{"joint", joint.latest.facts.of.joint},
           {"id", joint.latest.id},
           {"measured_at", joint.latest.facts.measured_at},
           {"decision", joint.decision ? Json(calibration::to_string(*joint.decision)) : Json()},
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

}  // namespace tribolog::history
