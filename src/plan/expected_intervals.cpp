#include "plan/expected_intervals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel_for.h"
#include "identify/identify.h"
#include "plan/simulated_plan.h"
#include "simulate/simulate_joint.h"
#include "statistics/order_statistics.h"
#include "study/study.h"

namespace tribolog::plan {

using truth::ReadingName;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// What a plan is made for, in the order of the table: the paper's single points are not.
constexpr std::array wanted{ReadingName::midline,
                            ReadingName::fit,
                            ReadingName::model,
                            ReadingName::q_peak,
                            ReadingName::bristle_stiffness,
                            ReadingName::static_torque,
                            ReadingName::break_away,
                            ReadingName::sweep_friction,
                            ReadingName::coulomb,
                            ReadingName::viscous,
                            ReadingName::asperity_torque,
                            ReadingName::stribeck_speed,
                            ReadingName::viscous_coefficient,
                            ReadingName::viscous_power};

calibration::Calibration identify_once(const joint::Dataset& dataset, std::uint64_t seed) {
  identify::IdentifyOptions options;
  options.seed = seed;
  options.threads = 1;  // the runs themselves are spread over the cores
  return identify::identify(dataset, options);
}

std::vector<truth::Reading> readings_with_ramps(const calibration::Calibration& c) {
  std::vector<truth::Reading> all = truth::readings_of(c);
  if (c.break_away.mean_Nm) {
    all.push_back(
        {ReadingName::break_away, truth::ReadingKind::static_torque, *c.break_away.mean_Nm});
  }
  return all;
}

/// Truths of the joint; that of the ramps, whose moment of break-away is a matter of definition, is
/// what they give without noise.
std::vector<truth::Reading> truths_of(const simulate::Scenario& joint,
                                      const std::vector<simulate::IdealRecording>& ideal) {
  const joint::Dataset dataset =
      simulate::simulated_dataset(joint, simulate::with_noise(ideal, {}, joint.gear_ratio));
  std::vector<truth::Reading> truths = study::true_readings(joint, dataset);
  const std::vector<truth::Reading> found = readings_with_ramps(identify_once(dataset, 1));
  if (const truth::Reading* ramps = truth::find_reading(found, ReadingName::break_away))
    truths.push_back(*ramps);
  return truths;
}

ExpectedInterval expected(ReadingName name, const truth::Reading& truth,
                          const std::vector<std::vector<truth::Reading>>& runs) {
  std::vector<statistics::Estimate> estimates;
  std::vector<double> half_widths;
  for (const std::vector<truth::Reading>& readings : runs) {
    if (const truth::Reading* r = truth::find_reading(readings, name)) {
      estimates.push_back(r->estimate);
      half_widths.push_back(r->estimate.half_width());
    }
  }
  const study::ErrorStatistics errors =
      study::error_statistics(estimates, truth.estimate.value, runs.size());
  ExpectedInterval e;
  e.name = name;
  e.quantity = truth.quantity;
  e.truth = truth.estimate.value;
  e.runs = runs.size();
  e.found = estimates.size();
  e.inside = static_cast<std::size_t>(std::count_if(
      estimates.begin(), estimates.end(),
      [&](const statistics::Estimate& one) { return one.low <= e.truth && e.truth <= one.high; }));
  e.half_width = estimates.empty() ? nan : statistics::median(half_widths);
  e.scatter = errors.scatter;
  return e;
}

}  // namespace

const ExpectedInterval* ExpectedIntervals::find(ReadingName name) const {
  const auto it = std::find_if(quantities.begin(), quantities.end(),
                               [&](const ExpectedInterval& e) { return e.name == name; });
  return it == quantities.end() ? nullptr : &*it;
}

ExpectedIntervals expect_intervals(const ExperimentPlan& plan, const ExpectationOptions& options) {
  ExpectedIntervals out;
  out.runs = options.runs;
  out.seed = options.seed;
  if (plan.segments.empty() || options.runs == 0) return out;
  const simulate::Scenario joint = assumed_scenario(plan.joint);
  const double rate = plan.joint.sample_rate_Hz;
  const std::vector<simulate::IdealRecording> ideal =
      cut_by_plan(plan, simulate_plan(plan, joint, rate), rate);
  const std::vector<truth::Reading> truths = truths_of(joint, ideal);
  std::vector<std::vector<truth::Reading>> runs(options.runs);
  parallel_for(
      options.runs,
      [&](std::size_t run) {
        const simulate::Noise noise = study::noise_of_run(joint.noise, options.seed, run);
        const joint::Dataset dataset = simulate::simulated_dataset(
            joint, simulate::with_noise(ideal, noise, joint.gear_ratio));
        runs[run] = readings_with_ramps(identify_once(dataset, noise.seed));
      },
      options.threads);
  for (const ReadingName name : wanted) {
    if (const truth::Reading* truth = truth::find_reading(truths, name)) {
      out.quantities.push_back(expected(name, *truth, runs));
    }
  }
  return out;
}

}  // namespace tribolog::plan
