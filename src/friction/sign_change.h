#pragma once
// Where a continuous function changes sign.

#include <algorithm>

namespace tribolog::friction {

/// A point of [low, high], within `resolution` of a sign change of f and on its far side. False
/// position; while one end stays, its value is reduced after Anderson and Björck (1973).
/// @param f of opposite signs at both ends; f(high) may be 0.
template <class Function>
double sign_change(const Function& f, double low, double high, double resolution) {
  double f_low = f(low);
  double f_high = f(high);
  const auto reduction = [](double now, double before) {
    const double share = 1 - now / before;
    return share > 0 ? share : 0.5;
  };
  enum class End { none, lower, upper } last = End::none;
  constexpr int most = 200;
  for (int i = 0; i < most && high - low > resolution; ++i) {
    const double estimate = high - f_high * (high - low) / (f_high - f_low);
    // Next to an end, so that the sign change is enclosed from the other side too.
    const double x = std::clamp(estimate, low + resolution / 2, high - resolution / 2);
    if (x <= low || x >= high) break;
    const double fx = f(x);
    if (fx != 0 && (fx < 0) == (f_low < 0)) {
      if (last == End::lower) f_high *= reduction(fx, f_low);
      low = x;
      f_low = fx;
      last = End::lower;
    } else {
      if (last == End::upper) f_low *= reduction(fx, f_high);
      high = x;
      f_high = fx;
      last = End::upper;
    }
  }
  return high;
}

/// Resolution of an instant within a step (slip, break-away, an element's limit), as a share of its
/// duration: it changes no torque by more than rounding does.
inline constexpr double share_resolution = 1e-14;

}  // namespace tribolog::friction
