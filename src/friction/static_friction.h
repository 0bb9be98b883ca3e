#pragma once
// The common shape of friction without memory: torque as a function of speed.

#include <memory>

#include "friction/dynamic_friction.h"
#include "friction/named_parameters.h"

namespace tribolog::friction {

class StaticFriction : public FrictionModel {
 public:
  /// Friction torque [N·m] at signed speed [rad/s]; odd. 0 at rest, where a law that is
  /// discontinuous there leaves it open (stribeck.h).
  [[nodiscard]] virtual double torque_Nm(double speed_rad_s) const = 0;
};

/// What a model with memory comes to at constant speed; goes by that model's name and parameters.
class SteadyFriction final : public StaticFriction {
 public:
  /// @throw std::invalid_argument if there is no model.
  explicit SteadyFriction(std::shared_ptr<const DynamicFriction> model);

  [[nodiscard]] std::string name() const override { return model_->name(); }
  [[nodiscard]] NamedParameters named_parameters() const override {
    return model_->named_parameters();
  }
  [[nodiscard]] double torque_Nm(double speed_rad_s) const override {
    return model_->steady_torque_Nm(speed_rad_s);
  }

 private:
  std::shared_ptr<const DynamicFriction> model_;
};

}  // namespace tribolog::friction
