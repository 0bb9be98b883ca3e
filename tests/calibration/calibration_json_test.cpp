#include "calibration/calibration_json.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "identify/identify.h"
#include "report/run_python.h"
#include "report/sample_calibration.h"
#include "support/paper_joint.h"

namespace tribolog::test::calibration_json_test {
namespace {

using nlohmann::json;

json parsed(const calibration::Calibration& c) {
  return json::parse(calibration::calibration_json(c, sample_provenance()));
}

/// Reads the calibration and the schema; prints every fault.
void expect_valid(const calibration::Calibration& c) {
  if (!has_python_module("jsonschema")) GTEST_SKIP() << "python3-jsonschema is not installed";
  const std::string program =
      "import json, sys, jsonschema\n"
      "schema, calibration = json.load(open(sys.argv[1]))\n"
      // Before version 4 it knows drafts up to 7, and finds no place in what a urn names.
      "newest = getattr(jsonschema, 'Draft202012Validator', jsonschema.Draft7Validator)\n"
      "if newest is jsonschema.Draft7Validator: del schema['$id']\n"
      "validator = newest(schema)\n"
      "validator.check_schema(schema)\n"
      "faults = list(validator.iter_errors(calibration))\n"
      "for f in faults: print(list(f.path), f.message[:300])\n"
      "sys.exit(1 if faults else 0)\n";
  EXPECT_TRUE(run_python(program, "[" + calibration::calibration_schema() + "," +
                                      calibration::calibration_json(c, sample_provenance()) + "]"));
}

TEST(CalibrationJson, FollowsTheSchemaWhenComplete) { expect_valid(complete_calibration()); }

TEST(CalibrationJson, FollowsTheSchemaWithAKnownTruthCheck) {
  calibration::Calibration c = complete_calibration();
  c.truth_check.runs = 2;
  c.truth_check.quantities = {
      {calibration::ReadingName::midline, "N·m", 3.9, 3.8, 0.1, 0.01, 2, 0, {-9, -11}, false},
      {calibration::ReadingName::q_peak,
       "rad",
       -0.4,
       std::nan(""),
       std::nan(""),
       std::nan(""),
       0,
       0,
       {},
       false}};
  c.truth_check.left_out = {
      {"truth.not_simulated", {{"recording", "run.csv"}, {"why", Statement{"truth.no_curve"}}}}};
  c.truth_check.findings = {
      {calibration::ReadingName::midline, Statement::verbatim("the mid-line does not come back")}};
  expect_valid(c);
  const json check = parsed(c)["truth_check"];
  EXPECT_EQ(check["quantities"][0]["came_back"], 3.8);
  EXPECT_TRUE(check["quantities"][1]["came_back"].is_null());
}

TEST(CalibrationJson, FollowsTheSchemaWhenHalfIsMissing) { expect_valid(sweep_only()); }

TEST(CalibrationJson, FollowsTheSchemaWithoutAnyData) {
  const joint::Dataset nothing;
  expect_valid(identify::identify(nothing));
}

TEST(CalibrationJson, FollowsTheSchemaForTheSimulatedJoint) {
  const joint::Dataset dataset = simulate::simulated_dataset(noisy_paper_joint(3));
  expect_valid(identify::identify(dataset));
}

TEST(CalibrationJson, HasTheCodeBesideTheWords) {
  calibration::Calibration c = complete_calibration();
  c.judgement.sentence = {"verdict.no_torque"};
  c.judgement.findings = {{"verdict.known_to_share", {{"percent", 41.5}}},
                          {"verdict.nothing_independent", {{"why", Statement{"truth.no_curve"}}}}};
  const json verdict = parsed(c)["verdict"];
  EXPECT_EQ(verdict["sentence_code"], "verdict.no_torque");
  EXPECT_EQ(verdict["findings"][0], "known only to ± 42 %");
  EXPECT_EQ(verdict["findings_code"][0],
            json::parse(R"({"code": "verdict.known_to_share", "values": {"percent": 41.5}})"));
  EXPECT_EQ(verdict["findings_code"][1]["values"]["why"], json::parse(R"(["truth.no_curve"])"));
  expect_valid(c);
}

TEST(CalibrationJson, HoldsTheSteadyLoopInFewDigits) {
  const joint::Dataset dataset = simulate::simulated_dataset(noisy_paper_joint(3));
  const calibration::Calibration c = identify::identify(dataset);
  const json loop = parsed(c)["hysteresis"]["oscillations"][0]["steady_loop"];
  ASSERT_EQ(loop["torque_Nm"].size(), 200U);
  ASSERT_EQ(loop["angle_from_centre_rad"].size(), 200U);
  double low = 1e9, high = -1e9;
  for (const json& torque : loop["torque_Nm"]) {
    EXPECT_LE(torque.dump().size(), 8U) << "six digits, a point and a sign";
    low = std::min(low, torque.get<double>());
    high = std::max(high, torque.get<double>());
  }
  // The means of many cycles hold less noise than the whole trace does.
  EXPECT_LT(high - low, c.hysteresis.loop_height_Nm);
  EXPECT_GT(high - low, 0.8 * c.hysteresis.loop_height_Nm);
}

TEST(CalibrationJson, HasTheContractsKeys) {
  const json j = parsed(complete_calibration());
  EXPECT_EQ(j["schema"], "tribolog-calibration-1");
  EXPECT_EQ(j["robot"]["name"], "FANUC AM100iB");
  EXPECT_EQ(j["inputs"][1]["skipped"][0]["rows"], 1200);
  EXPECT_DOUBLE_EQ(j["cog"]["precise"]["q_peak_rad"]["estimate"].get<double>(), -0.388019);
  EXPECT_DOUBLE_EQ(j["cog"]["rough"]["gravity_joint_Nm"]["estimate"].get<double>(), 388.318571);
  EXPECT_DOUBLE_EQ(j["hysteresis"]["points"]["B"]["torque_Nm"].get<double>(), 3.866);
  EXPECT_TRUE(j["hysteresis"]["points"]["F"].contains("dz_dt_rad_s"));
  EXPECT_EQ(j["surrogate_masses"][9]["estimator"], "midline");
  EXPECT_NEAR(j["surrogate_masses"][9]["mass_kg"]["estimate"].get<double>(), sample_mass_kg, 1e-3);
  EXPECT_EQ(j["viscous"]["runs"].size(), j["viscous"]["curves"]["B"].size());
  EXPECT_EQ(j["quality"]["percent"]["AB"].size(), j["viscous"]["runs"].size());
  EXPECT_DOUBLE_EQ(j["quality"]["rms_percent"]["B"].get<double>(), 0.41);
  EXPECT_EQ(j["selection"]["recommended"], "midline");
  EXPECT_EQ(j["stages"].size(), 8U);
}

TEST(CalibrationJson, JointSideIsTheMotorSideTimesTheGear) {
  const json j = parsed(complete_calibration())["friction"];
  const auto ratio = [](const json& sides) {
    return sides["joint"]["estimate"].get<double>() / sides["motor"]["estimate"].get<double>();
  };
  EXPECT_NEAR(ratio(j["waiboer"]["asperity_torque_Nm"]), 100.0, 1e-9);
  EXPECT_NEAR(ratio(j["lugre"]["bristle_stiffness_Nm_rad"]), 1e4, 1e-7);
  EXPECT_NEAR(ratio(j["waiboer"]["stribeck_speed_rad_s"]), 0.01, 1e-12);
  // Both sides dissipate the same power: T_joint w_joint = T_motor w_motor at every speed.
  EXPECT_NEAR(ratio(j["waiboer"]["viscous_coefficient"]), std::pow(100.0, 1.4), 1e-6);
}

TEST(CalibrationJson, WhatIsMissingIsNull) {
  const json j = parsed(sweep_only());
  EXPECT_TRUE(j["cog"]["precise"]["q_peak_rad"].is_null());
  EXPECT_TRUE(j["hysteresis"]["points"].is_null());
  EXPECT_TRUE(j["selection"]["paper_rule"].is_null());
  EXPECT_TRUE(j["friction"]["waiboer"].is_null());
}

TEST(CalibrationJson, NumbersThatAreNotFiniteAreNull) {
  calibration::Calibration c = complete_calibration();
  c.quality.errors[0].percent[0] = std::numeric_limits<double>::quiet_NaN();
  c.viscous.runs[0].direction_difference_Nm = std::numeric_limits<double>::infinity();
  c.rough.q_peak_rad.value = std::numeric_limits<double>::quiet_NaN();
  const json j = parsed(c);
  EXPECT_TRUE(j["quality"]["percent"]["A"][0].is_null());
  EXPECT_TRUE(j["viscous"]["runs"][0]["direction_difference_Nm"].is_null());
  EXPECT_TRUE(j["cog"]["rough"]["q_peak_rad"].is_null());
}

TEST(CalibrationJson, SurvivesTextThatIsNotUtf8) {
  calibration::Calibration c = complete_calibration();
  c.manifest.note = "a\xff\"b";
  c.viscous.runs[0].recording.assign(1, '\xc3');
  EXPECT_EQ(parsed(c)["robot"]["note"], "a\uFFFD\"b");
}

TEST(CalibrationJson, SameCalibrationSameBytesInAFixedOrder) {
  const std::string text =
      calibration::calibration_json(complete_calibration(), sample_provenance());
  EXPECT_EQ(text, calibration::calibration_json(complete_calibration(), sample_provenance()));
  EXPECT_EQ(text.rfind("{\n \"schema\": \"tribolog-calibration-1\",\n \"units\"", 0), 0U);
  EXPECT_LT(text.find("\"cog\""), text.find("\"hysteresis\": {"));
}

}  // namespace
}  // namespace tribolog::test::calibration_json_test
