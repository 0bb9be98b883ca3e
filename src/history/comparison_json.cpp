#include "history/comparison_json.h"

#include "history/history_json.h"

namespace tribolog::history {
namespace {

OrderedJson calibration(const archive::Entry& e) {
  const archive::Facts& f = e.facts;
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
          {"word", to_string(q.word)},
          {"why_not", q.why_not},
          {"cautions", q.cautions}};
}

}  // namespace

std::string comparison_json(const Comparison& c) {
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
                   {"remarks", c.remarks}};
  for (const ComparedQuantity& q : c.quantities) json["quantities"].push_back(quantity(q));
  return text_of(json);
}

}  // namespace tribolog::history
