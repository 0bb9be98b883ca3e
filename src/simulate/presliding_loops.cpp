#include "simulate/presliding_loops.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "base/requirements.h"
#include "base/statement.h"
#include "friction/lugre.h"
#include "simulate/periodic_orbit.h"

namespace tribolog::simulate {
namespace {

constexpr double mass_kg = 1.0;

std::unique_ptr<friction::DynamicFriction> lugre(const friction::ContactParameters& contact) {
  return friction::dynamic_friction_model("lugre").matched(contact);
}

PeriodicOrbitSetup setup_of(const SinusoidalForce& force) {
  require_positive(force.amplitude_N, Code{"parameter.force_amplitude"}, "N");
  require_positive(force.frequency_Hz, Code{"parameter.force_frequency"}, "Hz");
  PeriodicOrbitSetup setup;
  setup.inertia_kgm2 = mass_kg;
  setup.period_s = 1 / force.frequency_Hz;
  setup.applied_Nm = [=](double t) {
    return force.amplitude_N * std::sin(2 * std::numbers::pi * force.frequency_Hz * t);
  };
  return setup;
}

struct Range {
  double low;
  double high;

  explicit Range(const std::vector<double>& values)
      : low(*std::min_element(values.begin(), values.end())),
        high(*std::max_element(values.begin(), values.end())) {}
  [[nodiscard]] double span() const { return high - low; }
  [[nodiscard]] double largest_size() const { return std::max(std::abs(low), std::abs(high)); }
};

double largest_distance(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

double slow_width_m(const friction::ContactParameters& contact, double amplitude_N) {
  const double share = amplitude_N / contact.static_Nm;
  if (share >= 1) return std::numeric_limits<double>::infinity();
  return contact.static_Nm / contact.stiffness_Nm_rad * std::log((1 + share) / (1 - share));
}

PreslidingLoop loop_of(const friction::DynamicFriction& friction,
                       const friction::ContactParameters& contact, const SinusoidalForce& force) {
  PeriodicOrbitSetup setup = setup_of(force);
  PreslidingLoop out;
  out.amplitude_N = force.amplitude_N;
  out.frequency_Hz = force.frequency_Hz;
  PeriodicOrbit orbit = periodic_orbit(friction, setup);
  setup.relative_tolerance /= 2;
  const ForcedMotion finer = periodic_orbit(friction, setup).cycle;
  out.cycle = std::move(orbit.cycle);
  const std::vector<double>& friction_N = out.cycle.friction_Nm;
  out.width_m = Range(out.cycle.angle_rad).span();
  const double height_N = Range(friction_N).span();
  out.gap = std::max(std::abs(orbit.drift_rad) / out.width_m,
                     std::abs(friction_N.back() - friction_N.front()) / height_N);
  out.tolerance_shift =
      std::max(largest_distance(out.cycle.angle_rad, finer.angle_rad) / out.width_m,
               largest_distance(friction_N, finer.friction_Nm) / height_N);
  out.largest_speed_m_s = Range(out.cycle.speed_rad_s).largest_size();
  out.largest_friction_N = Range(friction_N).largest_size();
  out.stribeck_speed_m_s = contact.stribeck_speed_rad_s;
  out.slow_width_m = slow_width_m(contact, force.amplitude_N);
  out.largest_presliding_N = largest_presliding_amplitude_N(contact, force.frequency_Hz);
  return out;
}

}  // namespace

std::vector<SinusoidalForce> forces_of_figure_5() { return {{1.425, 1}, {1.3, 10}, {1.0, 25}}; }

std::vector<PreslidingLoop> presliding_loops(const friction::ContactParameters& contact,
                                             const std::vector<SinusoidalForce>& forces) {
  const auto friction = lugre(contact);
  std::vector<PreslidingLoop> out;
  for (const SinusoidalForce& force : forces) out.push_back(loop_of(*friction, contact, force));
  return out;
}

PresetLoop preset_loop(const friction::ContactParameters& contact, double travel_m,
                       double frequency_Hz) {
  require_positive(travel_m, Code{"parameter.loop_travel"}, "m");
  require_positive(frequency_Hz, Code{"parameter.force_frequency"}, "Hz");
  const friction::LuGreFriction friction({contact.stiffness_Nm_rad, contact.damping_Nms_rad,
                                          contact.viscous_Nms_rad, contact.coulomb_Nm,
                                          contact.static_Nm, contact.stribeck_speed_rad_s});
  constexpr std::size_t steps = 4000;  // a reversal falls on one
  constexpr int periods = 6;           // a pre-sliding loop forgets its start within two or three
  const double omega = 2 * std::numbers::pi * frequency_Hz;
  const double dt = 1 / (frequency_Hz * steps);
  const auto speed = [&](double t) { return travel_m / 2 * omega * std::cos(omega * t); };
  const auto rate = [&](double t, double z) { return friction.deflection_rate_rad_s(z, speed(t)); };
  PresetLoop out;
  out.travel_m = travel_m;
  out.frequency_Hz = frequency_Hz;
  double z = 0;
  for (int period = 1; period <= periods; ++period) {
    for (std::size_t i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) * dt;
      if (period == periods) {
        out.displacement_m.push_back(travel_m / 2 * std::sin(omega * t));
        out.friction_N.push_back(friction.torque_Nm(z, rate(t, z), speed(t)));
      }
      if (i == steps) break;
      const double k1 = rate(t, z);
      const double k2 = rate(t + dt / 2, z + dt / 2 * k1);
      const double k3 = rate(t + dt / 2, z + dt / 2 * k2);
      const double k4 = rate(t + dt, z + dt * k3);
      z += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
  }
  out.largest_friction_N = Range(out.friction_N).largest_size();
  out.gap = std::abs(out.friction_N.back() - out.friction_N.front()) / out.largest_friction_N;
  return out;
}

double largest_presliding_amplitude_N(const friction::ContactParameters& contact,
                                      double frequency_Hz) {
  const auto friction = lugre(contact);
  const auto runs_away = [&](double amplitude_N) {
    PeriodicOrbitSetup setup = setup_of({amplitude_N, frequency_Hz});
    // A speed to a thousandth is enough here.
    setup.samples = 500;
    setup.relative_tolerance = 1e-6;
    setup.closed_to = 1e-4;
    const PeriodicOrbit orbit = periodic_orbit(*friction, setup);
    return Range(orbit.cycle.speed_rad_s).largest_size() > contact.stribeck_speed_rad_s;
  };
  if (!runs_away(contact.static_Nm)) return contact.static_Nm;
  double holds = 0;
  double slides = contact.static_Nm;
  constexpr double resolution = 5e-4;
  while (slides - holds > resolution * slides) {
    const double middle = (holds + slides) / 2;
    (runs_away(middle) ? slides : holds) = middle;
  }
  return holds;
}

}  // namespace tribolog::simulate
