#pragma once
// Speeds at which two laws are compared.

#include <algorithm>
#include <cmath>
#include <vector>

#include "paper/checks/check.h"
#include "paper/checks/papers_joint.h"

namespace tribolog::paper::checks {

/// A handful of operations on torques of about 1 N·m, each rounded once.
inline constexpr double law_rounding_Nm = 1e-13;
inline constexpr const char* law_rounding = wording::to_translate("rounding");

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

// The paper's fourteen equations, each held against what the program computes.
//
// The reference is written here from the paper's page, as corrected by the errata, or is a
// consequence that has to hold; the other side is what the program uses everywhere else.

Checks check_equation_1(const PapersJoint& joint);
Checks check_equation_2(const PapersJoint& joint);
Checks check_equation_3(const PapersJoint& joint);
Checks check_equation_4(const PapersJoint& joint);
Checks check_equation_5(const PapersJoint& joint);
Checks check_equation_6(const PapersJoint& joint);
Checks check_equation_7(const PapersJoint& joint);
Checks check_equation_8(const PapersJoint& joint);
Checks check_equation_9(const PapersJoint& joint);
Checks check_equation_10(const PapersJoint& joint);
Checks check_equation_11(const PapersJoint& joint);
Checks check_equation_12(const PapersJoint& joint);
Checks check_equation_13(const PapersJoint& joint);
Checks check_equation_14(const PapersJoint& joint);

}  // namespace tribolog::paper::checks
