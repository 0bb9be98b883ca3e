#pragma once
// Experiments under an applied force that every friction model goes through, and what is read off
// them. A unit mass, the contact of table 1.

#include "simulate/forced_motion.h"

namespace tribolog::test {

/// A force that stays below break-away all the time and oscillates, 0.4 N +- 0.2 N at 5 Hz.
simulate::ForcedMotionSetup push_below_break_away(double duration_s);
/// Displacement at which it would be held elastically [m].
double deflection_of_that_push_m();
/// Mean displacement over the second before that time: models without damping keep ringing.
double mean_displacement_m(const simulate::ForcedMotion& motion, double until_s);

/// A sine of the force from rest, sampled `samples_per_period` times.
simulate::ForcedMotionSetup sinusoidal_push(double amplitude_N, double frequency_Hz, double periods,
                                            double samples_per_period);

/// Drawn by a soft spring at constant speed, in the falling part of the Stribeck curve.
inline constexpr double drawn_m_s = 0.1;
simulate::ForcedMotionSetup drawn_by_a_spring();
/// Slowest and fastest speed of the second half.
struct SpeedRange {
  double slowest_m_s;
  double fastest_m_s;
};
SpeedRange settled_speeds(const simulate::ForcedMotion& motion);

/// A force that rises at this rate past break-away.
simulate::ForcedMotionSetup rising_push(double rate_N_s, double sample_s);
double largest_friction_N(const simulate::ForcedMotion& motion);

/// What the force puts in, what friction takes, and what the mass has at the end [J].
struct EnergyBalance {
  double put_in_J;
  double taken_J;
  double kinetic_J;
};
EnergyBalance energy_of(const simulate::ForcedMotion& motion);

}  // namespace tribolog::test
