#include "calibration/read_calibration.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "calibration/calibration_json.h"
#include "report/sample_calibration.h"

namespace tribolog::calibration::read_calibration_test {
namespace {

using nlohmann::json;

std::string written() {
  return calibration_json(test::complete_calibration(), test::sample_provenance());
}

TEST(ReadCalibration, FindsWhatWasWritten) {
  const Calibration c = test::complete_calibration();
  const RecordedCalibration read = read_calibration(written(), "c.json");
  EXPECT_EQ(read.facts.of.robot, c.manifest.robot);
  EXPECT_EQ(read.facts.gear_ratio, c.manifest.drive.gear_ratio());
  EXPECT_EQ(read.facts.verdict, c.judgement.verdict);
  ASSERT_EQ(read.quantities.size(), c.judgement.quantities.size());
  for (std::size_t k = 0; k < read.quantities.size(); ++k) {
    const QuantityVerdict& stated = c.judgement.quantities[k];
    EXPECT_EQ(read.quantities[k].name, to_string(stated.quantity));
    EXPECT_EQ(read.quantities[k].unit, stated.unit);
    EXPECT_EQ(read.quantities[k].verdict, stated.verdict);
    ASSERT_EQ(read.quantities[k].estimate.has_value(), stated.estimate.has_value());
    if (!stated.estimate) continue;
    EXPECT_EQ(read.quantities[k].estimate->value, stated.estimate->value);
    EXPECT_EQ(read.quantities[k].estimate->low, stated.estimate->low);
    EXPECT_EQ(read.quantities[k].estimate->high, stated.estimate->high);
  }
  ASSERT_EQ(read.inputs.size(), c.inputs.size());
  EXPECT_EQ(read.inputs.front().sha256, c.inputs.front().sha256);
  EXPECT_EQ(read.curves.friction.estimator, to_string(c.selection.recommended));
  EXPECT_EQ(read.curves.friction.speed_rad_s.size(), c.viscous.runs.size());
  EXPECT_FALSE(read.curves.friction.from_sweep);
}

TEST(ReadCalibration, FindsFrictionAtSpeeds) {
  Calibration c = test::complete_calibration();
  c.judgement.friction_at_speed = {
      {0.5,
       Verdict::usable,
       {0.3, 0.29, 0.31, {}},
       {},
       false,
       {{0.32, 0.3, 0.33, {}}},
       {{0.28, 0.27, 0.29, {}}}},
      {5, Verdict::doubtful, {0.4, 0.3, 0.5, {}}, {"model.negative_friction"}}};
  const std::string text = calibration_json(c, test::sample_provenance());
  const std::vector<FrictionAtSpeed> read = read_curves(text).friction_at_speed;
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].speed_rad_s, 0.5);
  EXPECT_EQ(read[0].torque_Nm.value, 0.3);
  EXPECT_EQ(read[0].torque_Nm.low, 0.29);
  EXPECT_EQ(read[0].torque_Nm.high, 0.31);
  EXPECT_TRUE(read[0].reason.empty());
  ASSERT_TRUE(read[0].forward_Nm && read[0].backward_Nm);
  EXPECT_EQ(read[0].forward_Nm->high, 0.33);
  EXPECT_EQ(read[0].backward_Nm->value, 0.28);
  EXPECT_FALSE(read[1].forward_Nm);
  EXPECT_EQ(read[1].verdict, Verdict::doubtful);
  EXPECT_FALSE(read[1].reason.empty());

  json older = json::parse(text);
  older.erase("friction_at_speed");
  EXPECT_TRUE(read_calibration(older.dump(), "c.json").curves.friction_at_speed.empty());
  json damaged = json::parse(text);
  damaged["friction_at_speed"][0]["low"] = nullptr;
  damaged["friction_at_speed"][1]["verdict"] = "fine";
  damaged["friction_at_speed"].push_back(7);
  EXPECT_TRUE(read_calibration(damaged.dump(), "c.json").curves.friction_at_speed.empty());
}

TEST(ReadCalibration, TakesWhatOlderProgramsStatedBesideIt) {
  json older = json::parse(written());
  older["session"] = {{"examined", true}, {"drift", {{"found", true}, {"change", -0.2}}}};
  older["load_dependence"] = nullptr;
  older["torque_lag"] = {{"lag_s", {{"estimate", 1e-3}, {"low", 9e-4}, {"high", 1.1e-3}}},
                         {"is_clear", true},
                         {"shape", "delay"}};
  older["truth_check"]["what_if"] = json::array({{{"effect", "lag"}, {"size", 1e-3}}});
  json& rules = older["verdict"]["rules"];
  if (!rules.empty()) {
    rules.push_back(rules.front());
    rules.back()["rule"] = "torque_lag";
  }
  for (const char* key : {"friction_of_loops", "friction_of_ramps"}) older["model"].erase(key);
  const RecordedCalibration now = read_calibration(written(), "c.json");
  const RecordedCalibration then = read_calibration(older.dump(), "c.json");
  ASSERT_EQ(then.quantities.size(), now.quantities.size());
  for (std::size_t k = 0; k < now.quantities.size(); ++k) {
    EXPECT_EQ(then.quantities[k].name, now.quantities[k].name);
    EXPECT_EQ(then.quantities[k].verdict, now.quantities[k].verdict);
  }
  EXPECT_EQ(read_evidence(older.dump()).size(), read_evidence(written()).size());
}

