#include "simulate/model_portrait.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "base/requirements.h"
#include "simulate/motion.h"

namespace tribolog::simulate {

namespace {

bool reverses(const friction::SpeedStep& step) {
  return simulate::reverses(step.start_rad_s, step.middle_rad_s, step.end_rad_s);
}

constexpr std::size_t block_steps = 256;

/// Of a step that reverses: the first of its reversals that its three speeds tell of.
double turn_within(const Motion& motion, double t0_s, const friction::SpeedStep& step) {
  const double middle_s = t0_s + step.duration_s / 2;
  const double t1_s = t0_s + step.duration_s;
  if (step.start_rad_s * step.middle_rad_s < 0) {
    return reversal_time(motion, t0_s, middle_s, step.start_rad_s < 0);
  }
  if (step.middle_rad_s * step.end_rad_s < 0) {
    return reversal_time(motion, middle_s, t1_s, step.middle_rad_s < 0);
  }
  return reversal_time(motion, t0_s, t1_s, step.start_rad_s < 0);  // the middle stands still
}

/// Advances over a step, cut wherever it reverses.
void advance_cut(const friction::DynamicFriction& friction, const Motion& motion, double t0_s,
                 const friction::SpeedStep& step, std::span<double> state, int cuts) {
  if (cuts == 0 || !reverses(step)) {
    friction.advance(state, step);
    return;
  }
  // Speeds next to the reversal may have the wrong sign by rounding: there it is zero.
  const double turn = turn_within(motion, t0_s, step);
  const double t1_s = t0_s + step.duration_s;
  const friction::SpeedStep before{step.start_rad_s, motion.speed((t0_s + turn) / 2), 0.0,
                                   turn - t0_s};
  const friction::SpeedStep after{0.0, motion.speed((turn + t1_s) / 2), step.end_rad_s,
                                  t1_s - turn};
  advance_cut(friction, motion, t0_s, before, state, cuts - 1);
  advance_cut(friction, motion, turn, after, state, cuts - 1);
}

}  // namespace

void friction_response(const friction::DynamicFriction& friction, const Motion& motion, double t0_s,
                       double dt_s, std::span<double> state, std::span<double> torque_Nm) {
  require_positive(dt_s, "sampling interval", "s");
  if (state.size() != friction.states()) throw std::invalid_argument("unequal sizes");
  if (torque_Nm.empty()) return;
  constexpr int most_cuts = 3;
  std::array<double, block_steps> end_speed;
  std::array<double, block_steps> middle_speed;
  std::array<friction::SpeedStep, block_steps> step;
  double speed = motion.speed(t0_s);
  torque_Nm[0] = friction.torque_Nm(state, speed);
  const std::span<double> torque_after = torque_Nm.subspan(1);
  for (std::size_t first = 0; first < torque_after.size(); first += block_steps) {
    const std::size_t steps = std::min(block_steps, torque_after.size() - first);
    const double t = t0_s + static_cast<double>(first) * dt_s;
    motion.speeds(t + dt_s, dt_s, std::span(end_speed).first(steps));
    motion.speeds(t + dt_s / 2, dt_s, std::span(middle_speed).first(steps));
    for (std::size_t i = 0; i < steps; ++i) {
      step[i] = {speed, middle_speed[i], end_speed[i], dt_s};
      speed = end_speed[i];
    }
    for (std::size_t i = 0; i < steps;) {
      std::size_t until = i;
      while (until < steps && !reverses(step[until])) ++until;
      friction.respond(state, std::span(step).subspan(i, until - i),
                       torque_after.subspan(first + i, until - i));
      i = until;
      if (i == steps) break;
      advance_cut(friction, motion, t + static_cast<double>(i) * dt_s, step[i], state, most_cuts);
      torque_after[first + i] = friction.torque_Nm(state, step[i].end_rad_s);
      ++i;
    }
  }
}

namespace {

/// Speed up and down about a mean, always forward.
class Pulsating final : public Motion {
 public:
  Pulsating(double mean_rad_s, double amplitude_rad_s, double frequency_Hz)
      : mean_(mean_rad_s), amplitude_(amplitude_rad_s), w_(2 * std::numbers::pi * frequency_Hz) {}
  [[nodiscard]] double angle(double t) const override {
    return mean_ * t - amplitude_ / w_ * std::sin(w_ * t);
  }
  [[nodiscard]] double speed(double t) const override {
    return mean_ - amplitude_ * std::cos(w_ * t);
  }
  [[nodiscard]] double acceleration(double t) const override {
    return amplitude_ * w_ * std::sin(w_ * t);
  }

 private:
  double mean_, amplitude_, w_;
};

PortraitCurve steady_curve(const friction::DynamicFriction& model, double stribeck_speed) {
  PortraitCurve out;
  constexpr int points = 200;
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i <= points; ++i) {
      const double share = static_cast<double>(side < 0 ? points - i : i) / points;
      const double speed = side * stribeck_speed * std::max(5 * share, 1e-3);
      out.x.push_back(speed);
      out.torque_Nm.push_back(model.steady_torque_Nm(speed));
    }
  }
  return out;
}

