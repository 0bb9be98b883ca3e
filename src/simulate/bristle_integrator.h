#pragma once
// The bristle equation of LuGre, eq. (4), under prescribed motion, in one pass.
//
// Exponential, 4th order (exponential_step.h); split at every reversal of the motion, halved where
// the Stribeck curve bends too sharply within a step. Stiffness sets no bound on the step.

#include <cmath>
#include <span>

#include "friction/dual.h"
#include "friction/exponential_step.h"
#include "friction/lugre.h"
#include "simulate/motion.h"

namespace tribolog::simulate {

/// @param motion of the motor shaft.
/// @param t0_s time of the first sample, dt_s sampling interval > 0.
/// @param z0_rad deflection at t0_s.
/// @param z_rad out: mean deflection at t0, t0 + dt, ...; its size is the number of samples.
/// @param dz_rad_s out: its rate there; as many as z_rad.
/// @throw std::invalid_argument if dt_s is not > 0, z0_rad not finite or the sizes differ.
void integrate_bristle(const friction::LuGreFriction& friction, const Motion& motion, double t0_s,
                       double dt_s, double z0_rad, std::span<double> z_rad,
                       std::span<double> dz_rad_s);

// One step of the bristle equation under prescribed motion where one exponential step is not
// enough: the motion turns round within it, or g bends too sharply for one parabola.

// Above this size of the parabola's last term (relative to g) a step is halved: what is left out,
// the cubic term, is then below 1e-8 of g for a Stribeck curve.
inline constexpr double roughest_step = 3e-4;
inline constexpr int deepest_halving = 14;

/// z at time b from z at time a.
/// @param g steady deflection by motor speed, Scalar > 0.
/// @param wa,wb motor speeds at a and b.
template <class Scalar, class Deflection>
Scalar careful_step(const Deflection& g, const Motion& motion, double a, double b, double wa,
                    double wb, const Scalar& z, int halvings = deepest_halving) {
  const double middle = a + (b - a) / 2;
  const double wm = motion.speed(middle);
  const auto in_two = [&](double at, double w) {
    const Scalar half_way = careful_step<Scalar>(g, motion, a, at, wa, w, z, halvings - 1);
    return careful_step<Scalar>(g, motion, at, b, w, wb, half_way, halvings - 1);
  };
  if (reverses(wa, wm, wb) && halvings > 0) {
    double zero = middle;
    if (wa * wm < 0) {
      zero = reversal_time(motion, a, middle, wa < 0);
    } else if (wm * wb < 0) {
      zero = reversal_time(motion, middle, b, wm < 0);
    }
    if (zero > a && zero < b) return in_two(zero, 0.0);
  }
  const Scalar ga = g(wa);
  const Scalar gm = g(wm);
  const Scalar gb = g(wb);
  const friction::StepShape<Scalar> shape = friction::step_shape<Scalar>(
      wa, wm, wb, ga, gm, gb, Scalar(1.0 / ga), Scalar(1.0 / gm), Scalar(1.0 / gb), b - a);
  if (std::abs(friction::value_of(shape.c2)) > roughest_step * friction::value_of(gm) &&
      halvings > 0) {
    return in_two(middle, wm);
  }
  return friction::relaxed(shape, z);
}

}  // namespace tribolog::simulate
