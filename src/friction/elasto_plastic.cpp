#include "friction/elasto_plastic.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "parameter_rules.h"

#include "friction/path_steps.h"

namespace tribolog {

ParameterSlots ElastoPlasticFriction::Parameters::by_name() {
  return joined({ParameterSlots{{"bristle_stiffness_Nm_rad", "s0 > 0", &bristle_stiffness_Nm_rad},
                                {"bristle_damping_Nms_rad", "s1 >= 0", &bristle_damping_Nms_rad},
                                {"viscous_Nms_rad", "s2 >= 0", &viscous_Nms_rad}},
                 curve.by_name(),
                 ParameterSlots{{"break_away_deflection_rad", "0 < zba < Tc/s0",
                                 &break_away_deflection_rad}}});
}

ElastoPlasticFriction::ElastoPlasticFriction(const Parameters& parameters)
    : p_(parameters), curve_(parameters.curve) {
  require_positive(p_.bristle_stiffness_Nm_rad, "bristle stiffness", "N·m/rad");
  require_not_negative(p_.bristle_damping_Nms_rad, "bristle damping", "N·m·s/rad");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
  require_positive(p_.break_away_deflection_rad, "break-away deflection", "rad");
  const double least = p_.curve.coulomb_Nm / p_.bristle_stiffness_Nm_rad;
  if (p_.break_away_deflection_rad >= least) {
    throw std::invalid_argument(
        fmt::format("break-away deflection {} rad is not allowed; it must be < Coulomb torque / "
                    "stiffness, {} rad",
                    p_.break_away_deflection_rad, least));
  }
}

double ElastoPlasticFriction::steady_deflection_rad(double speed_rad_s) const {
  return curve_(speed_rad_s) / p_.bristle_stiffness_Nm_rad;
}

double ElastoPlasticFriction::slope(double deflection_rad, double speed_rad_s) const {
  const double elastic = p_.break_away_deflection_rad;
  if (deflection_rad <= elastic) return 1;
  const double steady = steady_deflection_rad(speed_rad_s);
  if (deflection_rad >= steady) return 1 - deflection_rad / steady;
  const double middle = (steady + elastic) / 2;
  const double share = (deflection_rad - middle) / (steady - elastic);
  const double alpha = (1 + std::sin(std::numbers::pi * share)) / 2;
  return 1 - alpha * deflection_rad / steady;
}

void ElastoPlasticFriction::rates(std::span<const double> state, double speed_rad_s,
                                  std::span<double> rates) const {
  const double direction = speed_rad_s < 0 ? -1.0 : 1.0;
  rates[0] = speed_rad_s * slope(direction * state[0], speed_rad_s);
}

double ElastoPlasticFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  double rate = 0;
  rates(state, speed_rad_s, {&rate, 1});
  return p_.bristle_stiffness_Nm_rad * state[0] + p_.bristle_damping_Nms_rad * rate +
         p_.viscous_Nms_rad * speed_rad_s;
}

double ElastoPlasticFriction::steady_torque_Nm(double speed_rad_s) const {
  const double sign = direction_of(speed_rad_s);
  return sign * curve_(speed_rad_s) + p_.viscous_Nms_rad * speed_rad_s;
}

void ElastoPlasticFriction::advance(std::span<double> state, const SpeedStep& step) const {
  const double direction = step.direction();
  if (direction == 0.0) return;
  const double way = std::abs(step.path_rad());
  const double start = direction * state[0];
  const double elastic_way = p_.break_away_deflection_rad - start;
  if (way <= elastic_way) {
    state[0] = direction * (start + way);
    return;
  }
  const double largest = p_.curve.static_Nm / p_.bristle_stiffness_Nm_rad;
  const double least = p_.curve.coulomb_Nm / p_.bristle_stiffness_Nm_rad;
  constexpr double forgotten = 30;  // exp(-30): nothing is left of a deflection after so much way
  constexpr double finest = 0.05;
  const double rest = std::min(way - std::max(elastic_way, 0.0), forgotten * largest);
  const SpeedStep piece = last_part_of(step, rest);
  const double begin = elastic_way > 0 ? p_.break_away_deflection_rad : start;
  const double end = integrate_along(piece, begin, finest * least,
                                     [&](double z, double speed) { return slope(z, speed); });
  state[0] = direction * end;
}

void ElastoPlasticFriction::state_scales(std::span<double> scales) const {
  scales[0] = p_.curve.coulomb_Nm / p_.bristle_stiffness_Nm_rad;
}

}  // namespace tribolog