/// Keeps the samples from an index on.
void keep_from(std::size_t first, PortraitCurve& curve) {
  const auto offset = static_cast<std::ptrdiff_t>(first);
  curve.x.erase(curve.x.begin(), curve.x.begin() + offset);
  curve.torque_Nm.erase(curve.torque_Nm.begin(), curve.torque_Nm.begin() + offset);
}

PortraitCurve response(const friction::DynamicFriction& model, const Motion& motion, double dt,
                       std::size_t samples, bool against_speed) {
  PortraitCurve out;
  out.torque_Nm.resize(samples);
  std::vector<double> state = model.unloaded();
  friction_response(model, motion, 0, dt, state, out.torque_Nm);
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) * dt;
    out.x.push_back(against_speed ? motion.speed(t) : motion.angle(t));
  }
  return out;
}

/// Two periods; the first starts from rest and is shown too.
PortraitCurve presliding_loop(const friction::DynamicFriction& model, double elastic_rad,
                              double slow_rad_s) {
  constexpr std::size_t per_period = 2000;
  constexpr double stroke = 1.5;
  constexpr double inner = 0.9;
  const double frequency = slow_rad_s / (2 * std::numbers::pi * elastic_rad * (stroke + 3 * inner));
  const HarmonicMotion motion(0, frequency,
                              {{0, stroke * elastic_rad}, {0, 0}, {0, inner * elastic_rad}});
  return response(model, motion, 1 / (frequency * per_period), 2 * per_period + 1, false);
}

PortraitCurve lag_loop(const friction::DynamicFriction& model, double stribeck_speed,
                       double& lag_Nm) {
  constexpr std::size_t per_period = 400;
  constexpr std::size_t periods = 40;  // the first ones are start-up
  constexpr double frequency = 20;
  const Pulsating motion(1.2 * stribeck_speed, 0.9 * stribeck_speed, frequency);
  PortraitCurve all =
      response(model, motion, 1 / (frequency * per_period), periods * per_period + 1, true);
  keep_from((periods - 1) * per_period, all);
  lag_Nm = 0;
  for (std::size_t i = 1; i < per_period / 2; ++i) {
    lag_Nm += (all.torque_Nm[i] - all.torque_Nm[per_period - i]) / (per_period / 2 - 1);
  }
  return all;
}

/// Moves at constant speed in equal steps and reads the torque after each.
void push(const friction::DynamicFriction& model, std::vector<double>& state, double way,
          double speed, int steps, PortraitCurve* readings) {
  const double signed_speed = std::copysign(speed, way);
  double at = 0;
  for (int i = 0; i < steps; ++i) {
    model.advance(state, {signed_speed, signed_speed, signed_speed, std::abs(way) / steps / speed});
    at += way / steps;
    if (readings == nullptr) continue;
    readings->x.push_back(at);
    readings->torque_Nm.push_back(model.torque_Nm(state, signed_speed));
  }
}

double inner_loop_gap(const friction::DynamicFriction& model, double elastic_rad,
                      double slow_rad_s) {
  constexpr int steps = 1000;
  std::vector<double> state = model.unloaded();
  push(model, state, 0.25 * elastic_rad, slow_rad_s, steps, nullptr);
  const double before = model.torque_Nm(state, slow_rad_s);
  push(model, state, -0.07 * elastic_rad, slow_rad_s, steps, nullptr);
  push(model, state, 0.07 * elastic_rad, slow_rad_s, steps, nullptr);
  return model.torque_Nm(state, slow_rad_s) - before;
}

}  // namespace

ModelPortrait portrait_of(const friction::FrictionModelEntry& entry,
                          const friction::ContactParameters& contact) {
  const auto model = entry.matched(contact);
  const double elastic = contact.static_Nm / contact.stiffness_Nm_rad;
  const double slow = 1e-4 * contact.stribeck_speed_rad_s;
  ModelPortrait out;
  out.steady = steady_curve(*model, contact.stribeck_speed_rad_s);
  out.loop = presliding_loop(*model, elastic, slow);
  out.lag = lag_loop(*model, contact.stribeck_speed_rad_s, out.lag_Nm);
  std::vector<double> state = model->unloaded();
  push(*model, state, 8 * elastic, 0.01 * contact.stribeck_speed_rad_s, 800, &out.break_away);
  const auto& torque = out.break_away.torque_Nm;
  out.largest_Nm = *std::max_element(torque.begin(), torque.end());
  out.sliding_Nm = torque.back();
  out.inner_loop_gap_Nm = inner_loop_gap(*model, elastic, slow);
  return out;
}

}  // namespace tribolog::simulate
