#include "friction/gms.h"

#include <cmath>

#include "parameter_rules.h"

#include "friction/exponential_step.h"

namespace tribolog {
namespace {

constexpr double at_limit = 1 - 1e-9;  // a solver stops next to the moment, not on it

}  // namespace

ParameterSlots GmsFriction::Parameters::by_name() {
  return joined(
      {ParameterSlots{{"elements", "of each stiffness_Nm_rad > 0 and share > 0; shares add up to 1",
                       &elements}},
       curve.by_name(),
       ParameterSlots{
           {"attraction_Nm_s", "C > 0, how fast slipping torque follows s(w)", &attraction_Nm_s},
           {"viscous_Nms_rad", "s2 >= 0", &viscous_Nms_rad}}});
}

GmsFriction::GmsFriction(const Parameters& parameters) : p_(parameters), curve_(parameters.curve) {
  require_maxwell_elements(p_.elements);
  require_positive(p_.attraction_Nm_s, "attraction", "N·m/s");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
}

void GmsFriction::rates(std::span<const double> state, double speed_rad_s,
                        std::span<double> rates) const {
  const std::size_t n = p_.elements.size();
  const double steady = curve_(speed_rad_s);
  for (std::size_t i = 0; i < n; ++i) {
    const MaxwellElement& one = p_.elements[i];
    const double slips = state[n + i];
    rates[i] = slips == 0.0 ? one.stiffness_Nm_rad * speed_rad_s
                            : p_.attraction_Nm_s * (slips * one.share - state[i] / steady);
    rates[n + i] = 0;
  }
}

void GmsFriction::settle(std::span<double> state, double speed_rad_s) const {
  const std::size_t n = p_.elements.size();
  const double direction = direction_of(speed_rad_s);
  const double steady = curve_(speed_rad_s);
  for (std::size_t i = 0; i < n; ++i) {
    double& slips = state[n + i];
    if (slips != direction) slips = 0;
    const double limit = at_limit * p_.elements[i].share * steady;
    if (direction != 0.0 && direction * state[i] >= limit) slips = direction;
  }
}

double GmsFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  double torque = p_.viscous_Nms_rad * speed_rad_s;
  for (std::size_t i = 0; i < p_.elements.size(); ++i) torque += state[i];
  return torque;
}

double GmsFriction::steady_torque_Nm(double speed_rad_s) const {
  return direction_of(speed_rad_s) * curve_(speed_rad_s) + p_.viscous_Nms_rad * speed_rad_s;
}

void GmsFriction::advance(std::span<double> state, const SpeedStep& step) const {
  const double direction = step.direction();
  if (direction == 0.0) return;
  const std::size_t n = p_.elements.size();
  for (std::size_t i = 0; i < n; ++i) {
    const MaxwellElement& one = p_.elements[i];
    double& torque = state[i];
    double& slips = state[n + i];
    if (slips == direction) {
      slip(torque, one.share, step);
      continue;
    }
    slips = 0;
    const auto excess = [&](double share) {
      const double way = step.part(0, share).path_rad();
      return direction * (torque + one.stiffness_Nm_rad * way) -
             one.share * curve_(step.speed_rad_s(share));
    };
    if (excess(1) < 0) {
      torque += one.stiffness_Nm_rad * step.path_rad();
      continue;
    }
    double low = 0;
    double high = excess(0) < 0 ? 1 : 0;
    constexpr int halvings = 52;
    for (int k = 0; k < halvings && high > 0; ++k) {
      const double middle = (low + high) / 2;
      (excess(middle) < 0 ? low : high) = middle;
    }
    torque += one.stiffness_Nm_rad * step.part(0, high).path_rad();
    slips = direction;
    slip(torque, one.share, step.part(high, 1));
  }
}

void GmsFriction::slip(double& torque_Nm, double share, const SpeedStep& step) const {
  const double s0 = curve_(step.start_rad_s);
  const double sm = curve_(step.middle_rad_s);
  const double s1 = curve_(step.end_rad_s);
  const double c = p_.attraction_Nm_s;
  const double target = step.direction() * share;
  torque_Nm = relaxed(relaxation_shape<double>(c / s0, c / sm, c / s1, target * s0, target * sm,
                                               target * s1, step.duration_s),
                      torque_Nm);
}

void GmsFriction::state_scales(std::span<double> scales) const {
  const std::size_t n = p_.elements.size();
  for (std::size_t i = 0; i < n; ++i) {
    scales[i] = p_.elements[i].share * p_.curve.coulomb_Nm;
    scales[n + i] = 1;
  }
}

void GmsFriction::event_values(std::span<const double> state, double speed_rad_s,
                               std::span<double> values) const {
  const std::size_t n = p_.elements.size();
  const double steady = curve_(speed_rad_s);
  for (std::size_t i = 0; i < n; ++i) {
    const bool sticks = state[n + i] == 0.0;
    const double limit = p_.elements[i].share * steady;
    values[i] = sticks ? std::abs(state[i]) - limit : steady;
  }
}

}  // namespace tribolog
