#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "exports/simulation/simulation_files.h"
#include "friction/catalogue.h"
#include "ingest/manifest/scenario_file.h"

namespace tribolog::truth_json_test {
namespace {

const std::string example = std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/";

TEST(TruthJson, HoldsThePapersTruth) {
  const auto truth = nlohmann::json::parse(exports::simulation::truth_json(
      ingest::manifest::read_scenario(example + "scenario_ripple.toml")));
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

/// Named parameters as JSON would have them, read back.
friction::NamedParameters read_back(const nlohmann::json& stated,
                                    friction::NamedParameters parameters) {
  for (friction::NamedParameter& one : parameters) {
    const auto& value = stated.at(one.key);
    if (auto* number = std::get_if<double>(&one.value)) *number = value.get<double>();
    if (auto* count = std::get_if<std::uint64_t>(&one.value)) *count = value.get<std::uint64_t>();
    if (auto* elements = std::get_if<std::vector<friction::MaxwellElement>>(&one.value)) {
      elements->clear();
      for (const auto& element : value) {
        elements->push_back({element.at("stiffness_Nm_rad"), element.at("share")});
      }
    }
  }
  return parameters;
}

// From truth.json alone the very models that were simulated can be made again.
TEST(TruthJson, HoldsEveryModelWhole) {
  const friction::ContactParameters contact{465.42, 0.7708, 0.001, 0.6, 0.88437633, 5.0};
  for (const friction::FrictionModelEntry& model : friction::dynamic_friction_models()) {
    simulate::Scenario s = ingest::manifest::read_scenario(example + "scenario.toml");
    s.presliding = model.matched(contact);
    const auto whole = nlohmann::json::parse(exports::simulation::truth_json(s));
    EXPECT_EQ(whole.at("presliding").at("model"), model.name);
    EXPECT_EQ(whole.at("presliding").size(), 1 + model.parameters.size());
    EXPECT_EQ(read_back(whole.at("presliding"), model.parameters),
              s.presliding->named_parameters());
    EXPECT_EQ(whole.at("sliding").at("model"), "waiboer");
    s.sliding = nullptr;
    const auto dynamic = nlohmann::json::parse(exports::simulation::truth_json(s));
    EXPECT_EQ(dynamic.at("sliding"), whole.at("presliding"));
  }
}

TEST(TruthJson, TakesTextsThatAreNotUtf8) {
  simulate::Scenario s;
  s.robot = std::string("\xff");
  EXPECT_EQ(nlohmann::json::parse(exports::simulation::truth_json(s)).at("robot"), "\ufffd");
}

}  // namespace
}  // namespace tribolog::truth_json_test
