#include "archive/store/archive_json.h"

#include <nlohmann/json.hpp>

#include "archive/store/entry_rows.h"
#include "base/shown_text.h"

namespace tribolog::archive::store {
namespace {

using Json = nlohmann::ordered_json;

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json json_of(const calibration::Entry& e) {
  const calibration::Facts& f = e.facts;
  return {{"id", e.id},
          {"revision", e.revision},
          {"robot", f.of.robot},
          {"serial", f.of.serial},
          {"joint", f.of.joint},
          {"measured_at", f.measured_at},
          {"measured_on", f.measured_on},
          {"time_is_stated", f.time_is_stated},
          {"created_utc", f.created_utc},
          {"operator", f.operator_name},
          {"note", f.note},
          {"payload", f.payload},
          {"payload_kg", number(f.payload_kg)},
          {"payload_distance_m", number(f.payload_distance_m)},
          {"temperature_C", number(f.temperature_C)},
          {"gear_ratio", f.gear_ratio},
          {"sampling_Hz", number(f.sampling_Hz)},
          {"verdict", calibration::to_string(f.verdict)},
          {"sentence", f.sentence},
          {"configuration", f.configuration},
          {"tool_version", f.tool_version},
          {"git_revision", f.git_revision},
          {"digest", e.digest}};
}

std::string text_of(const Json& json) {
  return json_without_hidden(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace

std::string entries_json(const std::vector<calibration::Entry>& entries,
                         const calibration::Decisions& decisions) {
  Json list = Json::array();
  for (const calibration::Entry& entry : entries) {
    Json& one = list.emplace_back(json_of(entry));
    const auto decision = decisions.find(entry.id);
    one["decision"] =
        decision == decisions.end() ? Json() : Json(calibration::to_string(decision->second));
  }
  return text_of({{"schema", "tribolog-archive-1"}, {"calibrations", std::move(list)}});
}

std::string entry_json(const calibration::Entry& entry,
                       const std::vector<calibration::Quantity>& quantities,
                       const std::vector<calibration::Input>& inputs,
                       const std::vector<StoredDocument>& documents,
                       const std::vector<calibration::Review>& reviews) {
  Json json{{"schema", "tribolog-archive-entry-1"}};
  json.update(json_of(entry));
  json["quantities"] = Json::array();
  for (const calibration::Quantity& q : quantities) {
    const auto& e = q.estimate;
    json["quantities"].push_back({{"name", q.name},
                                  {"words", q.words},
                                  {"unit", q.unit},
                                  {"verdict", calibration::to_string(q.verdict)},
                                  {"estimate", e ? Json(e->value) : Json()},
                                  {"low", e ? Json(e->low) : Json()},
                                  {"high", e ? Json(e->high) : Json()}});
  }
  json["inputs"] = Json::array();
  for (const calibration::Input& input : inputs) {
    json["inputs"].push_back({{"name", input.name},
                              {"role", input.role},
                              {"bytes", input.bytes},
                              {"sha256", input.sha256}});
  }
  json["documents"] = Json::array();
  for (const StoredDocument& document : documents) {
    json["documents"].push_back({{"kind", to_string(document.kind)},
                                 {"name", document.name},
                                 {"bytes", document.bytes},
                                 {"stored_bytes", document.stored_bytes},
                                 {"sha256", document.sha256}});
  }
  json["reviews"] = Json::array();
  for (const calibration::Review& review : reviews) {
    json["reviews"].push_back({{"at_utc", review.at_utc},
                               {"reviewer", review.reviewer},
                               {"decision", calibration::to_string(review.decision)},
                               {"note", review.note}});
  }
  return text_of(json);
}

std::string added_json(const Added& added, const std::string& file) {
  const Json line{{"id", added.id}, {"is_new", added.is_new}, {"file", file}};
  return json_without_hidden(line.dump(-1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

std::string removed_json(const std::vector<calibration::Entry>& entries) {
  Json ids = Json::array();
  for (const calibration::Entry& entry : entries) ids.push_back(entry.id);
  return text_of({{"schema", "tribolog-archive-removed-1"}, {"removed", std::move(ids)}});
}

std::string verification_json(const Verification& outcome) {
  return text_of({{"schema", "tribolog-archive-verification-1"},
                  {"is_whole", outcome.faults.empty()},
                  {"calibrations", outcome.entries},
                  {"documents", outcome.documents},
                  {"events", outcome.events},
                  {"head", outcome.head},
                  {"faults", outcome.faults}});
}

}  // namespace tribolog::archive::store
