#include <cmath>

#include <nlohmann/json.hpp>

#include "base/shown_text.h"
#include "inspect/survey/log_survey.h"
#include "wording/words.h"

namespace tribolog::inspect::survey {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json json_of(const ColumnSurvey& c) {
  ordered_json json{{"name", c.name},
                    {"lowest", number(c.lowest)},
                    {"highest", number(c.highest)},
                    {"step", c.step},
                    {"gaps", c.gaps},
                    {"constant", c.is_constant()}};
  if (!c.words.empty()) {
    json["words"] = c.words;
    for (const char* const number : {"lowest", "highest", "step"}) json[number] = nullptr;
  }
  if (!c.meaning) return json;
  const ingest::layout::ColumnMeaning& m = *c.meaning;
  json["meaning"] = {{"quantity", ingest::log::quantity_word(m.quantity)},
                     {"joint", m.joint},
                     {"unit", m.unit},
                     {"unit_is_stated", m.unit_is_stated},
                     {"unit_is_proven", c.unit_is_proven},
                     {"is_target", m.is_target}};
  if (!m.effort.remark.empty()) json["meaning"]["remark"] = m.effort.remark;
  if (!c.guessed_by.empty()) json["meaning"]["guessed_by"] = c.guessed_by;
  return json;
}

ordered_json json_of(const ClockSurvey& c) {
  ordered_json gaps = ordered_json::array();
  for (const ClockGap& gap : c.gaps)
    gaps.push_back({{"at_s", gap.at_s}, {"length_s", gap.length_s}});
  return {{"column", c.column},
          {"unit", c.unit},
          {"unit_is_stated", c.unit_is_stated},
          {"unit_is_proven", c.is_proven},
          {"counts_from_1970", c.origin != 0},
          {"first_s", c.first_s},
          {"last_s", c.last_s},
          {"interval_s", c.interval_s},
          {"jitter_percent", c.jitter_percent},
          {"repeated", c.repeated},
          {"back", c.back},
          {"largest_step_back_s", c.largest_step_back_s},
          {"missing", c.missing},
          {"gaps", std::move(gaps)}};
}

ordered_json json_of(const motion::MotionSegment& s) {
  ordered_json json{{"kind", motion::to_string(s.kind)},
                    {"from_s", s.from_s},
                    {"to_s", s.to_s},
                    {"lowest_rad", s.lowest_rad},
                    {"highest_rad", s.highest_rad}};
  if (s.strokes > 0) {
    json["strokes"] = s.strokes;
    json["speed_rad_s"] = s.speed_rad_s;
    json["direction"] = s.direction;
  }
  if (s.frequency_Hz > 0) json["frequency_Hz"] = s.frequency_Hz;
  if (s.kind == motion::MotionKind::break_away_ramp) {
    json["effort_a_second"] = s.effort_rate;
    json["joint_slid"] = s.joint_slid;
  }
  return json;
}

ordered_json json_of(const TableSurvey& table) {
  ordered_json json{{"group", table.group}, {"rows", table.rows}, {"logger", table.logger}};
  for (const ColumnSurvey& c : table.columns) json["columns"].push_back(json_of(c));
  if (table.clock) json["clock"] = json_of(*table.clock);
  json["joints"] = ordered_json::array();
  for (const JointSurvey& joint : table.joints) {
    ordered_json one{{"name", joint.name},
                     {"angle", table.columns[joint.angle].name},
                     {"lowest_rad", joint.lowest_rad},
                     {"highest_rad", joint.highest_rad}};
    if (joint.speed) one["speed"] = table.columns[*joint.speed].name;
    if (joint.effort) one["effort"] = table.columns[*joint.effort].name;
    one["segments"] = ordered_json::array();
    for (const motion::MotionSegment& s : joint.segments) one["segments"].push_back(json_of(s));
    json["joints"].push_back(std::move(one));
  }
  return json;
}

}  // namespace

std::string survey_json(const std::vector<LogSurvey>& logs, const std::string& manifest) {
  ordered_json all{{"schema", "tribolog-inspection-1"}, {"logs", ordered_json::array()}};
  for (const LogSurvey& log : logs) {
    ordered_json json{{"file", log.file}};
    if (!log.refusal.empty()) {
      json["refusal"] = log.refusal;
    } else {
      json["format"] = ingest::log::to_string(log.format);
      json["notes"] = wording::words(log.notes);
      for (const TableSurvey& table : log.tables) json["tables"].push_back(json_of(table));
    }
    all["logs"].push_back(std::move(json));
  }
  if (!manifest.empty()) all["manifest"] = manifest;
  constexpr int indent = 1;
  // What is no UTF-8 in a log's names is replaced, not refused.
  return json_without_hidden(
             all.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace)) +
         "\n";
}

}  // namespace tribolog::inspect::survey
