#pragma once
// Speeds at which two laws are compared.

#include <algorithm>
#include <cmath>
#include <vector>

namespace tribolog::paper {

/// Both directions, evenly over the logarithm of the size, without rest.
inline std::vector<double> speeds_of_both_signs(double slowest_rad_s, double fastest_rad_s,
                                                int per_direction = 500) {
  std::vector<double> speeds;
  for (int i = 0; i < per_direction; ++i) {
    const double share = static_cast<double>(i) / (per_direction - 1);
    const double speed = slowest_rad_s * std::pow(fastest_rad_s / slowest_rad_s, share);
    speeds.push_back(speed);
    speeds.push_back(-speed);
  }
  return speeds;
}

/// Largest |deviation(x)|.
template <class Deviation>
double largest_over(const std::vector<double>& at, Deviation deviation) {
  double largest = 0;
  for (const double x : at) largest = std::max(largest, std::abs(deviation(x)));
  return largest;
}

}  // namespace tribolog::paper
