#pragma once
// Short experiments on a friction model, as the tests of its behaviour need them.

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "friction/catalogue.h"
#include "simulate/model_portrait.h"

namespace tribolog::test {

/// A model and its state, moved by hand.
class Specimen {
 public:
  explicit Specimen(const friction::FrictionModelEntry& entry,
                    const friction::ContactParameters& contact = {})
      : model_(entry.matched(contact)), state_(model_->unloaded()) {}
  explicit Specimen(std::unique_ptr<friction::DynamicFriction> model)
      : model_(std::move(model)), state_(model_->unloaded()) {}

  /// Moves by a way at constant speed, in steps of at most `longest`; returns the torque at the
  /// end.
  double move(double way, double speed, double longest = 1e-6) {
    const double steps = std::max(1.0, std::ceil(std::abs(way) / longest));
    const double signed_speed = std::copysign(speed, way);
    const double dt = std::abs(way) / steps / speed;
    for (double i = 0; i < steps; ++i) {
      model_->advance(state_, {signed_speed, signed_speed, signed_speed, dt});
    }
    return model_->torque_Nm(state_, signed_speed);
  }
  void rest(double duration_s) { model_->advance(state_, {0, 0, 0, duration_s}); }
  [[nodiscard]] const friction::DynamicFriction& model() const { return *model_; }
  [[nodiscard]] std::vector<double>& state() { return state_; }

 private:
  std::unique_ptr<friction::DynamicFriction> model_;
  std::vector<double> state_;
};

/// Torque over some periods of a sine.
inline std::vector<double> under_sine(const friction::DynamicFriction& model, double amplitude,
                                      double frequency_Hz, int samples_per_period, int periods) {
  std::vector<double> state = model.unloaded();
  const auto count = static_cast<std::size_t>(samples_per_period * periods + 1);
  std::vector<double> torque(count);
  const double dt = 1 / (frequency_Hz * samples_per_period);
  simulate::friction_response(model, simulate::HarmonicMotion::sine(0, amplitude, frequency_Hz), 0,
                              dt, state, torque);
  return torque;
}

}  // namespace tribolog::test
