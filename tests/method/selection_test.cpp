#include "method/selection/selection.h"

#include <cmath>

#include <gtest/gtest.h>

#include "wording/words.h"

namespace tribolog::selection_test {
namespace {

using method::hysteresis::Estimator;

/// A to F around a mid-line of 80 kg, B the nearest.
struct Candidates {
  method::hysteresis::SurrogateMassesResult masses;
  method::selection::QualityErrorsResult errors;

  void add(Estimator estimator, double mass_kg, double half_width_kg) {
    method::hysteresis::SurrogateMass mass;
    mass.estimator = estimator;
    mass.mass_kg = statistics::symmetric_estimate(mass_kg, half_width_kg);
    masses.masses.push_back(mass);
    errors.errors.push_back({estimator, {}, std::abs(mass_kg - 80.0)});
  }
  [[nodiscard]] method::selection::SelectionResult selected() const {
    return method::selection::select_estimator(masses, errors, {}, std::nullopt);
  }
};

Candidates candidates(double half_width_kg) {
  Candidates out;
  out.add(Estimator::A, 81.5, half_width_kg);
  out.add(Estimator::B, 79.2, half_width_kg);
  out.add(Estimator::C, 98.0, half_width_kg);
  out.add(Estimator::D, 62.0, half_width_kg);
  out.add(Estimator::E, 76.0, half_width_kg);
  out.add(Estimator::F, 84.0, half_width_kg);
  out.add(Estimator::midline, 80.0, 0.01);
  return out;
}

TEST(Selection, OfSharpReadingsThePaperHasOneChoice) {
  const method::selection::SelectionResult s = candidates(0.1).selected();
  EXPECT_EQ(s.paper_rule, Estimator::B);
  EXPECT_EQ(s.recommended, Estimator::midline);
  EXPECT_TRUE(s.paper_rule_rivals.empty());
  EXPECT_EQ(wording::words(s.why).find("could have chosen"), std::string::npos);
}

// B is 0.8 kg away and A 1.5 kg: they cannot be told apart once each may be 0.35 kg off.
TEST(Selection, NamesThoseThatNoiseCouldHaveMadeTheChoice) {
  EXPECT_TRUE(candidates(0.34).selected().paper_rule_rivals.empty());
  const method::selection::SelectionResult s = candidates(0.36).selected();
  EXPECT_EQ(s.paper_rule_rivals, std::vector{Estimator::A});
  EXPECT_NE(wording::words(s.why).find("could have chosen A instead of B"), std::string::npos);
  EXPECT_EQ(candidates(2.0).selected().paper_rule_rivals,
            (std::vector{Estimator::A, Estimator::E, Estimator::F}));
}

TEST(Selection, WithoutALoopTheSweepIsRecommendedAndThePaperHasNoChoice) {
  Candidates c;
  c.add(Estimator::sweep, 80.0, 0.1);
  const method::selection::SelectionResult s = c.selected();
  EXPECT_EQ(s.recommended, Estimator::sweep);
  EXPECT_FALSE(s.paper_rule);
  EXPECT_EQ(s.stage.state, statistics::StageState::partial);
}

}  // namespace
}  // namespace tribolog::selection_test
