#pragma once
// One step of the bristle equation under prescribed motion, exact in its stiff part. Written for a
// Scalar, so that derivatives with respect to parameters can be carried along.
//
// Eq. (4) is linear in z: dz/dt = w - lambda z with lambda = |w|/g(w). In the variable
// s = integral of lambda dt it reads dz/ds = h - z with h = sgn(w) g(w), so that over a step
//
//   z1 = exp(-L) z0 + integral_0^L exp(-(L-s)) h(s) ds,      L = integral of lambda over the step.
//
// h is smooth in s as long as w keeps its sign, also right after a reversal (there s ~ w^2, and g
// depends on w^2). It is interpolated by the parabola through the step's start, middle and end, and
// the integral of that is exact: stiffness does not limit the step. The error of the parabola and
// of Simpson's rule for L cancel in their leading term, which makes the step 4th order.

#include <bit>
#include <cmath>
#include <cstdint>

namespace tribolog::friction {

/// exp(x) for x <= 0 (cut at -700, where it is 1e-304), within 2 units in the last place. Unlike
/// std::exp it vectorises, and it gives the same bits on every machine.
[[gnu::always_inline]] inline double exp_nonpositive(double x) {
  constexpr double log2_e = 1.4426950408889634;
  constexpr double ln2_high = 6.93147180369123816490e-01;
  constexpr double ln2_low = 1.90821492927058770002e-10;
  constexpr double shift = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to an integer
  const double clamped = x < -700.0 ? -700.0 : x;
  const double shifted = clamped * log2_e + shift;
  const double k = shifted - shift;
  const double r = (clamped - k * ln2_high) - k * ln2_low;
  double p = 1.0 / 479001600.0;
  p = p * r + 1.0 / 39916800.0;
  p = p * r + 1.0 / 3628800.0;
  p = p * r + 1.0 / 362880.0;
  p = p * r + 1.0 / 40320.0;
  p = p * r + 1.0 / 5040.0;
  p = p * r + 1.0 / 720.0;
  p = p * r + 1.0 / 120.0;
  p = p * r + 1.0 / 24.0;
  p = p * r + 1.0 / 6.0;
  p = p * r + 0.5;
  p = p * r + 1.0;
  p = p * r + 1.0;
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(shifted) << 52;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(p) + exponent);
}

/// exp(x) for -1e-3 <= x <= 0, to the last bit or two, at a third of the cost.
[[gnu::always_inline]] inline double exp_near_zero(double x) {
  double p = 1.0 / 120.0;
  p = p * x + 1.0 / 24.0;
  p = p * x + 1.0 / 6.0;
  p = p * x + 0.5;
  p = p * x + 1.0;
  return p * x + 1.0;
}
inline constexpr double near_zero = 1e-3;

/// The step's length in s, and h over it as c0 + c1 x + c2 x^2, x = s / length in 0..1.
template <class Scalar>
struct StepShape {
  Scalar length;
  Scalar c0, c1, c2;
};

/// Of y' = rate(t) (target(t) - y); the bristle equation has rate |w|/g(w) and target sgn(w) g(w).
/// @param r0,rm,r1 rate at the step's start, middle and end, >= 0
/// @param h0,hm,h1 target there
/// @param dt duration [s].
template <class Scalar>
[[gnu::always_inline]] inline StepShape<Scalar> relaxation_shape(const Scalar& r0, const Scalar& rm,
                                                                 const Scalar& r1, const Scalar& h0,
                                                                 const Scalar& hm, const Scalar& h1,
                                                                 double dt) {
  const Scalar half = dt / 24.0 * (5.0 * r0 + 8.0 * rm - r1);
  const Scalar length = dt / 6.0 * (r0 + 4.0 * rm + r1);
  // At rest the ratio would be 0/0; any node will do there.
  constexpr double nothing = 1e-290;
  constexpr double apart = 1e-6;
  const Scalar ratio = (half + nothing) / (length + 2 * nothing);
  const Scalar low = ratio < apart ? Scalar(apart) : ratio;
  const Scalar xm = low > 1.0 - apart ? Scalar(1.0 - apart) : low;

  const Scalar rise = hm - h0;
  const Scalar c2 = ((h1 - h0) * xm - rise) / (xm * (1.0 - xm));
  const Scalar c1 = (h1 - h0) - c2;
  return {length, h0, c1, c2};
}