/// The schema of the object that lies there, through references and alternatives.
const json& resolved(const json& schema, const json& root) {
  if (schema.contains("$ref")) {
    const auto reference = schema["$ref"].get<std::string>();
    return resolved(root.at(json::json_pointer(reference.substr(1))), root);
  }
  if (!schema.contains("oneOf")) return schema;
  for (const json& one : schema["oneOf"]) {
    const json& found = resolved(one, root);
    if (found.value("type", json()) != "null") return found;
  }
  return schema;
}

bool may_be_null(const json& schema) {
  const json type = schema.value("type", json());
  if (type.is_array()) return std::find(type.begin(), type.end(), "null") != type.end();
  return type == "null" || (schema.contains("oneOf") && [&] {
           return std::any_of(schema["oneOf"].begin(), schema["oneOf"].end(), may_be_null);
         }());
}

/// Every place of the document that the schema lets be null, or be left out.
void collect(const json& schema, const json& document, const json& root,
             const json::json_pointer& at, std::vector<json::json_pointer>& places) {
  const json& here = resolved(schema, root);
  if (document.is_object() && here.contains("properties")) {
    for (const auto& [key, value] : document.items()) {
      if (!here["properties"].contains(key)) continue;
      const json& inner = here["properties"][key];
      if (may_be_null(inner)) places.push_back(at / key);
      collect(inner, value, root, at / key, places);
    }
  }
  if (document.is_array() && !document.empty() && here.contains("items")) {
    collect(here["items"], document[0], root, at / 0, places);
  }
}

TEST(ReadCalibration, TakesWhateverTheSchemaLetsBeNull) {
  const json schema = json::parse(calibration_schema());
  const json document = json::parse(written());
  std::vector<json::json_pointer> places;
  collect(schema, document, schema, json::json_pointer(), places);
  EXPECT_GT(places.size(), 50U);
  for (const json::json_pointer& place : places) {
    json changed = document;
    changed[place] = nullptr;
    EXPECT_NO_THROW((void)read_calibration(changed.dump(), "c.json")) << place.to_string();
  }
}

TEST(ReadCalibration, RefusesAnotherTypeThanTheSchemas) {
  for (const char* place : {"/schema", "/robot/name", "/drive/gear_ratio", "/verdict/verdict",
                            "/verdict/quantities", "/inputs", "/provenance/created_utc"}) {
    json changed = json::parse(written());
    changed[json::json_pointer(place)] = json::array({1});
    EXPECT_THROW((void)read_calibration(changed.dump(), "c.json"), InputError) << place;
  }
}

joint::Certificate sample_certificate() {
  joint::Certificate c;
  int count = 0;
  for (std::string* const text :
       {&c.number, &c.replaces, &c.laboratory, &c.laboratory_address, &c.customer,
        &c.customer_address, &c.place, &c.received_on, &c.procedure, &c.conditions, &c.adjustment,
        &c.decision_rule, &c.responsible}) {
    *text = "text " + std::to_string(++count);
  }
  c.country = "PL";
  c.humidity_percent = 45.5;
  c.instruments = {{"a", "b", "c", "d"}, {"e", "", "", ""}};
  return c;
}

TEST(ReadCalibration, FindsWhatTheManifestStatedForACertificate) {
  Calibration c = test::complete_calibration();
  EXPECT_EQ(read_certificate(written()), joint::Certificate{});
  c.manifest.certificate = sample_certificate();
  EXPECT_EQ(read_certificate(calibration_json(c, test::sample_provenance())),
            c.manifest.certificate);
  EXPECT_EQ(read_certificate("{}"), joint::Certificate{}) << "of an older program";
  EXPECT_EQ(read_certificate(R"({"certificate": {"number": 3, "instruments": 4}})"),
            joint::Certificate{});
}

