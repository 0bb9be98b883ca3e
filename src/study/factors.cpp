#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/requirements.h"
#include "study/study.h"
#include "wording/language.h"
#include "wording/words.h"

namespace tribolog::study {
namespace {

// Realistic noise as shares of the gravity torque of the joint that it is stated for, 3.883 N·m.
constexpr double usual_noise_share = 0.02 / 3.883;
constexpr double usual_step_share = 0.005 / 3.883;
constexpr double usual_counts_per_turn = 131072;
constexpr std::size_t ripple_positions = 8;

double motor_gravity_Nm(const simulate::Scenario& s) {
  return s.load.amplitude_Nm() / s.gear_ratio;
}

/// Sets one number of a scenario.
using Setting = std::function<void(simulate::Scenario&, double)>;

/// Cases are told apart by their names: the same in every language.
std::string case_name(const StudyFactor& factor, const Statement& level) {
  const wording::WordsIn english({});
  return factor.key + ", " + wording::words(level);
}

/// How a factor's levels are made: `value = base value * multiple`.
struct Scale {
  double base_value;
  std::vector<double> multiples;  ///< 1 is the base case.
  Setting set;
  std::function<Statement(double)> text;
  double axis_factor;  ///< From SI to the axis' unit.
};

void add_levels(const simulate::Scenario& start, const std::string& start_name, const Scale& scale,
                StudyFactor& factor) {
  for (const double multiple : scale.multiples) {
    const double value = scale.base_value * multiple;
    StudyLevel level{value * scale.axis_factor, scale.text(value), multiple == 1, start_name,
                     start};
    if (!level.is_base) {
      scale.set(level.scenario, value);
      level.case_name = case_name(factor, level.text);
    }
    factor.levels.push_back(std::move(level));
  }
}

constexpr const char* whole_base = "base case";
constexpr const char* short_base = "base case, rough sweep and oscillation";

/// What a factor of the oscillation needs.
simulate::Scenario without_unneeded(const simulate::Scenario& base) {
  simulate::Scenario s = base;
  s.precise_sweep.reset();
  s.constant_speed.reset();
  return s;
}

Statement torque_level(double value_Nm) {
  return {"study_level.torque", {{"torque", 1e3 * value_Nm}}};
}

Statement count_level(double counts) {
  return {"study_level.counts", {{"counts", std::llrint(counts)}}};
}

Statement cycles_level(double cycles) {
  if (cycles != std::floor(cycles)) return {"study_level.broken_cycles", {{"cycles", cycles}}};
  return {"study_level.cycles", {{"cycles", std::llrint(cycles)}}};
}

StudyFactor noise_factor(const simulate::Scenario& base) {
  StudyFactor factor{"torque_noise", false, {}};
  add_levels(base, whole_base,
             {base.noise.torque_white_Nm,
              {0, 0.5, 1, 2, 4, 8},
              [](simulate::Scenario& s, double v) { s.noise.torque_white_Nm = v; },
              torque_level,
              1e3},
             factor);
  return factor;
}

StudyFactor step_factor(const simulate::Scenario& base) {
  StudyFactor factor{"torque_step", false, {}};
  add_levels(base, whole_base,
             {base.noise.torque_step_Nm,
              {0, 1, 4, 16, 40},
              [](simulate::Scenario& s, double v) { s.noise.torque_step_Nm = v; },
              torque_level,
              1e3},
             factor);
  return factor;
}

StudyFactor encoder_factor(const simulate::Scenario& base) {
  StudyFactor factor{"encoder", false, {}};
  add_levels(base, whole_base,
             {base.noise.encoder_counts_per_turn,
              {1.0 / 16, 1.0 / 8, 1.0 / 4, 1, 4},
              [](simulate::Scenario& s, double v) { s.noise.encoder_counts_per_turn = v; },
              count_level,
              1},
             factor);
  for (StudyLevel& level : factor.levels) level.value = std::log2(level.value);
  return factor;
}

/// Ripple at 1 and at 6 periods a motor turn, of the same amplitude.
void set_ripple(simulate::Scenario& s, double amplitude_Nm) {
  s.noise.ripple.clear();
  if (amplitude_Nm > 0) s.noise.ripple = {{amplitude_Nm, 1, 0}, {amplitude_Nm, 6, 0}};
}

StudyFactor ripple_factor(const simulate::Scenario& base, std::size_t positions) {
  const bool is_one = positions == 1;
  StudyFactor factor{is_one ? "ripple_one_position" : "ripple_eight_positions", false, {}};
  simulate::Scenario start = without_unneeded(base);
  start.further_oscillations.clear();
  if (!is_one) {
    const auto all =
        simulate::spread_over_motor_turn(present(base.oscillation), positions, base.gear_ratio);
    start.further_oscillations.assign(all.begin() + 1, all.end());
  }
  const Scale scale{usual_noise_share * motor_gravity_Nm(base),
                    {0, 0.25, 0.5, 1, 2.5},
                    set_ripple,
                    torque_level,
                    1e3};
  for (const double multiple : scale.multiples) {
    const double value = scale.base_value * multiple;
    StudyLevel level{value * scale.axis_factor, scale.text(value), multiple == 0, {}, start};
    level.case_name = case_name(factor, level.text);
    set_ripple(level.scenario, value);
    factor.levels.push_back(std::move(level));
  }
  const bool is_base_case =
      is_one && base.noise.ripple.empty() && base.further_oscillations.empty();
  if (is_base_case) factor.levels.front().case_name = short_base;
  return factor;
}

/// Sets one number of every oscillation.
Setting for_each_oscillation(double simulate::OscillationExperiment::* number) {
  return [number](simulate::Scenario& s, double value) {
    (*s.oscillation).*number = value;
    for (simulate::OscillationExperiment& e : s.further_oscillations) e.*number = value;
  };
}

StudyFactor amplitude_factor(const simulate::Scenario& base) {
  StudyFactor factor{"amplitude", true, {}};
  add_levels(without_unneeded(base), short_base,
             {present(base.oscillation).amplitude_rad,
              {0.1, 0.3, 1, 3, 10},
              for_each_oscillation(&simulate::OscillationExperiment::amplitude_rad),
              [](double v) { return Statement{"study_level.amplitude", {{"amplitude", 1e6 * v}}}; },
              1e6},
             factor);
  return factor;
}

StudyFactor cycles_factor(const simulate::Scenario& base) {
  StudyFactor factor{"cycles", true, {}};
  // Two cycles are the fewest that leave one behind the start-up stroke.
  const double stated = present(base.oscillation).cycles;
  std::vector<double> multiples{1};
  for (const double cycles : {2.0, 3.0, 5.0, 10.0, 20.0}) {
    if (cycles != stated) multiples.push_back(cycles / stated);
  }
  std::sort(multiples.begin(), multiples.end());
  add_levels(without_unneeded(base), short_base,
             {stated, multiples, for_each_oscillation(&simulate::OscillationExperiment::cycles),
              cycles_level, 1},
             factor);
  return factor;
}

}  // namespace

simulate::Scenario study_base(const simulate::Scenario& scenario) {
  simulate::Scenario base = scenario;
  const double gravity = motor_gravity_Nm(scenario);
  if (!(base.noise.torque_white_Nm > 0)) base.noise.torque_white_Nm = usual_noise_share * gravity;
  if (!(base.noise.torque_step_Nm > 0)) base.noise.torque_step_Nm = usual_step_share * gravity;
  if (!(base.noise.encoder_counts_per_turn > 0)) {
    base.noise.encoder_counts_per_turn = usual_counts_per_turn;
  }
  base.break_away.reset();
  if (base.oscillation) base.oscillation->record_bristle = false;
  for (simulate::OscillationExperiment& e : base.further_oscillations) e.record_bristle = false;
  return base;
}

std::vector<StudyFactor> study_factors(const simulate::Scenario& base) {
  std::vector<StudyFactor> factors{noise_factor(base), step_factor(base), encoder_factor(base)};
  if (base.oscillation) {
    factors.push_back(ripple_factor(base, 1));
    factors.push_back(ripple_factor(base, ripple_positions));
    factors.push_back(amplitude_factor(base));
    factors.push_back(cycles_factor(base));
  }
  return factors;
}

}  // namespace tribolog::study
