#include "study/study.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/parallel_for.h"
#include "friction/lugre.h"
#include "friction/static_laws.h"
#include "identify/identify.h"
#include "simulate/simulate_joint.h"
#include "statistics/random_stream.h"

namespace tribolog::study {
namespace {

calibration::Calibration identify_quietly(const joint::Dataset& dataset, std::uint64_t seed) {
  identify::IdentifyOptions options;
  options.seed = seed;
  options.threads = 1;  // the runs themselves are spread over the cores
  options.truth_runs = 0;
  return identify::identify(dataset, options);
}

StudiedCase run_case(const std::string& name, const simulate::Scenario& scenario,
                     const std::vector<truth::Reading>& truths, const StudyOptions& options) {
  const std::vector<simulate::IdealRecording> ideal = simulate::simulate_ideal_joint(scenario);
  std::vector<std::vector<truth::Reading>> found(options.runs);
  parallel_for(
      options.runs,
      [&](std::size_t run) {
        const simulate::Noise noise = noise_of_run(scenario.noise, options.seed, run);
        const joint::Dataset dataset = simulate::simulated_dataset(
            scenario, simulate::with_noise(ideal, noise, scenario.gear_ratio));
        found[run] = truth::readings_of(identify_quietly(dataset, noise.seed));
      },
      options.threads);
  StudiedCase out{name, {}};
  for (const truth::Reading& truth : truths) {
    std::vector<statistics::Estimate> estimates;
    for (const std::vector<truth::Reading>& readings : found) {
      if (const truth::Reading* r = truth::find_reading(readings, truth.name))
        estimates.push_back(r->estimate);
    }
    if (estimates.empty()) continue;
    out.readings.push_back({truth.name, truth.quantity,
                            error_statistics(estimates, truth.estimate.value, options.runs)});
  }
  return out;
}

/// The scenario's own number for a reading, or nullopt where it states none.
std::optional<double> stated_truth(const simulate::Scenario& s, const truth::Reading& reading) {
  if (reading.quantity == truth::ReadingKind::gravity) return s.load.amplitude_Nm() / s.gear_ratio;
  if (reading.quantity == truth::ReadingKind::peak_angle) return s.load.q_peak_rad();
  if (const auto* lugre = dynamic_cast<const friction::LuGreFriction*>(s.presliding.get())) {
    if (reading.quantity == truth::ReadingKind::stiffness) {
      return lugre->parameters().bristle_stiffness_Nm_rad;
    }
    if (reading.quantity == truth::ReadingKind::static_torque) return lugre->parameters().static_Nm;
  }
  if (const auto* curve = dynamic_cast<const friction::WaiboerFriction*>(s.sliding.get())) {
    const friction::WaiboerFriction::Parameters& p = curve->parameters();
    switch (reading.quantity) {
      case truth::ReadingKind::asperity_torque:
        return p.asperity_torque_Nm;
      case truth::ReadingKind::stribeck_speed:
        return p.stribeck_speed_rad_s;
      case truth::ReadingKind::stribeck_power:
        return p.stribeck_power;
      case truth::ReadingKind::viscous_factor:
        return p.viscous_coefficient;
      case truth::ReadingKind::viscous_power:
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

const StudiedReading* StudiedCase::find(truth::ReadingName reading) const {
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

simulate::Noise noise_of_run(const simulate::Noise& stated, std::uint64_t seed, std::size_t run) {
  statistics::RandomStream random(seed, run);
  simulate::Noise noise = stated;
  constexpr double whole_numbers = 0x1p53;
  noise.seed = static_cast<std::uint64_t>(random.uniform() * whole_numbers);
  for (simulate::Noise::Ripple& ripple : noise.ripple) {
    ripple.phase_rad = 2 * std::numbers::pi * random.uniform();
  }
  noise.encoder_phase = random.uniform();
  return noise;
}

std::vector<truth::Reading> true_readings(const simulate::Scenario& scenario) {
  simulate::Scenario ideal = scenario;
  ideal.noise = {};
  return true_readings(scenario, simulate::simulated_dataset(ideal));
}

std::vector<truth::Reading> true_readings(const simulate::Scenario& scenario,
                                          const joint::Dataset& ideal) {
  std::vector<truth::Reading> truths =
      truth::readings_of(identify_quietly(ideal, simulate::Noise{}.seed));
  if (dynamic_cast<const friction::WaiboerFriction*>(scenario.sliding.get()) != nullptr) {
    std::erase_if(truths, [](const truth::Reading& one) {  // eq. (6) has neither
      return one.quantity == truth::ReadingKind::coulomb ||
             one.quantity == truth::ReadingKind::viscous;
    });
  }
  for (truth::Reading& truth : truths) {
    const double value = stated_truth(scenario, truth).value_or(truth.estimate.value);
    truth.estimate = {value, value, value, {"interval.known"}};
  }
  return truths;
}

StudyResult run_study(const simulate::Scenario& scenario, const StudyOptions& options,
                      const StudyProgress& progress) {
  if (options.runs < 2) {
    throw std::invalid_argument(
        fmt::format("{} runs are not allowed; a study needs at least 2", options.runs));
  }
  StudyResult out;
  out.options = options;
  out.base = study_base(scenario);
  out.factors = chosen(study_factors(out.base), options.factors);
  const std::vector<truth::Reading> truths = true_readings(out.base);
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

}  // namespace tribolog::study
