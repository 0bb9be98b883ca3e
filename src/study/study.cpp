#include "study/study.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/parallel_for.h"
#include "friction/lugre.h"
#include "friction/waiboer.h"
#include "identify/identify.h"
#include "simulate/simulate_joint.h"
#include "statistics/random_stream.h"

namespace tribolog {
namespace {

Calibration identify_quietly(const Dataset& dataset, std::size_t resamples, std::uint64_t seed) {
  tribolog::IdentifyOptions options;
  options.resamples = resamples;
  options.seed = seed;
  options.threads = 1;  // the runs themselves are spread over the cores
  options.truth_runs = 0;
  return identify(dataset, options);
}

StudiedCase run_case(const std::string& name, const Scenario& scenario,
                     const std::vector<Reading>& truths, const StudyOptions& options) {
  const std::vector<IdealRecording> ideal = simulate_ideal_joint(scenario);
  std::vector<std::vector<Reading>> found(options.runs);
  parallel_for(
      options.runs,
      [&](std::size_t run) {
        const Noise noise = noise_of_run(scenario.noise, options.seed, run);
        const Dataset dataset =
            simulated_dataset(scenario, with_noise(ideal, noise, scenario.gear_ratio));
        found[run] = readings_of(identify_quietly(dataset, options.resamples, noise.seed));
      },
      options.threads);
  StudiedCase out{name, {}};
  for (const Reading& truth : truths) {
    std::vector<Estimate> estimates;
    for (const std::vector<Reading>& readings : found) {
      if (const Reading* r = find_reading(readings, truth.name)) estimates.push_back(r->estimate);
    }
    if (estimates.empty()) continue;
    out.readings.push_back({truth.name, truth.quantity,
                            error_statistics(estimates, truth.estimate.value, options.runs)});
  }
  return out;
}

/// The scenario's own number for a reading, or nullopt where it states none.
std::optional<double> stated_truth(const Scenario& s, const Reading& reading) {
  if (reading.quantity == ReadingKind::gravity) return s.load.amplitude_Nm() / s.gear_ratio;
  if (reading.quantity == ReadingKind::peak_angle) return s.load.q_peak_rad();
  if (const auto* lugre = dynamic_cast<const LuGreFriction*>(s.presliding.get())) {
    if (reading.quantity == ReadingKind::stiffness) {
      return lugre->parameters().bristle_stiffness_Nm_rad;
    }
    if (reading.quantity == ReadingKind::static_torque) return lugre->parameters().static_Nm;
  }
  if (const auto* curve = dynamic_cast<const WaiboerFriction*>(s.sliding.get())) {
    const WaiboerFriction::Parameters& p = curve->parameters();
    switch (reading.quantity) {
      case ReadingKind::asperity_torque:
        return p.asperity_torque_Nm;
      case ReadingKind::stribeck_speed:
        return p.stribeck_speed_rad_s;
      case ReadingKind::stribeck_power:
        return p.stribeck_power;
      case ReadingKind::viscous_factor:
        return p.viscous_coefficient;
      case ReadingKind::viscous_power:
        return p.viscous_power;
      default:
        break;
    }
  }
  return std::nullopt;
}

/// Those of all factors that are asked for, in their own order.
std::vector<StudyFactor> chosen(std::vector<StudyFactor> all,
                                const std::vector<std::string>& keys) {
  if (keys.empty()) return all;
  std::vector<std::string> known;
  for (const StudyFactor& factor : all) known.push_back(factor.key);
  for (const std::string& key : keys) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    throw std::invalid_argument(
        fmt::format("factor '{}' is not one of this scenario's: {}", key, fmt::join(known, ", ")));
  }
  std::erase_if(all, [&](const StudyFactor& factor) {
    return std::find(keys.begin(), keys.end(), factor.key) == keys.end();
  });
  return all;
}

}  // namespace

const StudiedReading* StudiedCase::find(const std::string& reading) const {
  const auto it = std::find_if(readings.begin(), readings.end(),
                               [&](const StudiedReading& r) { return r.name == reading; });
  return it == readings.end() ? nullptr : &*it;
}

const StudiedCase& StudyResult::case_of(const StudyLevel& level) const {
  const auto it = std::find_if(cases.begin(), cases.end(),
                               [&](const StudiedCase& c) { return c.name == level.case_name; });
  if (it == cases.end()) throw std::out_of_range("no case '" + level.case_name + "'");
  return *it;
}

const StudiedCase& StudyResult::base_case() const { return cases.front(); }

Noise noise_of_run(const Noise& stated, std::uint64_t seed, std::size_t run) {
  RandomStream random(seed, run);
  Noise noise = stated;
  constexpr double whole_numbers = 0x1p53;
  noise.seed = static_cast<std::uint64_t>(random.uniform() * whole_numbers);
  for (Noise::Ripple& ripple : noise.ripple) {
    ripple.phase_rad = 2 * std::numbers::pi * random.uniform();
  }
  return noise;
}

std::vector<Reading> true_readings(const Scenario& scenario) {
  Scenario ideal = scenario;
  ideal.noise = {};
  return true_readings(scenario, simulated_dataset(ideal));
}

std::vector<Reading> true_readings(const Scenario& scenario, const Dataset& ideal) {
  std::vector<Reading> truths = readings_of(identify_quietly(ideal, 0, Noise{}.seed));
  for (Reading& truth : truths) {
    const double value = stated_truth(scenario, truth).value_or(truth.estimate.value);
    truth.estimate = {value, value, value, "known"};
  }
  return truths;
}

StudyResult run_study(const Scenario& scenario, const StudyOptions& options,
                      const StudyProgress& progress) {
  if (options.runs < 2) {
    throw std::invalid_argument(
        fmt::format("{} runs are not allowed; a study needs at least 2", options.runs));
  }
  StudyResult out;
  out.options = options;
  out.base = study_base(scenario);
  out.factors = chosen(study_factors(out.base), options.factors);
  const std::vector<Reading> truths = true_readings(out.base);
  std::vector<const StudyLevel*> cases;
  for (const StudyFactor& factor : out.factors) {
    for (const StudyLevel& level : factor.levels) {
      const bool is_new = std::none_of(cases.begin(), cases.end(), [&](const StudyLevel* other) {
        return other->case_name == level.case_name;
      });
      if (is_new) cases.push_back(&level);
    }
  }
  // The whole base case first: every summary begins with it.
  std::stable_partition(cases.begin(), cases.end(),
                        [](const StudyLevel* level) { return level->is_base; });
  for (const StudyLevel* level : cases) {
    if (progress) progress(level->case_name, out.cases.size(), cases.size());
    out.cases.push_back(run_case(level->case_name, level->scenario, truths, options));
  }
  if (progress) progress("done", cases.size(), cases.size());
  return out;
}

}  // namespace tribolog