void expect_same(const UncertaintyBudget& read, const UncertaintyBudget& stated) {
  EXPECT_EQ(read.standard_uncertainty, stated.standard_uncertainty);
  EXPECT_EQ(read.coverage_factor, stated.coverage_factor);
  EXPECT_EQ(read.freedom, stated.freedom);
  EXPECT_EQ(read.expanded.low, stated.expanded.low);
  EXPECT_EQ(read.expanded.high, stated.expanded.high);
  EXPECT_EQ(read.not_stated, stated.not_stated);
  ASSERT_EQ(read.parts.size(), stated.parts.size());
  for (std::size_t k = 0; k < read.parts.size(); ++k) {
    EXPECT_EQ(read.parts[k].influence, stated.parts[k].influence);
    EXPECT_EQ(read.parts[k].is_type_b, stated.parts[k].is_type_b);
    EXPECT_EQ(read.parts[k].stated, stated.parts[k].stated);
    EXPECT_EQ(read.parts[k].sensitivity, stated.parts[k].sensitivity);
    EXPECT_EQ(read.parts[k].standard_uncertainty, stated.parts[k].standard_uncertainty);
    EXPECT_EQ(read.parts[k].freedom, stated.parts[k].freedom);
  }
}

TEST(ReadCalibration, FindsWhatTheNumbersRestOn) {
  Calibration c = test::complete_calibration();
  ASSERT_FALSE(c.judgement.quantities.empty());
  QuantityVerdict& first = c.judgement.quantities.front();
  const statistics::Estimate estimate{2, 1.5, 3, {}};
  first.estimate = estimate;
  first.budget = combined(
      estimate,
      {{Influence::recordings, false, std::nullopt, 1, 0.3, 9.5, 0},
       {Influence::gear_ratio, true, 2.0, -1, 0.02, std::numeric_limits<double>::infinity(), 0}},
      {Influence::gravity});
  const auto read = read_evidence(calibration_json(c, test::sample_provenance()));
  ASSERT_EQ(read.size(), c.judgement.quantities.size());
  for (const QuantityVerdict& q : c.judgement.quantities) {
    const RecordedEvidence& found = read.at(to_string(q.quantity));
    EXPECT_EQ(found.reasons.size(), q.reasons.size());
    EXPECT_EQ(found.limits.size(), q.limits.size());
    ASSERT_EQ(found.budget.has_value(), q.budget.has_value());
    if (q.budget) expect_same(*found.budget, *q.budget);
  }
  EXPECT_TRUE(read_evidence("{}").empty());
  // A budget of which a part cannot be read is none.
  json changed = json::parse(calibration_json(c, test::sample_provenance()));
  changed["verdict"]["quantities"][0]["budget"]["parts"][0]["influence"] = "of a newer program";
  EXPECT_FALSE(read_evidence(changed.dump()).at(to_string(first.quantity)).budget);
}

TEST(RecordedCurves, ReadsTheRecommendedCurveAndTheLoops) {
  const RecordedCurves c = read_curves(R"({
    "selection": {"recommended": "midline"},
    "viscous": {"runs": [{"speed_rad_s": -3, "torque_half_width_Nm": 0.1}, {"speed_rad_s": 4}],
                "curves": {"A": [9, 9], "midline": [-0.5, 0.6]}},
    "hysteresis": {"oscillations": [
      {"steady_loop": {"centre_rad": 0.2, "angle_from_centre_rad": [0, 1, 0], "torque_Nm": [1, 2, 3]}},
      {"steady_loop": null}, {}]}})");
  EXPECT_EQ(c.friction.estimator, "midline");
  EXPECT_EQ(c.friction.speed_rad_s, (std::vector<double>{-3, 4}));
  EXPECT_EQ(c.friction.friction_Nm, (std::vector<double>{-0.5, 0.6}));
  ASSERT_EQ(c.loops.size(), 1U);
  EXPECT_EQ(c.loops.front().torque_Nm, (std::vector<double>{1, 2, 3}));
}

TEST(RecordedCurves, WhatIsOfAnotherShapeIsNotRecorded) {
  for (
      const char* json :
      {"", "no json", "[]", "3", "{}", R"({"viscous": 3, "selection": [], "hysteresis": null})",
       R"({"viscous": {"runs": [1, 2], "curves": {"A": [1, 2]}}, "selection": {"recommended": "A"}})",
       R"({"viscous": {"runs": [{}], "curves": {"A": ["x"]}}, "selection": {"recommended": "B"}})",
       R"({"hysteresis": {"oscillations": [{"steady_loop": {"centre_rad": 1,
            "angle_from_centre_rad": [1, 2], "torque_Nm": [1, 2, 3]}}]}})"}) {
    const RecordedCurves c = read_curves(json);
    EXPECT_TRUE(c.friction.speed_rad_s.empty()) << json;
    EXPECT_TRUE(c.loops.empty()) << json;
  }
}

}  // namespace
}  // namespace tribolog::calibration::read_calibration_test
