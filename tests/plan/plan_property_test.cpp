// Any joint: no set point leaves its limits, and the motion is one that a drive can follow.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "joint/degrees.h"
#include "plan/experiment_plan.h"
#include "wording/words.h"

namespace tribolog::plan_property_test {
namespace {

/// A number between the two, evenly over its logarithm.
double somewhere(double from, double to) {
  constexpr int steps = 1'000'000;
  const double share = *rc::gen::inRange(0, steps) / static_cast<double>(steps);
  return from * std::pow(to / from, share);
}

joint::JointFacts any_joint() {
  joint::JointFacts f;
  f.gear_ratio = somewhere(1, 300);
  const double range = somewhere(0.5, 700) * joint::rad_per_degree;
  f.lowest_rad = *rc::gen::inRange(-400, 400) * joint::rad_per_degree;
  f.highest_rad = f.lowest_rad + range;
  f.speed_limit_rad_s = somewhere(1e-3, 30);
  f.acceleration_limit_rad_s2 = somewhere(1e-3, 1000);
  f.torque_limit_Nm = somewhere(0.05, 500);
  if (*rc::gen::inRange(0, 4) > 0) {
    f.q_peak_rad = f.lowest_rad + range * *rc::gen::inRange(-20, 120) / 100.0;
  }
  if (*rc::gen::arbitrary<bool>()) f.gravity_Nm = somewhere(0.01, 2) * f.torque_limit_Nm;
  if (*rc::gen::arbitrary<bool>()) f.static_Nm = somewhere(0.01, 1) * f.torque_limit_Nm;
  if (*rc::gen::arbitrary<bool>()) f.bristle_stiffness_Nm_rad = somewhere(1, 1e5);
  if (*rc::gen::arbitrary<bool>()) f.inertia_kgm2 = somewhere(1e-5, 10);
  if (*rc::gen::arbitrary<bool>()) f.encoder_counts_per_turn = somewhere(100, 1e7);
  if (*rc::gen::arbitrary<bool>()) f.sample_rate_Hz = somewhere(20, 8000);
  if (*rc::gen::arbitrary<bool>()) f.set_point_rate_Hz = somewhere(10, 1000);
  if (*rc::gen::arbitrary<bool>()) f.time_budget_s = somewhere(10, 10'000);
  return f;
}

constexpr double rounding = 1e-9;  // of angles of some rad and rates built from them

void check_segment(const joint::JointFacts& f, const plan::PlannedSegment& s) {
  const double duration = s.motion->duration_s();
  constexpr int samples = 150;
  const double h = std::min(1e-5, duration / (4 * samples));
  for (int i = 0; i <= samples; ++i) {
    const double t = duration * i / samples;
    const double q = s.motion->angle(t);
    RC_ASSERT(q >= f.lowest_rad - rounding);
    RC_ASSERT(q <= f.highest_rad + rounding);
    RC_ASSERT(std::abs(s.motion->speed(t)) <= f.speed_limit_rad_s * (1 + rounding));
    RC_ASSERT(std::abs(s.motion->acceleration(t)) <= f.acceleration_limit_rad_s2 * (1 + rounding));
    const double slope = (s.motion->angle(t + h) - s.motion->angle(t - h)) / (2 * h);
    // What a change of acceleration within h, and the digits of the angle, leave.
    const double allowed = f.acceleration_limit_rad_s2 * h + 1e-14 * (1 + std::abs(q)) / h;
    RC_ASSERT(std::abs(slope - s.motion->speed(t)) <= allowed);
  }
  RC_ASSERT(std::abs(s.motion->speed(0)) <= rounding * f.speed_limit_rad_s);
  RC_ASSERT(std::abs(s.motion->speed(duration)) <= rounding * f.speed_limit_rad_s);
}

TEST(PlanProperty, NoSetPointLeavesTheLimits) {
  EXPECT_TRUE(rc::check([] {
    const joint::JointFacts f = any_joint();
    const plan::ExperimentPlan plan = plan::plan_experiment(f);
    for (const plan::PlannedSegment& s : plan.segments) check_segment(f, s);
  }));
}

TEST(PlanProperty, TheMotionHasNoGapsAndTheRecordingsTheirOrder) {
  EXPECT_TRUE(rc::check([] {
    const plan::ExperimentPlan plan = plan::plan_experiment(any_joint());
    double end_s = 0;
    int last_role = -1;
    for (std::size_t i = 0; i < plan.segments.size(); ++i) {
      const plan::PlannedSegment& s = plan.segments[i];
      RC_ASSERT(s.start_s == end_s);
      end_s = s.end_s();
      if (i > 0) {
        const plan::PlannedSegment& before = plan.segments[i - 1];
        RC_ASSERT(std::abs(before.motion->angle(before.motion->duration_s()) - s.motion->angle(0)) <
                  rounding);
      }
      if (!s.role) continue;
      RC_ASSERT(s.from_s >= s.start_s);
      RC_ASSERT(s.to_s > s.from_s);
      RC_ASSERT(s.to_s <= s.end_s() + rounding);
      RC_ASSERT(static_cast<int>(*s.role) >= last_role);
      last_role = static_cast<int>(*s.role);
    }
    for (const plan::PlannedPart& part : plan.parts) {
      const auto planned = static_cast<std::size_t>(
          std::count_if(plan.segments.begin(), plan.segments.end(),
                        [&](const plan::PlannedSegment& s) { return s.role == part.role; }));
      RC_ASSERT(planned == part.recordings);
      const bool is_there =
          part.state == plan::PartState::planned || part.state == plan::PartState::limited;
      RC_ASSERT(is_there == (part.recordings > 0));
      // What is not simply planned has its reason and what would help.
      RC_ASSERT((part.state == plan::PartState::planned) == part.why.empty());
      RC_ASSERT(part.why.empty() == part.help.empty());
    }
  }));
}

TEST(PlanProperty, WhateverIsStatedHasItsWords) {
  EXPECT_TRUE(rc::check([] {
    const plan::ExperimentPlan plan = plan::plan_experiment(any_joint());
    for (const plan::PlannedSegment& s : plan.segments) RC_ASSERT(!wording::words(s.name).empty());
    for (const plan::PlannedPart& part : plan.parts) {
      RC_ASSERT(!wording::words(part.gives).empty());
      for (const Statement& one : {part.motion, part.why, part.help}) {
        RC_ASSERT(wording::words(one).empty() == one.empty());
      }
    }
    for (const Statement& remark : plan.remarks) RC_ASSERT(!wording::words(remark).empty());
    for (const plan::Assumption& a : plan.joint.assumptions) {
      RC_ASSERT(!wording::words({a.what, a.source}).front().empty());
    }
  }));
}

TEST(PlanProperty, TheDriveCanHoldTheArmWhereverThePlanGoes) {
  EXPECT_TRUE(rc::check([] {
    const plan::ExperimentPlan plan = plan::plan_experiment(any_joint());
    const plan::AssumedJoint& j = plan.joint;
    if (!j.peak_is_known) return;
    for (const plan::PlannedSegment& s : plan.segments) {
      for (const double share : {0.0, 0.2, 0.5, 0.8, 1.0}) {
        const double q = s.motion->angle(share * s.motion->duration_s());
        const double held = j.gravity_Nm * std::abs(std::cos(q - j.q_peak_rad)) + j.static_Nm;
        RC_ASSERT(held <= j.facts.torque_limit_Nm);
      }
      if (s.ramp) {
        const double q = s.motion->angle(0);
        RC_ASSERT(j.gravity_Nm * std::cos(q - j.q_peak_rad) + s.ramp->largest_change_Nm <=
                  j.facts.torque_limit_Nm * (1 + rounding));
      }
    }
  }));
}

TEST(PlanProperty, ABudgetThatSufficesIsKept) {
  EXPECT_TRUE(rc::check([] {
    joint::JointFacts f = any_joint();
    f.time_budget_s = somewhere(10, 10'000);
    const plan::ExperimentPlan plan = plan::plan_experiment(f);
    const plan::ExperimentPlan shortest = plan::plan_experiment(f, {0.25});
    if (shortest.duration_s() <= *f.time_budget_s) {
      RC_ASSERT(plan.duration_s() <= *f.time_budget_s);
    } else {
      RC_ASSERT(!plan.remarks.empty());
    }
  }));
}

}  // namespace
}  // namespace tribolog::plan_property_test
