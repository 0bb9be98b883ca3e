// Eq. (1) and (2): where they agree, where they do not, and what is impossible.

#include "friction/static_laws.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "friction/catalogue.h"
#include "friction/lugre.h"
#include "wording/words.h"

namespace tribolog::static_laws_test {
namespace {

const friction::StribeckFriction stribeck({{1.0, 1.5, 0.1, 2.0}, 0.4});
const friction::ThresholdSpeedFriction threshold({1.0, 1.5, 20.0, 0.4, 1e-3});

TEST(StaticLaws, FallFromStaticToCoulombTorqueAndRiseViscously) {
  EXPECT_NEAR(stribeck.torque_Nm(1e-9), 1.5, 1e-6);
  EXPECT_NEAR(stribeck.torque_Nm(10) - 0.4 * 10, 1.0, 1e-12);
  EXPECT_NEAR(threshold.torque_Nm(10) - 0.4 * 10, 1.0, 1e-12);
  EXPECT_LT(stribeck.torque_Nm(0.2), stribeck.torque_Nm(0.01));
}

TEST(StaticLaws, AreOdd) {
  for (const double speed : {1e-6, 5e-4, 1e-3, 0.1, 3.0}) {
    EXPECT_DOUBLE_EQ(stribeck.torque_Nm(-speed), -stribeck.torque_Nm(speed));
    EXPECT_DOUBLE_EQ(threshold.torque_Nm(-speed), -threshold.torque_Nm(speed));
  }
}

// Eq. (1) holds at rest whatever is applied, up to break-away; eq. (2) never holds.
TEST(StaticLaws, AtRestOneHoldsAndTheOtherCreeps) {
  EXPECT_EQ(stribeck.torque_Nm(0), 0);
  EXPECT_EQ(stribeck.torque_at_rest_Nm(0.7), 0.7);
  EXPECT_EQ(stribeck.torque_at_rest_Nm(-9), -1.5);
  EXPECT_EQ(threshold.torque_Nm(0), 0);
  EXPECT_NEAR(threshold.torque_Nm(5e-4) / threshold.torque_Nm(1e-3), 0.5, 1e-12);
}

// As printed both branches say |w| >= wth; the errata's reading makes them meet.
TEST(StaticLaws, ThresholdBranchesMeet) {
  const double at = threshold.parameters().threshold_rad_s;
  EXPECT_NEAR(threshold.torque_Nm(std::nextafter(at, 0.0)), threshold.torque_Nm(at), 1e-12);
}

TEST(StaticLaws, AreMadeByNameFromNamedParameters) {
  const friction::WaiboerFriction waiboer({0.8844, 5.0, 0.7, 0.12, 0.6, 1e5});
  const std::vector<const friction::StaticFriction*> originals{&stribeck, &threshold, &waiboer};
  ASSERT_EQ(friction::static_friction_laws().size(), originals.size());
  for (std::size_t i = 0; i < originals.size(); ++i) {
    EXPECT_EQ(friction::static_friction_laws()[i].name, originals[i]->name());
    const auto made = friction::static_friction_laws()[i].make(originals[i]->named_parameters());
    EXPECT_EQ(made->named_parameters(), originals[i]->named_parameters());
    for (const double speed : {-2.0, 0.0, 5e-4, 0.3}) {
      EXPECT_EQ(made->torque_Nm(speed), originals[i]->torque_Nm(speed));
    }
  }
}

TEST(StaticLaws, HaveWordsForTheirNamesSourcesAndParameters) {
  for (const friction::StaticLawEntry& law : friction::static_friction_laws()) {
    EXPECT_FALSE(wording::words_for("friction_model", law.name).empty());
    EXPECT_FALSE(wording::words_for("friction_source", law.name).empty());
    for (const friction::NamedParameter& one : law.parameters) {
      EXPECT_FALSE(wording::words_for("parameter." + law.name, one.key).empty()) << one.key;
    }
  }
}

TEST(StaticLaws, SteadyFrictionIsTheDynamicModelsOwn) {
  const auto lugre = std::make_shared<friction::LuGreFriction>(
      friction::LuGreFriction::Parameters{500, 0.5, 0.4, 1.0, 1.5, 0.1});
  const friction::SteadyFriction steady(lugre);
  EXPECT_EQ(steady.name(), "lugre");
  EXPECT_EQ(steady.named_parameters(), lugre->named_parameters());
  for (const double speed : {-3.0, -0.05, 1e-6, 0.1, 4.0}) {  // eq. (5) is the curve of eq. (1)
    EXPECT_NEAR(steady.torque_Nm(speed), stribeck.torque_Nm(speed), 1e-12);
  }
  EXPECT_THROW(friction::SteadyFriction(nullptr), std::invalid_argument);
}

TEST(StaticLaws, RefuseWhatCannotBe) {
  EXPECT_THROW(friction::StribeckFriction({{1.6, 1.5, 0.1, 2.0}, 0.4}), std::invalid_argument);
  EXPECT_THROW(friction::StribeckFriction({{1.0, 1.5, 0.1, 2.0}, -0.4}), std::invalid_argument);
  EXPECT_THROW(friction::ThresholdSpeedFriction({1.0, 1.5, 20.0, 0.4, 0.0}), std::invalid_argument);
  EXPECT_THROW(friction::ThresholdSpeedFriction({1.6, 1.5, 20.0, 0.4, 1e-3}),
               std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::static_laws_test
