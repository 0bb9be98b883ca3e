// The contest of contacts: each wins on its own loops, and nobody is called where LuGre is right.

#include "method/hysteresis/contact_comparison.h"

#include <cmath>

#include <gtest/gtest.h>

#include "friction/catalogue.h"
#include "friction/lugre.h"
#include "method/hysteresis/lugre_fit.h"
#include "support/loop_fit.h"
#include "support/paper_joint.h"

namespace tribolog::contact_comparison_test {
namespace {

using method::hysteresis::ContactLaw;

/// The paper's joint with another contact of the same stiffness and break-away torque, its loops
/// well into sliding.
/// @param noise times a drive's
simulate::Scenario with_contact(const char* model, double noise, std::uint64_t seed = 1) {
  simulate::Scenario s = test::noisy_paper_joint(seed);
  s.noise.torque_white_Nm *= noise;
  s.oscillation->amplitude_rad = 1e-3;
  const auto& p = dynamic_cast<const friction::LuGreFriction&>(*s.presliding).parameters();
  s.presliding = friction::dynamic_friction_model(model).matched(
      {p.bristle_stiffness_Nm_rad, p.bristle_damping_Nms_rad, p.viscous_Nms_rad, p.coulomb_Nm,
       p.static_Nm, p.stribeck_speed_rad_s});
  return s;
}

double stiffness_put_in() {
  return test::true_parameters(test::paper_joint())
      .at(method::hysteresis::LuGreParameterName::bristle_stiffness);
}

TEST(ContactRivals, EachIsNamedOnItsOwnLoops) {
  struct Case {
    const char* model;
    ContactLaw law;
  };
  for (const Case& c : {Case{"elasto_plastic", ContactLaw::elasto_plastic},
                        Case{"gms", ContactLaw::maxwell_slip}}) {
    const method::hysteresis::LuGreFit fit = test::fit_loops(with_contact(c.model, 0.2));
    ASSERT_EQ(fit.contacts.winner, c.law) << c.model;
    const method::hysteresis::ContactCandidate& found = *fit.contacts.find(c.law);
    EXPECT_NEAR(found.stiffness_Nm_rad / stiffness_put_in(), 1, 0.05) << c.model;
    // LuGre, which is what is fitted, is farther off.
    const auto lugre = fit.shown(method::hysteresis::LuGreParameterName::bristle_stiffness);
    ASSERT_TRUE(lugre);
    EXPECT_LT(std::abs(found.stiffness_Nm_rad - stiffness_put_in()),
              std::abs(lugre->value - stiffness_put_in()))
        << c.model;
  }
}

// One loop of one size tells a contact with two memories from one with many only if noise is low.
TEST(ContactRivals, WhereNoiseHidesWhichItIsNobodyIsNamed) {
  const method::hysteresis::LuGreFit fit = test::fit_loops(with_contact("elasto_plastic", 1.0));
  EXPECT_EQ(fit.contacts.candidates.size(), 3U);
  EXPECT_TRUE(!fit.contacts.winner || fit.contacts.winner == ContactLaw::elasto_plastic);
}

TEST(ContactRivals, ThereIsNoContestWhereLuGreLeavesNothing) {
  const method::hysteresis::LuGreFit fit = test::fit_loops(with_contact("lugre", 1.0));
  EXPECT_TRUE(fit.contacts.candidates.empty());
  EXPECT_FALSE(fit.contacts.winner);
}

}  // namespace
}  // namespace tribolog::contact_comparison_test
