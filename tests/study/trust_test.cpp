// Limits of trust over hand-made studies.

#include "study/trust.h"

#include <utility>

#include <gtest/gtest.h>

#include "wording/words.h"

namespace tribolog::trust_test {
namespace {

using calibration::ReadingName;

constexpr double truth = 4.0;

/// An estimator of gravity whose every run is off by so much, +- a little.
study::StudiedReading reading(ReadingName name, double off, double half_width) {
  std::vector<statistics::Estimate> estimates;
  for (int i = 0; i < 100; ++i) {
    const double little = (i % 2 == 0 ? 1 : -1) * 1e-5;
    estimates.push_back(statistics::symmetric_estimate(truth + off + little, half_width));
  }
  return {name, truth::ReadingKind::gravity, study::error_statistics(estimates, truth, 100)};
}

/// One factor of five levels, the third is the base case; the mid-line is off by these.
study::StudyResult study_of(const std::vector<double>& midline_off, double half_width = 1) {
  study::StudyResult study;
  study::StudyFactor factor{"torque_noise", false, {}};
  for (std::size_t i = 0; i < midline_off.size(); ++i) {
    const std::string name = "case " + std::to_string(i);
    factor.levels.push_back({static_cast<double>(i),
                             Statement::verbatim(std::to_string(i) + " mN·m"),
                             i == 2,
                             name,
                             {}});
    study.cases.push_back(
        {name,
         {reading(ReadingName::A, 0.02, 0.005), reading(ReadingName::B, -0.02, 0.005),
          reading(ReadingName::midline, midline_off[i], half_width)}});
  }
  std::swap(study.cases[0], study.cases[2]);
  study.factors.push_back(factor);
  return study;
}

TEST(Trust, ReachesToTheFirstLevelThatBreaksIt) {
  const study::StudyResult study = study_of({0.1, 0.001, 0.001, 0.001, 0.006});
  const study::TrustedRange fine =
      study::trusted_range(study, study.factors[0], ReadingName::midline, study::Criterion::fine);
  EXPECT_TRUE(fine.at_base);
  EXPECT_EQ(fine.lowest, 1U);
  EXPECT_EQ(fine.highest, 3U);
  EXPECT_FALSE(fine.all_levels);
  // 0.006 of 4 is 0.15 %.
  const study::TrustedRange coarse =
      study::trusted_range(study, study.factors[0], ReadingName::midline, study::Criterion::coarse);
  EXPECT_EQ(coarse.lowest, 1U);
  EXPECT_EQ(coarse.highest, 4U);
}

TEST(Trust, ALevelBeyondABrokenOneDoesNotCount) {
  const study::StudyResult study = study_of({0.001, 0.1, 0.001, 0.1, 0.001});
  const study::TrustedRange range =
      study::trusted_range(study, study.factors[0], ReadingName::midline, study::Criterion::fine);
  EXPECT_EQ(range.lowest, 2U);
  EXPECT_EQ(range.highest, 2U);
}

TEST(Trust, IsNoneWhereTheBaseCaseBreaksIt) {
  const study::StudyResult study = study_of({0, 0, 0, 0, 0});
  EXPECT_FALSE(
      study::trusted_range(study, study.factors[0], ReadingName::B, study::Criterion::coarse)
          .at_base);
  EXPECT_TRUE(
      study::trusted_range(study, study.factors[0], ReadingName::midline, study::Criterion::fine)
          .all_levels);
}

TEST(Trust, IntervalsThatDoNotHoldTheTruthAreNarrow) {
  const study::StudyResult narrow = study_of({0.001, 0.001, 0.001, 0.001, 0.001}, 0.0005);
  EXPECT_FALSE(study::holds(narrow.base_case(), ReadingName::midline, study::Criterion::coverage));
  EXPECT_TRUE(study::holds(narrow.base_case(), ReadingName::midline, study::Criterion::fine));
  const study::StudyResult wide = study_of({0.001, 0.001, 0.001, 0.001, 0.001}, 0.002);
  EXPECT_TRUE(study::holds(wide.base_case(), ReadingName::midline, study::Criterion::coverage));
}

TEST(Trust, WhatIsNotFoundIsNotTrusted) {
  study::StudyResult study = study_of({0, 0, 0, 0, 0});
  study.cases[1].readings[2].errors.found = 90;  // of 100
  EXPECT_FALSE(study::holds(study.cases[1], ReadingName::midline, study::Criterion::coarse));
  EXPECT_FALSE(study::holds(study.cases[1], ReadingName::fit, study::Criterion::coarse));
}

TEST(Trust, FindingsSayWhoIsBiasedAndWhereItEnds) {
  const study::StudyResult study = study_of({0.001, 0.001, 0.001, 0.1, 0.1});
  const std::vector<std::string> findings = wording::words(study::study_findings(study));
  ASSERT_FALSE(findings.empty());
  EXPECT_NE(findings[0].find("point B biased by −0.500"), std::string::npos) << findings[0];
  EXPECT_EQ(findings[0].find("mid-line"), std::string::npos) << findings[0];
  EXPECT_NE(findings[1].find("mid-line free of relevant bias"), std::string::npos) << findings[1];
  bool told = false;
  for (const std::string& finding : findings) {
    told |= finding == "Mid-line first exceeds 0.1 % at white torque noise 3 mN·m.";
  }
  EXPECT_TRUE(told);
}

TEST(Trust, TheSentenceNamesPointBWhereItWasRead) {
  study::StudyResult study = study_of({0.001, 0.001, 0.001, 0.1, 0.1});
  EXPECT_EQ(wording::words(study::study_sentence(study)),
            "In the base case the mid-line is within 0.025 % of the true gravity torque in 95 of "
            "100 runs, and 100 % of its stated intervals contain the true value; point B is off by "
            "−0.50 %, the mid-line by +0.025 %.");
  study.cases[0].readings = {reading(ReadingName::model, 0.004, 1)};
  EXPECT_TRUE(study::study_sentence(study).is("study_sentence.model"));
  study.cases[0].readings.clear();
  EXPECT_TRUE(study::study_sentence(study).is("study.no_gravity"));
}

}  // namespace
}  // namespace tribolog::trust_test
