// A small study of the paper's joint: the biases that its friction has by construction.

#include "study/study.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "simulate/simulate_joint.h"
#include "study/small_scenario.h"
#include "support/breadth.h"
#include "support/paper_joint.h"
#include "wording/words.h"

namespace tribolog::study_test {
namespace {

using calibration::ReadingName;

study::StudyResult studied(const std::vector<std::string>& factors, std::size_t runs) {
  study::StudyOptions options;
  options.runs = runs;
  options.factors = factors;
  return study::run_study(test::small_scenario(), options);
}

const study::StudyFactor& factor(const study::StudyResult& study, const std::string& key) {
  const auto it = std::find_if(study.factors.begin(), study.factors.end(),
                               [&](const study::StudyFactor& f) { return f.key == key; });
  EXPECT_NE(it, study.factors.end()) << key;
  return *it;
}

TEST(Study, PointsAreBiasedAndAveragesAreNot) {
  constexpr std::size_t runs = 24;
  constexpr double truth = test::true_gravity_Nm;
  constexpr double matters = 1e-3 * truth;
  const study::StudyResult study = studied({"torque_noise"}, runs);
  const auto errors = [&](ReadingName reading) -> const study::ErrorStatistics& {
    return study.base_case().find(reading)->errors;
  };
  EXPECT_TRUE(errors(ReadingName::A).is_biased(matters));
  EXPECT_GT(errors(ReadingName::A).bias, 0);
  EXPECT_TRUE(errors(ReadingName::B).is_biased(matters));
  EXPECT_LT(errors(ReadingName::B).bias, 0);
  // Table 2 of the paper: C 97 kg and D 61 kg about 79.17.
  EXPECT_NEAR(errors(ReadingName::C).bias / truth, 97.023 / 79.1679 - 1, 0.01);
  EXPECT_NEAR(errors(ReadingName::D).bias / truth, 61.009 / 79.1679 - 1, 0.01);
  // In the steady loop A and B lie symmetrically.
  const study::ErrorStatistics& a = errors(ReadingName::A_steady);
  const study::ErrorStatistics& b = errors(ReadingName::B_steady);
  EXPECT_TRUE(a.is_biased(matters));
  EXPECT_TRUE(b.is_biased(matters));
  EXPECT_NEAR(a.bias + b.bias, 0, 4 * std::hypot(a.bias_standard_error, b.bias_standard_error));
  for (const ReadingName reading : {ReadingName::AB, ReadingName::CD, ReadingName::EF,
                                    ReadingName::midline, ReadingName::fit, ReadingName::model}) {
    EXPECT_FALSE(errors(reading).is_biased(matters)) << to_string(reading);
  }
  // The mid-line is less the offset that the sweep shows, and has the offset's noise.
  EXPECT_LT(errors(ReadingName::midline).scatter, errors(ReadingName::B).scatter);
  // An honest 95 % interval holds the truth in 18 of 24 runs or fewer once in 2,400 studies.
  for (const ReadingName reading : {ReadingName::midline, ReadingName::fit, ReadingName::model,
                                    ReadingName::bristle_stiffness, ReadingName::static_torque}) {
    EXPECT_GE(errors(reading).coverage.value, 19.0 / runs) << to_string(reading);
  }
  EXPECT_LT(errors(ReadingName::B).coverage.value, 0.5);
  double last = -1;
  for (const study::StudyLevel& level : factor(study, "torque_noise").levels) {
    const double scatter = study.case_of(level).find(ReadingName::model)->errors.scatter;
    EXPECT_GT(scatter, last) << wording::words(level.text);
    last = scatter;
  }
}

TEST(Study, RippleShiftsOnePositionAndAveragesOutOverEight) {
  TRIBOLOG_EACH_NIGHT();
  const std::size_t runs = test::seeds_of(4, 12);
  const double least = runs >= 12 ? 8.0 / 12 : 0.5;
  const study::StudyResult study = studied({"ripple_one_position", "ripple_eight_positions"}, runs);
  const study::StudyLevel& one = factor(study, "ripple_one_position").levels.back();
  const study::StudyLevel& eight = factor(study, "ripple_eight_positions").levels.back();
  const study::ErrorStatistics& from_one = study.case_of(one).find(ReadingName::midline)->errors;
  const study::ErrorStatistics& from_eight =
      study.case_of(eight).find(ReadingName::midline)->errors;
  // Two sines at random phases of amplitude a: their sum has the standard deviation a.
  const double amplitude_Nm = one.value * 1e-3;
  EXPECT_GT(from_one.scatter, amplitude_Nm / 2);
  EXPECT_LT(from_one.scatter, amplitude_Nm * 2);
  // What is left is the noise of the sweep's offset, which is taken off the mid-line.
  EXPECT_LT(from_eight.scatter, from_one.scatter / (runs >= 12 ? 5 : 3));
  EXPECT_GE(from_one.coverage.value, least);
  EXPECT_GE(from_eight.coverage.value, least);
  // What is read at the first position alone is widened by the ripple, however many there are.
  EXPECT_GE(study.case_of(eight).find(ReadingName::AB)->errors.coverage.value, least);
}

TEST(Study, EachFactorHasOneBaseLevelAndLevelsOfOneCaseAreOneScenario) {
  std::map<std::string, const study::StudyLevel*> cases;
  const std::vector<study::StudyFactor> factors =
      study::study_factors(study::study_base(test::noisy_paper_joint(1)));
  EXPECT_EQ(factors.size(), 7U);
  for (const study::StudyFactor& f : factors) {
    const auto bases = std::count_if(f.levels.begin(), f.levels.end(),
                                     [](const study::StudyLevel& level) { return level.is_base; });
    EXPECT_EQ(bases, 1) << f.key;
    for (const char* topic : {"factor", "factor_axis", "factor_note"}) {
      EXPECT_FALSE(wording::words_for(topic, f.key).empty()) << f.key;
    }
    for (std::size_t i = 0; i < f.levels.size(); ++i) {
      const study::StudyLevel& level = f.levels[i];
      if (i > 0) {
        EXPECT_GT(level.value, f.levels[i - 1].value) << f.key;
      }
      const auto [place, is_new] = cases.emplace(level.case_name, &level);
      if (is_new) continue;
      const simulate::Scenario& other = place->second->scenario;
      EXPECT_EQ(level.scenario.noise.torque_white_Nm, other.noise.torque_white_Nm);
      EXPECT_EQ(level.scenario.noise.ripple.size(), other.noise.ripple.size());
      EXPECT_EQ(level.scenario.oscillation->amplitude_rad, other.oscillation->amplitude_rad);
      EXPECT_EQ(level.scenario.oscillation->cycles, other.oscillation->cycles);
      EXPECT_EQ(level.scenario.further_oscillations.size(), other.further_oscillations.size());
      EXPECT_EQ(level.scenario.precise_sweep.has_value(), other.precise_sweep.has_value());
    }
  }
}

TEST(Study, CommonCasesAreRunOnce) {
  const study::StudyResult study = studied({"ripple_one_position", "cycles"}, 2);
  std::set<std::string> names;
  for (const study::StudiedCase& one : study.cases) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
  }
  // Five levels of ripple, five of cycles (the base is one of them), one base case in common.
  EXPECT_EQ(study.cases.size(), 9U);
}

TEST(Study, ASweepAloneHasTheFactorsOfASweep) {
  simulate::Scenario sweep = test::small_scenario();
  sweep.oscillation.reset();
  study::StudyOptions options;
  options.runs = 2;
  const study::StudyResult study = study::run_study(sweep, options);
  EXPECT_EQ(study.factors.size(), 3U);
  EXPECT_EQ(study.base_case().find(ReadingName::midline), nullptr);
  ASSERT_NE(study.base_case().find(ReadingName::model), nullptr);
}

TEST(Study, ThreadsChangeNoNumber) {
  const simulate::Scenario scenario = test::small_scenario();
  study::StudyOptions options;
  options.runs = 3;
  options.factors = {"cycles"};
  options.threads = 1;
  const study::StudyResult one = study::run_study(scenario, options);
  options.threads = 3;
  const study::StudyResult three = study::run_study(scenario, options);
  ASSERT_EQ(one.cases.size(), three.cases.size());
  for (std::size_t i = 0; i < one.cases.size(); ++i) {
    ASSERT_EQ(one.cases[i].readings.size(), three.cases[i].readings.size());
    for (std::size_t k = 0; k < one.cases[i].readings.size(); ++k) {
      const study::ErrorStatistics& a = one.cases[i].readings[k].errors;
      const study::ErrorStatistics& b = three.cases[i].readings[k].errors;
      EXPECT_EQ(a.bias, b.bias);
      EXPECT_EQ(a.half_width, b.half_width);
    }
  }
}

TEST(Study, AnotherSeedGivesOtherNumbers) {
  simulate::Scenario sweep = test::small_scenario();
  sweep.oscillation.reset();
  study::StudyOptions options;
  options.runs = 2;
  options.factors = {"torque_step"};
  const double first =
      study::run_study(sweep, options).base_case().find(ReadingName::model)->errors.bias;
  options.seed = 2;
  EXPECT_NE(first,
            study::run_study(sweep, options).base_case().find(ReadingName::model)->errors.bias);
}

TEST(Study, RefusesOneRunAndUnknownFactors) {
  study::StudyOptions options;
  options.runs = 1;
  EXPECT_THROW(study::run_study(test::small_scenario(), options), std::invalid_argument);
  options.runs = 2;
  options.factors = {"temperature"};
  try {
    study::run_study(test::small_scenario(), options);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& refused) {
    EXPECT_NE(std::string(refused.what()).find("ripple_one_position"), std::string::npos);
  }
}

TEST(Study, TruthIsTheScenarios) {
  const std::vector<truth::Reading> truths = study::true_readings(test::paper_joint());
  EXPECT_DOUBLE_EQ(truth::find_reading(truths, ReadingName::midline)->estimate.value,
                   test::true_gravity_Nm);
  EXPECT_DOUBLE_EQ(truth::find_reading(truths, ReadingName::q_peak)->estimate.value,
                   test::true_q_peak_rad());
  EXPECT_DOUBLE_EQ(truth::find_reading(truths, ReadingName::bristle_stiffness)->estimate.value,
                   465.42);
  EXPECT_DOUBLE_EQ(truth::find_reading(truths, ReadingName::stribeck_power)->estimate.value, 0.7);
  // Eq. (6), which the scenario's curve follows, has no Coulomb torque.
  EXPECT_EQ(truth::find_reading(truths, ReadingName::coulomb), nullptr);
}

TEST(SimulateJoint, NoiseInTwoStepsIsTheSameNoise) {
  const simulate::Scenario scenario = test::small_scenario();
  const std::vector<joint::Recording> whole = simulate::simulate_joint(scenario);
  const std::vector<joint::Recording> in_steps = simulate::with_noise(
      simulate::simulate_ideal_joint(scenario), scenario.noise, scenario.gear_ratio);
  ASSERT_EQ(whole.size(), in_steps.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(whole[i].torque_Nm, in_steps[i].torque_Nm);
    EXPECT_EQ(whole[i].q_rad, in_steps[i].q_rad);
    EXPECT_EQ(whole[i].dq_rad_s, in_steps[i].dq_rad_s);
  }
}

}  // namespace
}  // namespace tribolog::study_test
