#include "simulate/model_portrait.h"

#include <cmath>

#include <gtest/gtest.h>

namespace tribolog::model_portrait_test {
namespace {

TEST(ModelPortrait, ShowsWhatTheCatalogueClaims) {
  const friction::ContactParameters contact;
  std::size_t looked_at = 0;
  for (const friction::FrictionModelEntry& entry : friction::dynamic_friction_models()) {
    if (entry.traits.is_random) continue;
    ++looked_at;
    const simulate::ModelPortrait p = simulate::portrait_of(entry, contact);
    if (entry.traits.break_away) {
      EXPECT_NEAR(p.largest_Nm, contact.static_Nm, 0.05) << entry.name;
    }
    if (entry.traits.non_local_memory) {
      EXPECT_NEAR(p.inner_loop_gap_Nm, 0, 2e-3) << entry.name;
    }
    if (entry.traits.lag) {
      EXPECT_GT(p.lag_Nm, 5e-4) << entry.name;
    }
    for (const simulate::PortraitCurve* curve : {&p.steady, &p.loop, &p.lag, &p.break_away}) {
      ASSERT_EQ(curve->x.size(), curve->torque_Nm.size());
      ASSERT_GT(curve->x.size(), 100U);
      for (const double torque : curve->torque_Nm) {
        ASSERT_TRUE(std::isfinite(torque)) << entry.name;
        EXPECT_LE(std::abs(torque), 1.1 * contact.static_Nm) << entry.name;
      }
    }
  }
  EXPECT_GT(looked_at, 0U);
}

// A joint instead of table 1's unit mass: ways, speeds and torques are of another size, shapes not.
TEST(ModelPortrait, ScalesWithTheContact) {
  const friction::ContactParameters small;
  friction::ContactParameters joint;
  constexpr double torque = 0.6;
  constexpr double way = 1e2;
  joint.coulomb_Nm = torque * small.coulomb_Nm;
  joint.static_Nm = torque * small.static_Nm;
  joint.stiffness_Nm_rad = torque / way * small.stiffness_Nm_rad;
  joint.stribeck_speed_rad_s = way * small.stribeck_speed_rad_s;
  joint.viscous_Nms_rad = torque / way * small.viscous_Nms_rad;
  joint.damping_Nms_rad = torque / way * small.damping_Nms_rad;
  std::size_t looked_at = 0;
  for (const friction::FrictionModelEntry& entry : friction::dynamic_friction_models()) {
    // A jump, or a bond that snaps, may fall on either side of a sample.
    if (!entry.traits.presliding || entry.traits.is_random) continue;
    ++looked_at;
    const simulate::ModelPortrait a = simulate::portrait_of(entry, small);
    const simulate::ModelPortrait b = simulate::portrait_of(entry, joint);
    for (std::size_t i = 0; i < a.loop.x.size(); i += 50) {
      EXPECT_NEAR(b.loop.x[i], way * a.loop.x[i], 1e-9) << entry.name;
      EXPECT_NEAR(b.loop.torque_Nm[i], torque * a.loop.torque_Nm[i], 2e-3) << entry.name;
    }
    EXPECT_NEAR(b.largest_Nm, torque * a.largest_Nm, 2e-3) << entry.name;
  }
  EXPECT_GT(looked_at, 0U);
}

}  // namespace
}  // namespace tribolog::model_portrait_test
