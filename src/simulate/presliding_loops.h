#pragma once
// Hysteresis of LuGre friction in pre-sliding: figure 5. Of a unit mass that a sinusoidal force
// moves, and of a displacement that is set.
//
// Whether such a force only bends the bristles or makes the mass slide depends on its rate as well
// as on its size. A force so slow that g(w) = Ts/s0 and inertia does not count gives, with
// a = amplitude/Ts < 1, a loop of the width
//
//   s = Ts/s0 ln((1 + a)/(1 - a))
//
// from dz/dx = 1 -+ z s0/Ts between -a Ts/s0 and a Ts/s0. A faster one reaches the falling part of
// the Stribeck curve before it turns, and the mass runs away until the force lets it.

#include <vector>

#include "friction/catalogue.h"
#include "simulate/forced_motion.h"

namespace tribolog::simulate {

struct SinusoidalForce {
  double amplitude_N{};   ///< > 0
  double frequency_Hz{};  ///< > 0
};

/// The paper's three: 1.425 N at 1 Hz, 1.3 N at 10 Hz, 1 N at 25 Hz.
std::vector<SinusoidalForce> forces_of_figure_5();

struct PreslidingLoop {
  double amplitude_N{};
  double frequency_Hz{};
  /// One period of the orbit that repeats, displacement [m] and force [N], from the moment at which
  /// the force passes zero upwards; the displacement's extremes lie evenly about zero.
  ForcedMotion cycle;
  double width_m{};  ///< Largest less smallest displacement.
  /// Distance of the last point from the first, as a share of the loop's width (displacement) or
  /// height (friction), whichever is larger.
  double gap{};
  /// The same measure for the point that moves most when the solver's tolerance is halved and the
  /// orbit is found anew.
  double tolerance_shift{};
  double largest_speed_m_s{};
  double largest_friction_N{};
  double stribeck_speed_m_s{};
  /// Width that the amplitude would have if the force were slow; infinite from the static force on.
  double slow_width_m{};
  double largest_presliding_N{};  ///< largest_presliding_amplitude_N() at this frequency.
};

/// The loop of each force, from its periodic orbit: it is closed from the first cycle on. Where no
/// such orbit is found, the gap shows it.
/// @throw Refusal for a value that is not allowed, or equations that the solver gives up.
std::vector<PreslidingLoop> presliding_loops(
    const friction::ContactParameters& contact,
    const std::vector<SinusoidalForce>& forces = forces_of_figure_5());

/// Friction under a sinusoidal displacement that is set, whatever it takes.
struct PresetLoop {
  double travel_m{};  ///< From one reversal to the other.
  double frequency_Hz{};
  /// One period once it repeats, from the middle upwards; its last point is its first.
  std::vector<double> displacement_m;
  std::vector<double> friction_N;
  double largest_friction_N{};
  double gap{};  ///< Between the friction of last and first point, as a share of its largest.
};

/// The bristle's equation (4) along the displacement, by the classical Runge-Kutta method.
/// @throw Refusal for a value that is not allowed.
PresetLoop preset_loop(const friction::ContactParameters& contact, double travel_m,
                       double frequency_Hz);

/// The largest amplitude at a frequency whose orbit stays slower than the Stribeck velocity: up to
/// it the mass does not run away. To half a thousandth, from below; not more than the static force.
/// @throw as presliding_loops().
double largest_presliding_amplitude_N(const friction::ContactParameters& contact,
                                      double frequency_Hz);

}  // namespace tribolog::simulate
