#include "method/selection/friction_parameters.h"

#include <cmath>

#include <gtest/gtest.h>

#include "method/viscous/waiboer_fit.h"
#include "statistics/random_stream.h"
#include "support/paper_joint.h"
#include "wording/words.h"

namespace tribolog::friction_parameters_test {
namespace {

std::vector<method::viscous::CurvePoint> curve(const friction::WaiboerFriction& f,
                                               double noise_Nm) {
  statistics::RandomStream random(1, 0);
  std::vector<method::viscous::CurvePoint> points;
  const simulate::Scenario joint = test::paper_joint();
  for (const double w : joint.constant_speed->motor_speeds_rad_s) {
    points.push_back({w, f.magnitude_Nm(w) + noise_Nm * random.normal()});
  }
  return points;
}

TEST(WaiboerFit, RecoversExactParameters) {
  for (const auto& p : {friction::WaiboerFriction::Parameters{0.8844, 5, 0.7, 0.12, 0.6, 1e6},
                        friction::WaiboerFriction::Parameters{12, 20, 2.0, 0.4, 0.1, 1e6},
                        friction::WaiboerFriction::Parameters{0.05, 2, 1.0, 0.003, 0.3, 1e6}}) {
    Statement why;
    const auto fit = method::viscous::fit_waiboer(curve(friction::WaiboerFriction(p), 0), why);
    ASSERT_TRUE(fit) << wording::words(why);
    EXPECT_NEAR(fit->asperity_torque_Nm.value, p.asperity_torque_Nm, 1e-4 * p.asperity_torque_Nm);
    EXPECT_NEAR(fit->stribeck_speed_rad_s.value, p.stribeck_speed_rad_s,
                1e-3 * p.stribeck_speed_rad_s);
    EXPECT_NEAR(fit->stribeck_power.value, p.stribeck_power, 1e-3);
    EXPECT_NEAR(fit->viscous_coefficient.value, p.viscous_coefficient,
                1e-3 * p.viscous_coefficient);
    EXPECT_NEAR(fit->viscous_power.value, p.viscous_power, 1e-3);
  }
}

TEST(WaiboerFit, FollowsANoisyCurve) {
  const friction::WaiboerFriction truth = test::paper_curve();
  Statement why;
  const auto fit = method::viscous::fit_waiboer(curve(truth, 0.002), why);
  ASSERT_TRUE(fit) << wording::words(why);
  for (double w = 1; w <= 300; w += 3) {
    EXPECT_NEAR(method::viscous::waiboer_of(fit)->magnitude_Nm(w), truth.magnitude_Nm(w), 0.01)
        << w;
  }
}

TEST(WaiboerFit, TooFewSpeedsAreRefusedInWords) {
  Statement why;
  EXPECT_FALSE(method::viscous::fit_waiboer({{1, 1}, {2, 1}, {3, 1}}, why));
  EXPECT_NE(wording::words(why).find("3 runs for five parameters"), std::string::npos);
}

}  // namespace
}  // namespace tribolog::friction_parameters_test
