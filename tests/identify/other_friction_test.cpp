// The method on joints whose friction is not LuGre's: the mid-line owes nothing to the model.

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "friction/catalogue.h"
#include "identify/identify.h"
#include "support/breadth.h"
#include "support/paper_joint.h"

namespace tribolog::other_friction_test {
namespace {

using method::hysteresis::Estimator;
using method::hysteresis::LuGreParameterName;
using method::selection::CurveReference;

/// The paper's contact, as every model is matched to it.
friction::ContactParameters contact() {
  const friction::LuGreFriction::Parameters p = test::paper_contact().parameters();
  return {p.bristle_stiffness_Nm_rad,
          p.bristle_damping_Nms_rad,
          p.viscous_Nms_rad,
          p.coulomb_Nm,
          p.static_Nm,
          p.stribeck_speed_rad_s};
}

class OtherFriction : public testing::TestWithParam<std::string> {
 protected:
  /// Bonds that snap at random scatter; each of the others is its own mirror image.
  [[nodiscard]] static double mass_error() {
    return GetParam() == "haessig_bristles" ? 0.01 : 0.002;
  }
};

/// All that are elastic before they slide; the others have no loop to speak of.
std::vector<std::string> presliding_models() {
  std::vector<std::string> names;
  for (const friction::FrictionModelEntry& one : friction::dynamic_friction_models()) {
    if (one.traits.presliding) names.push_back(one.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Pipeline, OtherFriction, testing::ValuesIn(presliding_models()),
                         [](const auto& which) { return which.param; });

TEST_P(OtherFriction, MidlineGivesTheMassWhateverTheModel) {
  for (const bool noisy : {false, true}) {
    if (!noisy && !test::every_case()) continue;
    simulate::Scenario scenario = noisy ? test::noisy_paper_joint(7) : test::paper_joint();
    scenario.presliding = friction::dynamic_friction_model(GetParam()).matched(contact());
    const calibration::Calibration c = identify::identify(simulate::simulated_dataset(scenario));
    const method::hysteresis::SurrogateMass* midline = c.masses.find(Estimator::midline);
    ASSERT_NE(midline, nullptr);
    EXPECT_EQ(c.selection.recommended, Estimator::model);
    EXPECT_NEAR(midline->mass_kg.value / test::true_surrogate_mass_kg, 1, mass_error()) << noisy;
    EXPECT_NEAR(c.precise.q_peak_rad.value, test::true_q_peak_rad(), noisy ? 0.02 : 1e-6);
  }
}

/// The verdict on the bristle stiffness; LuGre's is fitted, whatever the joint's friction.
const calibration::QuantityVerdict& stiffness_of(const calibration::Calibration& c) {
  const auto& all = c.judgement.quantities;
  return *std::find_if(all.begin(), all.end(), [](const calibration::QuantityVerdict& q) {
    return q.quantity == joint::Quantity::bristle_stiffness;
  });
}

TEST_P(OtherFriction, StiffnessIsUsableOnlyWhereLuGreDescribesTheLoop) {
  simulate::Scenario scenario = test::noisy_paper_joint(7);
  scenario.presliding = friction::dynamic_friction_model(GetParam()).matched(contact());
  const calibration::Calibration c = identify::identify(simulate::simulated_dataset(scenario));
  const auto stiffness = c.lugre->shown(LuGreParameterName::bristle_stiffness);
  if (!stiffness) {
    EXPECT_NE(GetParam(), "lugre");
    return;
  }
  const double error = stiffness->value / contact().stiffness_Nm_rad - 1;
  constexpr double small = 0.05;
  const bool is_usable = stiffness_of(c).verdict == calibration::Verdict::usable;
  EXPECT_TRUE(!is_usable || std::abs(error) < small) << error;
  EXPECT_TRUE(is_usable || GetParam() != "lugre") << error;
}

/// The matched model with one parameter changed.
std::shared_ptr<const friction::DynamicFriction> with(const std::string& model,
                                                      const friction::NamedParameter& own) {
  const friction::FrictionModelEntry& entry = friction::dynamic_friction_model(model);
  friction::NamedParameters values = entry.matched_parameters(contact());
  for (friction::NamedParameter& one : values) {
    if (one.key == own.key) one.value = own.value;
  }
  return entry.make(values);
}

/// For each model one parameter that no other has, far from the matched one.
friction::NamedParameter own_parameter(const std::string& model) {
  static const std::map<std::string, friction::NamedParameter> own{
      {"dahl", {"exponent", false, 0.5}},
      {"haessig_bristles", {"bristles", false, std::uint64_t{2000}}},
      {"reset_integrator", {"stiction_gain", false, 0.1}},
      {"bliman_sorine", {"way_ratio", false, 0.25}},
      {"armstrong", {"rise_time_s", false, 0.005}},
      {"lugre", {"bristle_damping_Nms_rad", false, 0.1}},
      {"leuven", {"transition_power", false, 1.5}},
      {"elasto_plastic", {"break_away_deflection_rad", false, 2e-4}},
      {"gms",
       {"elements", false,
        std::vector<friction::MaxwellElement>{{300, 0.2}, {120, 0.3}, {60, 0.5}}}}};
  return own.at(model);
}

TEST_P(OtherFriction, MidlineGivesTheMassWithOwnParameters) {
  simulate::Scenario scenario = test::paper_joint();
  scenario.presliding = with(GetParam(), own_parameter(GetParam()));
  ASSERT_NE(scenario.presliding->named_parameters(),
            friction::dynamic_friction_model(GetParam()).matched_parameters(contact()));
  const calibration::Calibration c = identify::identify(simulate::simulated_dataset(scenario));
  const method::hysteresis::SurrogateMass* midline = c.masses.find(Estimator::midline);
  ASSERT_NE(midline, nullptr);
  EXPECT_NEAR(midline->mass_kg.value / test::true_surrogate_mass_kg, 1, mass_error());
}

class WholeJoint : public testing::TestWithParam<std::string> {};

std::vector<std::string> all_models() {
  std::vector<std::string> names;
  for (const friction::FrictionModelEntry& one : friction::dynamic_friction_models())
    names.push_back(one.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Pipeline, WholeJoint, testing::ValuesIn(all_models()),
                         [](const auto& which) { return which.param; });

// One dynamic model drives sweeps, oscillation and runs. At constant speed it has forgotten its
// start, so that the sweep's mass leaves the model's steady curve, and nothing else.
TEST_P(WholeJoint, SlidesOnTheModelsSteadyCurve) {
  simulate::Scenario scenario = test::paper_joint();
  const friction::FrictionModelEntry& model = friction::dynamic_friction_model(GetParam());
  scenario.presliding = model.matched(contact());
  if (model.traits.remembers_rest) {  // any rest is then a long one
    scenario.presliding = with(GetParam(), {"rise_time_s", false, 1e-6});
  }
  scenario.sliding = nullptr;
  const calibration::Calibration c = identify::identify(simulate::simulated_dataset(scenario));
  // 500 random bonds scatter by 1/sqrt(500) of 3/sqrt(5) Coulomb torques, less after averaging.
  const double friction_error_Nm = GetParam() == "haessig_bristles" ? 0.01 : 1e-4;
  const method::viscous::ViscousCurve* curve = c.viscous.find(Estimator::sweep);
  ASSERT_TRUE(curve != nullptr && c.viscous.runs.size() == 40);
  for (std::size_t i = 0; i < c.viscous.runs.size(); ++i) {
    const double speed = c.viscous.runs[i].speed_rad_s;
    EXPECT_NEAR(curve->friction_Nm[i], scenario.presliding->steady_torque_Nm(speed),
                friction_error_Nm)
        << speed;
  }
  const method::selection::QualityError* error = c.quality.find(Estimator::sweep);
  ASSERT_NE(error, nullptr);
  EXPECT_EQ(c.quality.reference, model.traits.remembers_rest ? CurveReference::direction_difference
                                                             : CurveReference::analytic);
  // Half the difference of the directions is good to 2e-3 N·m (viscous_curves_test).
  const double reference_error_Nm = model.traits.remembers_rest ? 2e-3 : friction_error_Nm;
  EXPECT_LT(error->rms_percent, 100 * reference_error_Nm / 3.0) << "of 3 N·m and more";
  // A scatter of the torque moves a flat peak far: 0.05 rad off cost 0.1 % of it.
  EXPECT_NEAR(c.precise.q_peak_rad.value, test::true_q_peak_rad(),
              model.traits.is_random ? 0.05 : 1e-3);
}

}  // namespace
}  // namespace tribolog::other_friction_test
