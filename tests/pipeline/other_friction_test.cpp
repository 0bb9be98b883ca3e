// The method on joints whose friction is not LuGre's: the mid-line owes nothing to the model.

#include <gtest/gtest.h>

#include "friction/catalogue.h"
#include "pipeline.h"
#include "support/paper_joint.h"

namespace tribolog {
namespace {

class OtherFriction : public testing::TestWithParam<std::string> {};

/// All that are elastic before they slide; the others have no loop to speak of.
std::vector<std::string> presliding_models() {
  std::vector<std::string> names;
  for (const FrictionModelEntry& one : dynamic_friction_models()) {
    if (one.traits.presliding) names.push_back(one.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Pipeline, OtherFriction, testing::ValuesIn(presliding_models()),
                         [](const auto& which) { return which.param; });

TEST_P(OtherFriction, MidlineGivesTheMassWhateverTheModel) {
  for (const bool noisy : {false, true}) {
    Scenario scenario = noisy ? test::noisy_paper_joint(7) : test::paper_joint();
    scenario.presliding_model = GetParam();
    const Calibration c = identify(test::simulated_dataset(scenario));
    const SurrogateMass* midline = c.masses.find("midline");
    ASSERT_NE(midline, nullptr);
    EXPECT_EQ(c.selection.recommended, "midline");
    // Bonds that snap at random scatter; each of the others is its own mirror image.
    const double allowed = GetParam() == "haessig_bristles" ? 0.01 : 0.002;
    EXPECT_NEAR(midline->mass_kg.value / test::true_surrogate_mass_kg, 1, allowed) << noisy;
    EXPECT_NEAR(c.precise.q_peak_rad.value, test::true_q_peak_rad(), noisy ? 0.02 : 1e-6);
  }
}

}  // namespace
}  // namespace tribolog
