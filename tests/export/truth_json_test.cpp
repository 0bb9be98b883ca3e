#include "export/truth_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "ingest/scenario_file.h"

namespace tribolog {
namespace {

const std::string example = std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/";

TEST(TruthJson, HoldsThePapersTruth) {
  const auto truth =
      nlohmann::json::parse(truth_json(read_scenario(example + "scenario_ripple.toml")));
  EXPECT_NEAR(truth.at("surrogate_mass_kg").get<double>(), 79.1679, 5e-5);
  EXPECT_NEAR(truth.at("gravity_torque_motor_Nm").get<double>(), 3.88318571, 1e-12);
  EXPECT_NEAR(truth.at("gravity_torque_joint_Nm").get<double>(), 388.318571, 1e-9);
  EXPECT_NEAR(truth.at("q_peak_rad").get<double>(), -0.388019, 5e-7);
  EXPECT_NEAR(truth.at("q_c_rad").get<double>(), 0.388019, 5e-7);
  EXPECT_EQ(truth.at("presliding").at("bristle_stiffness_Nm_rad"), 465.42);
  EXPECT_EQ(truth.at("sliding").at("viscous_power"), 0.6);
  EXPECT_EQ(truth.at("noise").at("ripple").size(), 2U);
  EXPECT_EQ(truth.at("noise").at("seed"), 1);
  EXPECT_EQ(truth.at("robot"), "FANUC AM100iB");
}

TEST(TruthJson, TakesTextsThatAreNotUtf8) {
  Scenario s;
  s.robot = std::string("\xff");
  EXPECT_EQ(nlohmann::json::parse(truth_json(s)).at("robot"), "\ufffd");
}

}  // namespace
}  // namespace tribolog
