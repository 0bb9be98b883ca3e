#include "method/hysteresis/loop_widening.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "method/hysteresis/position_mean.h"

namespace tribolog::method::hysteresis {

namespace {

void widen(LuGreParameter& parameter, double by, Code why) {
  constexpr double noticeable = 1.01;
  if (!parameter.estimate) return;
  statistics::Estimate& e = *parameter.estimate;
  const double half_width = std::hypot(e.half_width(), by);
  if (!(half_width > noticeable * e.half_width())) return;
  e = statistics::symmetric_estimate(e.value, half_width, {why, {{"interval", e.method}}});
}

}  // namespace

void take_ripple_off_loop(const gravity::CogSweepResult& sweep, double gear_ratio,
                          joint::Recording& loop) {
  constexpr double noticeable = 0.002;
  if (!sweep.found || sweep.ripple.lines.empty() || loop.torque_Nm.size() != loop.size() ||
      loop.size() < 2) {
    return;
  }
  const auto [low, high] = std::minmax_element(loop.q_rad.begin(), loop.q_rad.end());
  if (*low < sweep.lowest_rad || *high > sweep.highest_rad) return;
  std::vector<double> ripple;
  ripple.reserve(loop.size());
  double mean = 0;
  for (const double q : loop.q_rad) {
    ripple.push_back(sweep.ripple.torque_Nm(gear_ratio * q));
    mean += ripple.back() / static_cast<double>(loop.size());
  }
  const auto [least, most] = std::minmax_element(ripple.begin(), ripple.end());
  const auto [lowest, highest] = std::minmax_element(loop.torque_Nm.begin(), loop.torque_Nm.end());
  if (*most - *least < noticeable * (*highest - *lowest)) return;
  for (std::size_t i = 0; i < loop.size(); ++i) loop.torque_Nm[i] -= ripple[i] - mean;
}

LuGreFit with_unknown_lag(LuGreFit fit, const LoopTiming& timing) {
  const auto stiffness = fit.shown(LuGreParameterName::bristle_stiffness);
  if (!stiffness) return fit;
  constexpr double of_a_filter = 0.5;
  const double least =
      stiffness->value * std::hypot(timing.half_width_s, of_a_filter * timing.lag_s);
  for (LuGreParameter& parameter : fit.parameters) {
    if (parameter.name != LuGreParameterName::bristle_damping || !parameter.estimate) continue;
    statistics::Estimate& damping = *parameter.estimate;
    if (damping.half_width() >= least) continue;
    damping = statistics::symmetric_estimate(
        damping.value, least, {"interval.widened_by_lag", {{"interval", damping.method}}});
  }
  return fit;
}

LuGreFit with_lag_as_filter(LuGreFit fit, double lag_s) {
  const auto level = fit.shown(LuGreParameterName::static_torque);
  const auto stiffness = fit.shown(LuGreParameterName::bristle_stiffness);
  if (!level || !stiffness || !(level->value > 0) || !(stiffness->value > 0)) return fit;
  const double omega = 2 * std::numbers::pi * fit.frequency_Hz;
  const double fastest = omega * fit.motor_amplitude_rad;
  const double per_slide = stiffness->value / level->value;
  // What a torque drives may turn round as fast as it moves; along a sine the speed rises from
  // zero.
  const bool is_driven = std::any_of(fit.loops.begin(), fit.loops.end(),
                                     [](const LuGreLoop& l) { return l.traced.has_value(); });
  const double share = is_driven ? std::pow(lag_s * fastest * per_slide, 2)
                                 : lag_s * lag_s * omega * fastest * per_slide / 2;
  for (LuGreParameter& parameter : fit.parameters) {
    if (parameter.name == LuGreParameterName::bristle_stiffness) {
      widen(parameter, 3 * share * stiffness->value, "interval.widened_by_filter");
    }
  }
  return fit;
}

statistics::Estimate at_the_runs(const statistics::Estimate& recorded,
                                 const statistics::Estimate& difference, Code method) {
  const double factor = 1 + difference.value;
  const double value = recorded.value / factor;
  return statistics::symmetric_estimate(
      value, std::hypot(recorded.half_width() / factor, value * difference.half_width() / factor),
      {method, {{"interval", recorded.method}}});
}

LuGreFit with_friction_of_runs(LuGreFit fit, const std::optional<statistics::Estimate>& friction,
                               const std::optional<statistics::Estimate>& gain) {
  for (LuGreParameter& parameter : fit.parameters) {
    if (!parameter.estimate) continue;
    switch (parameter.name) {
      case LuGreParameterName::static_torque:
      case LuGreParameterName::coulomb_torque:
        if (friction) parameter.estimate = at_the_runs(*parameter.estimate, *friction);
        break;
      case LuGreParameterName::bristle_stiffness:
      case LuGreParameterName::bristle_damping:
      case LuGreParameterName::inertia:
        if (gain) {
          parameter.estimate = at_the_runs(*parameter.estimate, *gain, "interval.at_the_gain");
        }
        break;
      default:
        break;
    }
  }
  return fit;
}

LuGreFit with_rival_contacts(LuGreFit fit) {
  const ContactRival* lugre = fit.contacts.find(ContactLaw::lugre);
  const ContactRival* rival = fit.contacts.find(ContactLaw::elasto_plastic);
  if (fit.contacts.winner || lugre == nullptr || rival == nullptr) return fit;
  for (LuGreParameter& parameter : fit.parameters) {
    if (parameter.name == LuGreParameterName::bristle_stiffness) {
      widen(parameter, std::abs(rival->stiffness_Nm_rad - lugre->stiffness_Nm_rad),
            "interval.widened_by_contacts");
    }
    if (parameter.name == LuGreParameterName::static_torque) {
      widen(parameter, std::abs(rival->static_Nm - lugre->static_Nm),
            "interval.widened_by_contacts");
    }
  }
  return fit;
}

LuGreFit with_ripple_of_loops(LuGreFit fit, const gravity::Ripple& ripple) {
  const double x = fit.motor_amplitude_rad;
  const double w = 2 * std::numbers::pi * fit.frequency_Hz;
  if (ripple.lines.empty() || !(x > 0)) return fit;
  std::vector<double> heights;
  for (const gravity::RippleLine& line : ripple.lines) {
    const double phase = std::min(line.periods_per_turn * x, std::numbers::pi / 2);
    heights.push_back(line.amplitude_Nm * std::sin(phase));
  }
  // What was taken off is known but for a part.
  constexpr double left = 0.3;
  const double height_Nm = left * gravity::random_phase_half_width(heights, 0);
  const auto by = [&](LuGreParameterName name) {
    switch (name) {
      case LuGreParameterName::static_torque:
      case LuGreParameterName::coulomb_torque:
        return height_Nm;
      case LuGreParameterName::bristle_stiffness:
        return height_Nm / x;
      case LuGreParameterName::inertia:
        return w > 0 ? height_Nm / (x * w * w) : 0.0;
      default:
        return 0.0;
    }
  };
  for (LuGreParameter& parameter : fit.parameters) {
    widen(parameter, by(parameter.name), "interval.widened_by_ripple_of_loops");
  }
  return fit;
}

LuGreFit with_friction_of_angle(LuGreFit fit, const gravity::CogSweepResult& sweep,
                                const std::vector<double>& motor_angle_rad) {
  const double share = share_of_friction_left(sweep, motor_angle_rad);
  if (!(share > 0)) return fit;
  // Where friction changes along the loop, what is lost there looks like damping, too (study
  // --misfit, friction_by_motor_angle: 15 to 37 % at shares of 7 to 25 %).
  constexpr double more_in_damping = 2;
  const auto part = [&](LuGreParameterName name) {
    switch (name) {
      case LuGreParameterName::static_torque:
      case LuGreParameterName::coulomb_torque:
      case LuGreParameterName::bristle_stiffness:
        return share;
      case LuGreParameterName::bristle_damping:
        return more_in_damping * share;
      default:
        return 0.0;
    }
  };
  for (LuGreParameter& parameter : fit.parameters) {
    if (parameter.estimate) {
      widen(parameter, part(parameter.name) * std::abs(parameter.estimate->value),
            "interval.widened_by_friction_of_angle");
    }
  }
  return fit;
}

}  // namespace tribolog::method::hysteresis