/// @param w0,wm,w1 motor speed at the step's start, middle and end; none of opposite sign.
/// @param g0,gm,g1 steady deflection g(w) there, > 0, and i0,im,i1 their reciprocals.
/// @param dt duration [s].
template <class Scalar>
[[gnu::always_inline]] inline StepShape<Scalar> step_shape(double w0, double wm, double w1,
                                                           const Scalar& g0, const Scalar& gm,
                                                           const Scalar& g1, const Scalar& i0,
                                                           const Scalar& im, const Scalar& i1,
                                                           double dt) {
  const double sign = (w0 + w1) + wm < 0 ? -1.0 : 1.0;
  const Scalar r0 = (sign * w0) * i0;
  const Scalar rm = (sign * wm) * im;
  const Scalar r1 = (sign * w1) * i1;
  return relaxation_shape<Scalar>(r0, rm, r1, sign * g0, sign * gm, sign * g1, dt);
}

/// Moments J_k = integral_0^1 exp(-L (1-x)) x^k dx for k = 0, 1, 2, and exp(-L), for L >= 0.
template <class Scalar>
struct StepMoments {
  Scalar j0, j1, j2, decay;
};

/// Below this length the moments come from their series: upward recursion would cancel.
inline constexpr double series_below = 0.25;

/// For L < series_below to 1e-15 with 10 terms, for L < 0.01 with 5.
template <int Terms, class Scalar>
[[gnu::always_inline]] inline StepMoments<Scalar> moments_by_series(const Scalar& length) {
  Scalar t = Scalar(1.0);
  for (int j = Terms + 3; j >= 4; --j) t = 1.0 - (1.0 / j) * (length * t);
  const Scalar j2 = t * (1.0 / 3.0);
  const Scalar j1 = (1.0 - length * j2) * 0.5;
  const Scalar j0 = 1.0 - length * j1;
  return {j0, j1, j2, 1.0 - length * j0};
}

/// For L >= series_below.
template <class Scalar>
[[gnu::always_inline]] inline StepMoments<Scalar> moments_by_exponential(const Scalar& length) {
  const Scalar decay = exp_nonpositive(-length);
  const Scalar inverse = 1.0 / length;
  const Scalar j0 = (1.0 - decay) * inverse;
  const Scalar j1 = (1.0 - j0) * inverse;
  return {j0, j1, (1.0 - 2.0 * j1) * inverse, decay};
}

/// What a step adds to exp(-L) z0.
template <class Scalar>
[[gnu::always_inline]] inline Scalar step_source(const StepShape<Scalar>& s,
                                                 const StepMoments<Scalar>& m) {
  return s.length * (s.c0 * m.j0 + s.c1 * m.j1 + s.c2 * m.j2);
}

/// By whichever of the two fits the length.
template <class Scalar>
StepMoments<Scalar> moments_of(const Scalar& length) {
  return length < series_below ? moments_by_series<10, Scalar>(length)
                               : moments_by_exponential<Scalar>(length);
}

/// y at the end of a step of this shape.
template <class Scalar>
Scalar relaxed(const StepShape<Scalar>& shape, const Scalar& y0) {
  const StepMoments<Scalar> m = moments_of(shape.length);
  return m.decay * y0 + step_source(shape, m);
}

/// y at the end of a step over which the target is constant: only the parabola's constant and one
/// moment are left.
/// @param decay exp(-L)
template <class Scalar>
[[gnu::always_inline]] inline Scalar relaxed_to(const Scalar& target, const Scalar& decay,
                                                const Scalar& y0) {
  return target + decay * (y0 - target);
}

/// z at the end of one step. For loops over many steps see simulate/bristle_integrator.cpp.
template <class Scalar>
Scalar exponential_step(double w0, double wm, double w1, const Scalar& g0, const Scalar& gm,
                        const Scalar& g1, double dt, const Scalar& z0) {
  return relaxed(step_shape<Scalar>(w0, wm, w1, g0, gm, g1, Scalar(1.0 / g0), Scalar(1.0 / gm),
                                    Scalar(1.0 / g1), dt),
                 z0);
}

}  // namespace tribolog::friction
