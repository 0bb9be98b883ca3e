#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "api/outcome.h"
#include "calibration/json_values.h"
#include "calibration/read_calibration.h"
#include "wording/language.h"
#include "wording/torques_in.h"
#include "wording/words.h"

namespace tribolog::api {
namespace {

using ReadJson = nlohmann::json;
using calibration::member;

std::string text_of(const ReadJson& value) {
  return value.is_string() ? value.get<std::string>() : std::string();
}

std::optional<double> number_of(const ReadJson& value) {
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

const ReadJson& list_of(const ReadJson& object, const char* key) {
  static const ReadJson none = ReadJson::array();
  const ReadJson& value = member(object, key);
  return value.is_array() ? value : none;
}

/// The element at that place; null where there is none.
const ReadJson& element(const ReadJson& list, std::size_t place) {
  static const ReadJson none;
  return list.is_array() && place < list.size() ? list[place] : none;
}

// A statement out of the code and values that calibration_json() wrote beside its words.

constexpr int deepest = 16;  // statements within statements; ours have three

/// Nothing for a code that has no message here: those of a file are not kept for good.
std::optional<Code> known_code(const std::string& text) {
  if (!wording::has_words(text)) return std::nullopt;
  return Code::of(text);
}

std::optional<Statement> statement_of(const ReadJson& coded, int depth);

std::optional<StatedValue> value_of(const std::string& name, const ReadJson& value, int depth) {
  if (value.is_null()) return StatedValue(name, std::numeric_limits<double>::quiet_NaN());
  if (value.is_number_float()) return StatedValue(name, value.get<double>());
  if (value.is_number_integer()) return StatedValue(name, value.get<std::int64_t>());
  if (value.is_string()) return StatedValue(name, value.get<std::string>());
  if (!value.is_array()) return std::nullopt;
  std::vector<Statement> inner;
  for (const ReadJson& one : value) {
    std::optional<Statement> statement = statement_of(one, depth + 1);
    if (!statement) return std::nullopt;
    inner.push_back(std::move(*statement));
  }
  return StatedValue(name, std::move(inner));
}

std::string code_text(const ReadJson& coded) {
  return text_of(coded.is_object() ? member(coded, "code") : coded);
}

std::optional<Statement> statement_of(const ReadJson& coded, int depth) {
  if (depth > deepest) return std::nullopt;
  if (coded.is_null()) return Statement{};
  const std::optional<Code> code = known_code(code_text(coded));
  if (!code) return std::nullopt;
  std::vector<StatedValue> values;
  if (const ReadJson& stated = member(coded, "values"); stated.is_object()) {
    for (const auto& [name, value] : stated.items()) {
      std::optional<StatedValue> read = value_of(name, value, depth);
      if (!read) return std::nullopt;
      values.push_back(std::move(*read));
    }
  }
  return Statement::with(*code, std::move(values));
}

/// The statement, if its words here are still those of the file: then they can be in any language.
/// Else the file's words.
Said said_as(const ReadJson& words, const ReadJson& coded) {
  const std::string text = text_of(words);
  const std::string code = code_text(coded);
  try {
    const std::optional<Statement> statement = statement_of(coded, 0);
    if (statement && wording::words(*statement) == text) return {*statement, code};
  } catch (const std::exception&) {
    // A value is missing, or of another type: a program of another version wrote it.
  }
  return {Statement::verbatim(text), code};
}

Said said_by(const ReadJson& object, const std::string& key) {
  return said_as(member(object, key), member(object, key + "_code"));
}

std::vector<Said> list_said_by(const ReadJson& object, const std::string& key) {
  const ReadJson& words = list_of(object, key.c_str());
  const ReadJson& codes = member(object, key + "_code");
  std::vector<Said> all;
  for (std::size_t k = 0; k < words.size(); ++k) {
    all.push_back(said_as(words[k], element(codes, k)));
  }
  return all;
}

// The parts of the file.

Joint joint_of(const calibration::Facts& f) {
  return {f.of.robot, f.of.serial,  f.of.joint,           f.measured_on,   f.operator_name, f.note,
          f.payload,  f.payload_kg, f.payload_distance_m, f.temperature_C, f.gear_ratio,    false};
}

JudgedQuantity judged(const calibration::Quantity& read, const ReadJson& object,
                      double gear_ratio) {
  JudgedQuantity made;
  made.quantity.name = read.name;
  made.quantity.words = read.words;
  made.quantity.unit = read.unit;
  made.quantity.verdict = verdict_of(read.verdict);
  const ReadJson& decides = member(object, "decides");
  made.quantity.decides = !decides.is_boolean() || decides.get<bool>();
  if (read.estimate) set_estimate(made.quantity, *read.estimate, gear_ratio);
  made.reasons = list_said_by(object, "reasons");
  made.experiment = said_by(object, "experiment");
  return made;
}

/// @param read in the order of `listed`, where some may be missing.
std::vector<JudgedFriction> judged(const std::vector<calibration::FrictionAtSpeed>& read,
                                   const ReadJson& listed, double gear_ratio) {
  std::vector<JudgedFriction> all;
  for (const ReadJson& object : listed) {
    if (all.size() == read.size()) break;
    const calibration::FrictionAtSpeed& next = read[all.size()];
    if (number_of(member(object, "speed_rad_s")) != next.speed_rad_s) continue;
    all.push_back(judged_friction(next, gear_ratio, said_by(object, "reason")));
  }
  return all;
}

Check::State check_state(const std::string& word) {
  if (word == "passed") return Check::State::passed;
  if (word == "warns") return Check::State::warns;
  if (word == "fails") return Check::State::fails;
  return Check::State::not_applicable;
}

MadeCheck check_of(const ReadJson& object) {
  MadeCheck made;
  made.check.name = text_of(member(object, "name"));
  made.check.words = text_of(member(object, "title"));
  made.check.state = check_state(text_of(member(object, "state")));
  made.check.recording = text_of(member(object, "recording"));
  made.check.measured = number_of(member(object, "measured"));
  made.check.at_least = number_of(member(object, "at_least"));
  made.check.at_most = number_of(member(object, "at_most"));
  made.check.unit = text_of(member(object, "unit"));
  made.found = said_by(object, "found");
  made.consequence = said_by(object, "consequence");
  made.experiment = said_by(object, "experiment");
  return made;
}

EndedStage stage_of(const ReadJson& object) {
  const std::string word = text_of(member(object, "status"));
  EndedStage ended;
  ended.stage.name = text_of(member(object, "name"));
  if (word == statistics::to_string(statistics::StageState::done)) {
    ended.stage.state = Stage::State::done;
  } else if (word == statistics::to_string(statistics::StageState::partial)) {
    ended.stage.state = Stage::State::partial;
  } else if (word == statistics::to_string(statistics::StageState::not_identifiable)) {
    ended.stage.state = Stage::State::not_identifiable;
  }
  ended.reason = said_by(object, "reason");
  return ended;
}

/// What no file can have is taken for none.
std::size_t count_of(const ReadJson& value) {
  return value.is_number_unsigned() ? value.get<std::size_t>() : 0;
}

ReadFile file_of(const calibration::Input& input, const ReadJson& object) {
  ReadFile read{{input.name,
                 input.role,
                 input.bytes,
                 input.sha256,
                 count_of(member(object, "rows_read")),
                 count_of(member(object, "rows_used")),
                 {},
                 false},
                {}};
  for (const ReadJson& rows : list_of(object, "skipped")) {
    read.file.skipped.push_back({{}, count_of(member(rows, "rows"))});
    read.why_skipped.push_back(said_by(rows, "reason"));
  }
  return read;
}

/// Of a file of its own, not beside another.
bool has_conversions(const ReadJson& top, const InputFile& file) {
  const bool is_log = !file.role.starts_with("manifest") && file.role != "robot";
  return is_log &&
         std::any_of(list_of(top, "conversions").begin(), list_of(top, "conversions").end(),
                     [&](const ReadJson& one) {
                       const ReadJson& files = list_of(one, "files");
                       return std::find(files.begin(), files.end(), file.name) != files.end();
                     });
}

}  // namespace

Outcome read_outcome(const std::string& json, const std::string& file) {
  const calibration::RecordedCalibration read = calibration::read_calibration(json, file);
  const ReadJson top = ReadJson::parse(json);
  const wording::WordsIn english({});
  Outcome made;
  made.joint = joint_of(read.facts);
  const ReadJson& in_amperes = member(member(top, "drive"), "torque_is_in_amperes");
  made.joint.torque_is_in_amperes = in_amperes.is_boolean() && in_amperes.get<bool>();
  const wording::TorquesIn unit(torque_unit_of(made.joint));
  made.verdict = verdict_of(read.facts.verdict);
  const ReadJson& verdict = member(top, "verdict");
  made.sentence = said_by(verdict, "sentence");
  made.findings = list_said_by(verdict, "findings");
  const ReadJson& quantities = list_of(verdict, "quantities");
  for (std::size_t k = 0; k < read.quantities.size(); ++k) {
    made.quantities.push_back(
        judged(read.quantities[k], element(quantities, k), made.joint.gear_ratio));
  }
  made.friction_at_speeds = judged(read.curves.friction_at_speed, list_of(top, "friction_at_speed"),
                                   made.joint.gear_ratio);
  for (const ReadJson& check : list_of(top, "data_checks")) made.checks.push_back(check_of(check));
  for (const ReadJson& stage : list_of(top, "stages")) made.stages.push_back(stage_of(stage));
  const ReadJson& inputs = list_of(top, "inputs");
  for (std::size_t k = 0; k < read.inputs.size(); ++k) {
    made.inputs.push_back(file_of(read.inputs[k], element(inputs, k)));
    made.inputs.back().file.is_recording = has_conversions(top, made.inputs.back().file);
  }
  made.estimator = text_of(member(member(top, "selection"), "recommended"));
  return made;
}

}  // namespace tribolog::api
