#pragma once
// A number that carries its derivatives with respect to N parameters through every operation: as
// the Scalar of the exponential step it gives a fit exact derivatives of the integrated state.

#include <array>
#include <cmath>

#include "friction/exponential_step.h"

namespace tribolog::friction {

/// value and d value / d p_k, k = 0..N-1.
template <int N>
struct Dual {
  double value{};
  std::array<double, N> by{};

  Dual() = default;
  /// A constant: all derivatives are zero.
  explicit Dual(double constant) : value(constant) {}
  /// The k-th parameter itself.
  static Dual parameter(double value, int k) {
    Dual x(value);
    x.by[static_cast<std::size_t>(k)] = 1;
    return x;
  }
};

/// A value and the chain rule's factors: f(x), f'(x).
template <int N>
[[gnu::always_inline]] inline Dual<N> chained(double value, double slope, const Dual<N>& x) {
  Dual<N> out(value);
  for (std::size_t k = 0; k < N; ++k) out.by[k] = slope * x.by[k];
  return out;
}

/// f(x, y) with its two partial derivatives.
template <int N>
[[gnu::always_inline]] inline Dual<N> chained(double value, double by_x, const Dual<N>& x,
                                              double by_y, const Dual<N>& y) {
  Dual<N> out(value);
  for (std::size_t k = 0; k < N; ++k) out.by[k] = by_x * x.by[k] + by_y * y.by[k];
  return out;
}

template <int N>
[[gnu::always_inline]] inline Dual<N> operator-(const Dual<N>& x) {
  return chained(-x.value, -1.0, x);
}
template <int N>
[[gnu::always_inline]] inline Dual<N> operator+(const Dual<N>& x, const Dual<N>& y) {
  return chained(x.value + y.value, 1.0, x, 1.0, y);
}
template <int N>
[[gnu::always_inline]] inline Dual<N> operator-(const Dual<N>& x, const Dual<N>& y) {
  return chained(x.value - y.value, 1.0, x, -1.0, y);
}
template <int N>
[[gnu::always_inline]] inline Dual<N> operator*(const Dual<N>& x, const Dual<N>& y) {
  return chained(x.value * y.value, y.value, x, x.value, y);
}
template <int N>
[[gnu::always_inline]] inline Dual<N> operator/(const Dual<N>& x, const Dual<N>& y) {
  const double inverse = 1 / y.value;
  const double ratio = x.value * inverse;
  return chained(ratio, inverse, x, -ratio * inverse, y);
}
template <int N>
[[gnu::always_inline]] inline Dual<N> operator+(const Dual<N>& x, double y) {
  Dual<N> out = x;
  out.value += y;
  return out;
}
template <int N>
[[gnu::always_inline]] inline Dual<N> operator-(const Dual<N>& x, double y) {
  return x + -y;
}
template <int N>
[[gnu::always_inline]] inline Dual<N> operator-(double x, const Dual<N>& y) {
  return chained(x - y.value, -1.0, y);
}
template <int N>
[[gnu::always_inline]] inline Dual<N> operator*(double x, const Dual<N>& y) {
  return chained(x * y.value, x, y);
}
template <int N>
[[gnu::always_inline]] inline Dual<N> operator*(const Dual<N>& x, double y) {
  return y * x;
}
template <int N>
[[gnu::always_inline]] inline Dual<N> operator/(double x, const Dual<N>& y) {
  const double ratio = x / y.value;
  return chained(ratio, -ratio / y.value, y);
}
template <int N>
bool operator<(const Dual<N>& x, double y) {
  return x.value < y;
}
template <int N>
bool operator>(const Dual<N>& x, double y) {
  return x.value > y;
}

/// exp(x) for x <= 0, as for plain numbers in exponential_step.h.
template <int N>
[[gnu::always_inline]] inline Dual<N> exp_nonpositive(const Dual<N>& x) {
  const double value = exp_nonpositive(x.value);
  return chained(value, value, x);
}

inline double value_of(double x) { return x; }
template <int N>
double value_of(const Dual<N>& x) {
  return x.value;
}

}  // namespace tribolog::friction
