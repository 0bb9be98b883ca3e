// What a 95 % interval is worth: how often it holds the truth, over many seeds of the paper's joint
// with the noise of a real drive; and with ripple, from one position and from eight.

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "base/parallel_for.h"
#include "identify/identify.h"
#include "statistics/random_stream.h"
#include "support/breadth.h"
#include "support/paper_joint.h"

namespace tribolog::interval_coverage_test {
namespace {

using method::hysteresis::Estimator;

constexpr double largest_coverage = 1;

// Ripple makes each run long.
std::size_t seeds_of_ripple() { return test::seeds_of(6, 100); }

simulate::Scenario with_ripple(simulate::Scenario s, std::uint64_t seed) {
  statistics::RandomStream random(seed, 777);
  for (const double periods : {1.0, 6.0}) {
    s.noise.ripple.push_back({0.02, periods, 2 * std::numbers::pi * random.uniform()});
  }
  return s;
}

simulate::Scenario from_eight_positions(simulate::Scenario s) {
  const auto all = simulate::spread_over_motor_turn(*s.oscillation, 8, s.gear_ratio);
  s.oscillation = all.front();
  s.further_oscillations.assign(all.begin() + 1, all.end());
  return s;
}

std::map<std::string, double> known_truths() {
  // Points A to F: what a log without noise shows, with its bristle.
  const joint::Dataset clean = simulate::simulated_dataset(test::paper_joint());
  identify::IdentifyOptions closed_forms;
  const calibration::Calibration c = identify::identify(clean, closed_forms);
  std::map<std::string, double> truth;
  for (const method::hysteresis::SurrogateMass& m : c.masses.masses) {
    truth["mass_kg." + to_string(m.estimator)] = method::hysteresis::point_index(m.estimator)
                                                     ? m.mass_kg.value
                                                     : test::true_surrogate_mass_kg;
  }
  truth["q_peak_rad"] = truth["q_peak_rough_rad"] = test::true_q_peak_rad();
  truth["coulomb_of_sweep_Nm"] = c.rough.coulomb_Nm->value;
  const friction::LuGreFriction::Parameters contact = test::paper_contact().parameters();
  truth["lugre.bristle_stiffness_Nm_rad"] = contact.bristle_stiffness_Nm_rad;
  truth["lugre.bristle_damping_Nms_rad"] = contact.bristle_damping_Nms_rad;
  truth["lugre.static_Nm"] = contact.static_Nm;
  return truth;
}

/// By the names of known_truths().
std::map<std::string, statistics::Estimate> estimates_of(const calibration::Calibration& c) {
  std::map<std::string, statistics::Estimate> all;
  for (const method::hysteresis::SurrogateMass& m : c.masses.masses) {
    all["mass_kg." + to_string(m.estimator)] = m.mass_kg;
  }
  all["q_peak_rad"] = *c.q_peak_rad;
  all["q_peak_rough_rad"] = c.rough.q_peak_rad;
  all["coulomb_of_sweep_Nm"] = *c.rough.coulomb_Nm;
  for (const method::hysteresis::LuGreParameter& parameter : c.lugre->parameters) {
    if (parameter.estimate) all["lugre." + to_string(parameter.name)] = *parameter.estimate;
  }
  return all;
}

struct Coverage {
  std::size_t seeds{};
  std::map<std::string, double> share;  // of the stated intervals
  double largest_mass_error{};          // of the mid-line, share
};

Coverage coverage_of(std::size_t seeds,
                     const std::function<simulate::Scenario(std::uint64_t)>& scenario) {
  const std::map<std::string, double> truth = known_truths();
  Coverage out;
  out.seeds = seeds;
  std::mutex guard;
  parallel_for(seeds, [&](std::size_t k) {
    const joint::Dataset dataset = simulate::simulated_dataset(scenario(k + 1));
    identify::IdentifyOptions options;
    options.seed = k + 1;
    options.threads = 1;
    const calibration::Calibration c = identify::identify(dataset, options);
    const std::lock_guard lock(guard);
    for (const auto& [name, e] : estimates_of(c)) {
      const auto at = truth.find(name);
      if (at == truth.end()) continue;
      out.share[name] += e.low <= at->second && at->second <= e.high ? 1.0 : 0.0;
    }
    out.largest_mass_error = std::max(
        out.largest_mass_error,
        std::abs(c.masses.find(Estimator::midline)->mass_kg.value / test::true_surrogate_mass_kg -
                 1));
  });
  for (auto& [name, share] : out.share) share /= static_cast<double>(seeds);
  return out;
}

void expect_coverage(const Coverage& coverage) {
  for (const auto& [name, share] : coverage.share) {
    testing::Test::RecordProperty(name, std::to_string(share));
    EXPECT_GE(share, test::least_coverage(coverage.seeds)) << name;
    EXPECT_LE(share, largest_coverage) << name;
  }
}

TEST(IntervalCoverage, OfEveryStatedIntervalInRealisticNoise) {
  const Coverage c = coverage_of(test::seeds_of(20, 100), test::noisy_paper_joint);
  EXPECT_GE(c.share.size(), 18U);
  expect_coverage(c);
  EXPECT_LT(c.largest_mass_error, 1e-3);
}

TEST(IntervalCoverage, WithRippleFromOnePositionIsAsWideAsTheRippleDemands) {
  TRIBOLOG_EACH_NIGHT();
  const Coverage c = coverage_of(seeds_of_ripple(), [](std::uint64_t seed) {
    return with_ripple(test::noisy_paper_joint(seed), seed);
  });
  expect_coverage(c);
  // Two lines of 0.02 N·m can add up to 1 %.
  EXPECT_GT(c.largest_mass_error, 3e-3);
  EXPECT_LT(c.largest_mass_error, 1.1e-2);
}

TEST(IntervalCoverage, WithRippleFromEightPositions) {
  const Coverage c = coverage_of(seeds_of_ripple(), [](std::uint64_t seed) {
    return from_eight_positions(with_ripple(test::noisy_paper_joint(seed), seed));
  });
  expect_coverage(c);
  EXPECT_LT(c.largest_mass_error, 3e-3);
}

TEST(PositionPlan, SaysThePeriodsAndSevenFurtherAnglesOverOneTurn) {
  const simulate::Scenario s = with_ripple(test::noisy_paper_joint(3), 3);
  identify::IdentifyOptions closed_forms;
  const joint::Dataset one = simulate::simulated_dataset(s);
  const calibration::Calibration c = identify::identify(one, closed_forms);
  ASSERT_EQ(c.rough.ripple.lines.size(), 2U);
  ASSERT_TRUE(c.position_plan);
  EXPECT_EQ(c.position_plan->further_rad.size(), 7U);
  EXPECT_NEAR(c.position_plan->spread_motor_rad, 2 * std::numbers::pi, 1e-12);
  std::string why;
  for (const Statement& finding : c.judgement.findings) {
    const std::string words = wording::words(finding);
    if (words.find("further angles") != std::string::npos) why = words;
  }
  for (const char* piece : {" at 1 ", " at 6 ", "periods per motor turn", "7 further angles"}) {
    EXPECT_NE(why.find(piece), std::string::npos) << piece << " in\n" << why;
  }
  // The positions planned are those that the scenario would take, and they bring what was promised.
  const simulate::Scenario eight = from_eight_positions(s);
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_NEAR(c.position_plan->further_rad[k], eight.further_oscillations[k].centre_rad, 1e-5);
  }
  const joint::Dataset all = simulate::simulated_dataset(eight);
  const calibration::Calibration after = identify::identify(all, closed_forms);
  EXPECT_FALSE(after.position_plan);
  const double promised = c.position_plan->expected_half_width_Nm;
  const double brought = after.hysteresis.midline_Nm->half_width();  // of the loops alone
  // Three degrees of freedom: the promise counts white noise alone beside the ripple's lines.
  EXPECT_LT(brought, 5 * promised);
  EXPECT_GT(brought, promised / 5);
}

}  // namespace
}  // namespace tribolog::interval_coverage_test
