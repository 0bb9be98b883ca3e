#include "friction/leuven.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "parameter_rules.h"

#include "friction/path_steps.h"

namespace tribolog {

ParameterSlots LeuvenFriction::Parameters::by_name() {
  return joined(
      {ParameterSlots{{"elements", "of each stiffness_Nm_rad > 0 and share > 0; shares add up to 1",
                       &elements}},
       curve.by_name(),
       ParameterSlots{{"transition_power", "n >= 1", &transition_power, true},
                      {"micro_damping_Nms_rad", "s1 >= 0", &micro_damping_Nms_rad},
                      {"viscous_Nms_rad", "s2 >= 0", &viscous_Nms_rad}}});
}

LeuvenFriction::LeuvenFriction(const Parameters& parameters)
    : p_(parameters), curve_(parameters.curve) {
  require_maxwell_elements(p_.elements);
  require_not_negative(p_.micro_damping_Nms_rad, "micro-viscous damping", "N·m·s/rad");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
  if (!(p_.transition_power >= 1)) {
    throw std::invalid_argument(
        fmt::format("transition power {} is not allowed; it must be >= 1", p_.transition_power));
  }
  for (const MaxwellElement& one : p_.elements) stiffness_Nm_rad_ += one.stiffness_Nm_rad;
}

double LeuvenFriction::limit_Nm(std::size_t element) const {
  return reserve * p_.curve.static_Nm * p_.elements[element].share;
}

double LeuvenFriction::hysteresis_Nm(std::span<const double> state, double further_rad) const {
  double sum = 0;
  for (std::size_t i = 0; i < p_.elements.size(); ++i) {
    const double limit = limit_Nm(i);
    sum += std::clamp(state[1 + i] + p_.elements[i].stiffness_Nm_rad * further_rad, -limit, limit);
  }
  return sum;
}

double LeuvenFriction::slope(double hysteresis_Nm, double speed_rad_s) const {
  const double ratio = hysteresis_Nm / curve_(speed_rad_s);
  const double size = std::pow(std::abs(ratio), p_.transition_power);
  return 1 - direction_of(speed_rad_s) * std::copysign(size, ratio);
}

void LeuvenFriction::rates(std::span<const double> state, double speed_rad_s,
                           std::span<double> rates) const {
  const double rate = speed_rad_s * slope(hysteresis_Nm(state, 0), speed_rad_s);
  rates[0] = rate;
  for (std::size_t i = 0; i < p_.elements.size(); ++i) {
    const bool is_at_limit = std::abs(state[1 + i]) >= limit_Nm(i) && state[1 + i] * rate > 0;
    rates[1 + i] = is_at_limit ? 0.0 : p_.elements[i].stiffness_Nm_rad * rate;
  }
}

void LeuvenFriction::settle(std::span<double> state, double /*speed_rad_s*/) const {
  for (std::size_t i = 0; i < p_.elements.size(); ++i) {
    const double limit = limit_Nm(i);
    state[1 + i] = std::clamp(state[1 + i], -limit, limit);
  }
}

double LeuvenFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  const double hysteresis = hysteresis_Nm(state, 0);
  const double rate = speed_rad_s * slope(hysteresis, speed_rad_s);
  return hysteresis + p_.micro_damping_Nms_rad * rate + p_.viscous_Nms_rad * speed_rad_s;
}

double LeuvenFriction::steady_torque_Nm(double speed_rad_s) const {
  return direction_of(speed_rad_s) * curve_(speed_rad_s) + p_.viscous_Nms_rad * speed_rad_s;
}

void LeuvenFriction::advance(std::span<double> state, const SpeedStep& step) const {
  const double direction = step.direction();
  if (direction == 0.0) return;
  const double elastic_way = p_.curve.static_Nm / stiffness_Nm_rad_;
  constexpr double forgotten = 400;  // the last elements are soft: they forget slowly
  constexpr double finest = 0.05;
  const SpeedStep piece = last_part_of(step, forgotten * elastic_way);
  const double further =
      integrate_along(piece, 0.0, finest * elastic_way, [&](double way, double speed) {
        return slope(hysteresis_Nm(state, direction * way), speed);
      });
  state[0] += direction * further;
  for (std::size_t i = 0; i < p_.elements.size(); ++i) {
    state[1 + i] += p_.elements[i].stiffness_Nm_rad * direction * further;
  }
  settle(state, 0);
}

void LeuvenFriction::state_scales(std::span<double> scales) const {
  scales[0] = p_.curve.coulomb_Nm / stiffness_Nm_rad_;
  for (std::size_t i = 0; i < p_.elements.size(); ++i) {
    scales[1 + i] = p_.elements[i].share * p_.curve.coulomb_Nm;
  }
}

void LeuvenFriction::event_values(std::span<const double> state, double /*speed_rad_s*/,
                                  std::span<double> values) const {
  for (std::size_t i = 0; i < p_.elements.size(); ++i) {
    values[i] = std::abs(state[1 + i]) - limit_Nm(i);
  }
}

}  // namespace tribolog
