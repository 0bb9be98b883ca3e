#include "archive/store/entry_rows.h"

#include <array>

namespace tribolog::archive {
namespace {

Verdict verdict_of(const std::string& word) {
  for (const Verdict verdict : {Verdict::usable, Verdict::doubtful}) {
    if (tribolog::to_string(verdict) == word) return verdict;
  }
  return Verdict::not_identifiable;
}

}  // namespace

const char* const entry_columns =
    "number, id, identity, revision, robot, serial, joint, measured_at, measured_on, "
    "time_is_stated, created_utc, operator, note, payload, payload_kg, payload_distance_m, "
    "temperature_C, gear_ratio, sampling_Hz, verdict, sentence, configuration, tool_version, "
    "git_revision, digest";

Entry entry_of(const sql::Row& row) {
  std::size_t at = 0;
  const auto text = [&]() -> const std::string& { return row[at++].text(); };
  const auto number = [&] { return row[at++].number_if_any(); };
  Entry e;
  Facts& f = e.facts;
  e.number = row[at++].integer();
  e.id = text();
  e.identity = text();
  e.revision = static_cast<int>(row[at++].integer());
  f.of.robot = text();
  f.of.serial = text();
  f.of.joint = text();
  f.measured_at = text();
  f.measured_on = text();
  f.time_is_stated = row[at++].integer() != 0;
  f.created_utc = text();
  f.operator_name = text();
  f.note = text();
  f.payload = text();
  f.payload_kg = number();
  f.payload_distance_m = number();
  f.temperature_C = number();
  f.gear_ratio = number().value_or(1);
  f.sampling_Hz = number();
  f.verdict = verdict_of(text());
  f.sentence = text();
  f.configuration = text();
  f.tool_version = text();
  f.git_revision = text();
  e.digest = text();
  return e;
}

std::vector<sql::Value> values_of(const Entry& e) {
  const Facts& f = e.facts;
  return {e.id,
          e.identity,
          std::int64_t{e.revision},
          f.of.robot,
          f.of.serial,
          f.of.joint,
          f.measured_at,
          f.measured_on,
          std::int64_t{f.time_is_stated ? 1 : 0},
          f.created_utc,
          f.operator_name,
          f.note,
          f.payload,
          f.payload_kg,
          f.payload_distance_m,
          f.temperature_C,
          f.gear_ratio,
          f.sampling_Hz,
          tribolog::to_string(f.verdict),
          f.sentence,
          f.configuration,
          f.tool_version,
          f.git_revision,
          e.digest};
}

const char* const quantity_columns = "name, words, unit, quantity.verdict, value, low, high";

Quantity quantity_of(const sql::Row& row, std::size_t first) {
  Quantity q;
  q.name = row[first].text();
  q.words = row[first + 1].text();
  q.unit = row[first + 2].text();
  q.verdict = verdict_of(row[first + 3].text());
  const auto value = row[first + 4].number_if_any();
  if (value) {
    q.estimate = Estimate{*value, row[first + 5].number_if_any().value_or(*value),
                          row[first + 6].number_if_any().value_or(*value), ""};
  }
  return q;
}

std::string to_string(DocumentKind kind) {
  static const std::array words{"calibration", "report", "input"};
  return words[static_cast<std::size_t>(kind)];
}

}  // namespace tribolog::archive
