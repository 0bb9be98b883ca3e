// The paper's claims, put to its own joint and to others.

#include "paper/claims/claims.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include <gtest/gtest.h>

#include "support/paper_joint.h"

namespace tribolog::paper::claims_test {
namespace {

const claims::ArguedJoint& papers() {
  static const claims::ArguedJoint joint(test::paper_joint());
  return joint;
}

class Answers {
 public:
  explicit Answers(const simulate::Scenario& scenario)
      : all_(claims::put_claims(papers(), claims::ArguedJoint(scenario))) {}
  /// Of the claim that holds these words.
  [[nodiscard]] const claims::Claim& to(std::string_view words) const {
    const auto found = std::find_if(all_.begin(), all_.end(), [&](const claims::Claim& claim) {
      return claim.what.find(words) != std::string::npos;
    });
    if (found == all_.end()) throw std::logic_error("no such claim");
    return *found;
  }
  [[nodiscard]] std::optional<bool> holds(std::string_view words) const {
    return to(words).on_this_joint.holds;
  }
  [[nodiscard]] const std::vector<claims::Claim>& all() const { return all_; }

 private:
  std::vector<claims::Claim> all_;
};

TEST(Claims, OfThePaperHoldOnItsJointButForFrictionThatIsLeftAtB) {
  const Answers answers(test::paper_joint());
  for (const claims::Claim& claim : answers.all()) {
    const bool is_of_B = claim.what.find("gravity alone reaches the motor") != std::string::npos;
    EXPECT_EQ(claim.on_papers_joint.holds, !is_of_B) << claim.what;
    EXPECT_EQ(claim.on_this_joint.holds, claim.on_papers_joint.holds) << claim.what;
    EXPECT_EQ(claim.on_this_joint.found, claim.on_papers_joint.found) << claim.what;
  }
  EXPECT_EQ(answers.to("gravity alone").on_this_joint.found, "mass of B off by −0.63\u00a0%");
}

// Fast, damping outweighs the bristle: another point is nearest, and the rule finds that one.
TEST(Claims, BIsNotNearestWhereTheOscillationIsFast) {
  simulate::Scenario s = test::paper_joint();
  s.oscillation->frequency_Hz = 5;
  const Answers answers(s);
  EXPECT_EQ(answers.holds("that of B is nearest"), false);
  EXPECT_EQ(answers.holds("finds the nearest mass"), true);
  EXPECT_EQ(answers.holds("order of table 2"), false);
  EXPECT_EQ(answers.holds("opposite points"), true);
}

TEST(Claims, HoldAtAnotherGearRatioAndAtTheTroughOfGravity) {
  simulate::Scenario s = test::paper_joint();
  s.gear_ratio = 50;
  EXPECT_EQ(Answers(s).holds("that of B is nearest"), true);
  s = test::paper_joint();
  s.load = joint::GravityLoad(s.load.mass_kg(), s.load.distance_m(),
                              s.load.q_peak_rad() + 3.141592653589793, s.load.gravity_m_s2());
  const Answers trough(s);
  EXPECT_EQ(trough.holds("that of B is nearest"), true);
  EXPECT_EQ(trough.holds("less than q_c"), true);
  EXPECT_EQ(trough.holds("The largest torque of the sweep"), false);
}

TEST(Claims, FrictionThatGrowsWithTheLoadIsNotConstant) {
  simulate::Scenario s = test::paper_joint();
  s.effects.load_friction = 0.05;
  EXPECT_EQ(Answers(s).holds("constant value"), false);
}

TEST(Claims, ThatAJointIsNotAskedSayWhy) {
  simulate::Scenario s = test::paper_joint();
  s.oscillation.reset();
  s.constant_speed.reset();
  const Answers answers(s);
  for (const claims::Claim& claim : answers.all()) {
    EXPECT_FALSE(claim.on_this_joint.found.empty()) << claim.what;
  }
  EXPECT_EQ(answers.holds("that of B is nearest"), std::nullopt);
  EXPECT_EQ(answers.holds("No prior knowledge"), std::nullopt);
  EXPECT_EQ(answers.holds("The largest torque of the sweep"), true);
}

}  // namespace
}  // namespace tribolog::paper::claims_test
