#include "method/viscous/viscous_curves.h"

#include <cmath>

#include <gtest/gtest.h>

#include "friction/static_laws.h"
#include "support/paper_joint.h"

namespace tribolog::viscous_curves_test {
namespace {

using method::hysteresis::Estimator;

struct Chain {
  joint::Dataset dataset;
  method::gravity::CogSweepResult rough;
  method::hysteresis::SurrogateMassesResult masses;
  method::viscous::ViscousCurvesResult viscous;
};

Chain run(const simulate::Scenario& s) {
  Chain c;
  c.dataset = simulate::simulated_dataset(s);
  const method::motion::Sweep sweep(c.dataset.with_role(joint::Role::rough_sweep));
  c.rough =
      method::gravity::identify_cog_sweep(method::gravity::SweepKind::rough, sweep, 100).result;
  c.masses = method::hysteresis::identify_surrogate_masses(c.rough, {}, c.rough.q_peak_rad, 100,
                                                           0.5, 9.81);
  c.viscous = method::viscous::identify_viscous_curves(
      method::motion::SteadyRuns(c.dataset.with_role(joint::Role::constant_speed)), {}, sweep,
      c.rough, c.masses, c.rough.q_peak_rad, 100);
  return c;
}

TEST(ViscousCurves, EveryRunGivesTheTrueFriction) {
  const simulate::Scenario s = test::paper_joint();
  const Chain c = run(s);
  EXPECT_EQ(c.viscous.stage.state, statistics::StageState::done);
  ASSERT_EQ(c.viscous.runs.size(), 40U);
  const method::viscous::ViscousCurve* curve = c.viscous.find(Estimator::sweep);
  ASSERT_NE(curve, nullptr);
  for (std::size_t i = 0; i < c.viscous.runs.size(); ++i) {
    const method::viscous::ConstantSpeedRun& r = c.viscous.runs[i];
    const double truth = s.sliding->torque_Nm(r.speed_rad_s);
    EXPECT_NEAR(curve->friction_Nm[i], truth, 1e-8) << r.speed_rad_s;
    // The half difference of the directions needs no mass at all.
    ASSERT_GE(r.partner, 0);
    EXPECT_NEAR(c.viscous.runs[static_cast<std::size_t>(r.partner)].speed_rad_s, -r.speed_rad_s,
                1e-6 * std::abs(r.speed_rad_s));
    EXPECT_NEAR(r.direction_difference_Nm, truth, 2e-3);
  }
}

// The other static laws of the paper, discontinuous at rest or nearly so.
TEST(ViscousCurves, FollowEveryStaticLaw) {
  simulate::Scenario s = test::paper_joint();
  const std::vector<std::shared_ptr<const friction::StaticFriction>> laws{
      std::make_shared<friction::StribeckFriction>(
          friction::StribeckFriction::Parameters{{0.45, 0.88, 5, 2}, 0.002}),
      std::make_shared<friction::ThresholdSpeedFriction>(
          friction::ThresholdSpeedFriction::Parameters{0.45, 0.88, 0.2, 0.002, 1e-4})};
  for (const auto& law : laws) {
    s.sliding = law;
    const Chain c = run(s);
    const method::viscous::ViscousCurve* curve = c.viscous.find(Estimator::sweep);
    ASSERT_TRUE(curve != nullptr && c.viscous.runs.size() == 40) << law->name();
    for (std::size_t i = 0; i < c.viscous.runs.size(); ++i) {
      const double speed = c.viscous.runs[i].speed_rad_s;
      EXPECT_NEAR(curve->friction_Nm[i], law->torque_Nm(speed), 1e-8) << law->name() << speed;
    }
  }
}

TEST(ViscousCurves, RunsAreSortedAndCounted) {
  const Chain c = run(test::paper_joint());
  std::size_t samples = 0;
  for (std::size_t i = 0; i < c.viscous.runs.size(); ++i) {
    if (i > 0) {
      EXPECT_LT(c.viscous.runs[i - 1].speed_rad_s, c.viscous.runs[i].speed_rad_s);
    }
    samples += c.viscous.runs[i].samples;
  }
  std::size_t recorded = 0;
  for (const joint::Recording* r : c.dataset.with_role(joint::Role::constant_speed))
    recorded += r->size();
  EXPECT_EQ(c.viscous.samples_used, samples);
  EXPECT_EQ(c.viscous.samples_used + c.viscous.samples_left_out, recorded);
}

TEST(ViscousCurves, OneDirectionHasNoPartner) {
  simulate::Scenario s = test::paper_joint();
  s.constant_speed->both_directions = false;
  const Chain c = run(s);
  ASSERT_EQ(c.viscous.runs.size(), 20U);
  for (const method::viscous::ConstantSpeedRun& r : c.viscous.runs) {
    EXPECT_EQ(r.partner, -1);
    EXPECT_TRUE(std::isnan(r.direction_difference_Nm));
  }
}

TEST(ViscousCurves, WithoutRunsOrVaryingSweepThereIsNone) {
  simulate::Scenario s = test::paper_joint();
  s.constant_speed.reset();
  const Chain c = run(s);
  EXPECT_TRUE(c.viscous.runs.empty());
  EXPECT_EQ(c.viscous.stage.state, statistics::StageState::skipped);
}

}  // namespace
}  // namespace tribolog::viscous_curves_test
