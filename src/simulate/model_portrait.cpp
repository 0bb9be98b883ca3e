#include "simulate/model_portrait.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulate/friction_response.h"

namespace tribolog::simulate {
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
