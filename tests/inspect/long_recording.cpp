#include "inspect/long_recording.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include "simulate/motion.h"
#include "simulate/simulate_joint.h"
#include "statistics/random_stream.h"
#include "support/paper_joint.h"

namespace tribolog::test {

namespace {

/// The effort that is held behind an experiment: not that of one noisy sample.
double last_level(const std::vector<double>& effort) {
  constexpr std::ptrdiff_t samples = 25;
  return std::accumulate(effort.end() - samples, effort.end(), 0.0) / samples;
}

}  // namespace

LongRecording long_recording(const simulate::Scenario& scenario, std::size_t keep, double rest_s) {
  constexpr double transfer_s = 1.5;
  LongRecording out;
  const std::vector<joint::Recording> recordings = simulate::simulate_joint(scenario);
  const double step_s =
      static_cast<double>(keep) * (recordings.front().t_s[1] - recordings.front().t_s[0]);
  statistics::RandomStream noise(scenario.noise.seed, 1);
  inspect::motion::AngleTrace& trace = out.trace;
  const auto add = [&](double t, double q, double torque) {
    trace.t_s.push_back(t);
    trace.q_rad.push_back(q);
    trace.effort.push_back(torque);
  };
  const auto hold = [&](double seconds, double from_rad, double to_rad, double torque) {
    const auto n = static_cast<std::size_t>(seconds / step_s);
    for (std::size_t k = 1; k <= n; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(n);
      const double q =
          from_rad + (to_rad - from_rad) * (1 - std::cos(std::numbers::pi * share)) / 2;
      const double t = trace.t_s.empty() ? 0 : trace.t_s.back() + step_s;
      add(t, q, torque + scenario.noise.torque_white_Nm * noise.normal());
    }
  };
  for (const joint::Recording& r : recordings) {
    const double last_rad = trace.t_s.empty() ? r.q_rad.front() : trace.q_rad.back();
    const double last_Nm = trace.t_s.empty() ? r.torque_Nm.front() : last_level(trace.effort);
    hold(rest_s, last_rad, last_rad, last_Nm);
    hold(transfer_s, last_rad, r.q_rad.front(), last_Nm);
    hold(rest_s, r.q_rad.front(), r.q_rad.front(), r.torque_Nm.front());
    const double start_s = trace.t_s.back() + step_s;
    for (std::size_t i = 0; i < r.size(); i += keep) {
      add(start_s + r.t_s[i] - r.t_s.front(), r.q_rad[i], r.torque_Nm[i]);
    }
    const bool travels = r.role != joint::Role::oscillation && r.role != joint::Role::break_away;
    const double still_s = travels ? simulate::TravelMotion::Plan{}.rest_s : 0;
    out.truth.push_back({r.name, r.role, start_s + still_s, trace.t_s.back() - still_s});
  }
  hold(rest_s, trace.q_rad.back(), trace.q_rad.back(), last_level(trace.effort));
  return out;
}

simulate::Scenario everything(std::uint64_t seed) {
  simulate::Scenario scenario = noisy_paper_joint(seed);
  simulate::BreakAwayExperiment ramp;
  ramp.centre_rad = true_q_peak_rad();
  ramp.rate_Nm_s = 0.05;
  ramp.largest_torque_Nm = 1.2;
  ramp.largest_travel_rad = 0.02;
  ramp.repeats = 1;
  scenario.break_away = ramp;
  return scenario;
}

}  // namespace tribolog::test
