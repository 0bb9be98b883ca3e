#pragma once
// One line that a reader can tick off: what is expected, what the program gets, and how far apart
// the two may be.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "figures/report_figure.h"
#include "paper/checks/papers_joint.h"
#include "wording/tr.h"

namespace tribolog::paper::checks {

/// Where the expected value comes from.
enum class Origin {
  printed,        ///< It stands in the paper.
  reconstructed,  ///< Not printed; of the LuGre joint that reproduces the paper's table 2.
  law,            ///< It follows from the equation, or from mechanics.
};

struct Check {
  std::string what;
  Origin origin{Origin::law};
  double expected{};
  double ours{};
  double bound{};          ///< Largest |ours - expected| that counts as agreement.
  std::string unit;        ///< Of all three.
  std::string reason;      ///< Why the bound is what it is; empty where it is 0.
  int printed_places{-1};  ///< Decimals that the paper prints `expected` with; -1: it does not.
  /// Where what is found is no number: as words, and whether it is what is expected.
  std::string expected_words;
  std::string ours_words;
  bool is_as_expected{};

  [[nodiscard]] bool is_words() const { return !expected_words.empty(); }
  [[nodiscard]] double difference() const { return ours - expected; }
  /// False also where `ours` is not a number.
  [[nodiscard]] bool holds() const {
    if (is_words()) return is_as_expected;
    return std::abs(difference()) <= bound;
  }
};

using Checks = std::vector<Check>;

/// Torques of some newton metres whose parts are each rounded; angles are logged to 1e-16 rad.
inline constexpr double log_rounding_Nm = 1e-9;
inline constexpr const char* rounding_of_log = wording::to_translate("rounding of the log");

/// A check whose expected value the paper prints with so many decimals.
inline Check printed_value(std::string what, double expected, int places, double ours, double bound,
                           std::string unit, std::string reason) {
  return {std::move(what),   Origin::printed, expected, ours, bound, std::move(unit),
          std::move(reason), places,          "",       "",   false};
}

/// A difference that the law says is zero.
inline Check vanishing(std::string what, double ours, double bound, std::string unit,
                       std::string reason) {
  return {std::move(what),   Origin::law, 0.0, ours, bound, std::move(unit),
          std::move(reason), -1,          "",  "",   false};
}

inline Check law_value(std::string what, double expected, double ours, double bound,
                       std::string unit, std::string reason) {
  return {std::move(what),   Origin::law, expected, ours, bound, std::move(unit),
          std::move(reason), -1,          "",       "",   false};
}

inline Check reconstructed_value(std::string what, double expected, int places, double ours,
                                 double bound, std::string unit, std::string reason) {
  return {std::move(what),
          Origin::reconstructed,
          expected,
          ours,
          bound,
          std::move(unit),
          std::move(reason),
          places,
          "",
          "",
          false};
}

/// Names and signs, the same in every language: they must be equal.
inline Check by_name(std::string what, Origin origin, std::string expected, std::string ours) {
  const bool is_same = expected == ours;
  return {std::move(what),     origin,          0,      0, 0, "", "", -1,
          std::move(expected), std::move(ours), is_same};
}

/// What is so, or is not: in words for either.
inline Check in_words(std::string what, Origin origin, bool is_so, std::string expected,
                      std::string otherwise) {
  std::string ours = is_so ? expected : std::move(otherwise);
  return {std::move(what),     origin,          0,    0, 0, "", "", -1,
          std::move(expected), std::move(ours), is_so};
}

// The paper's twenty-two figures: what can be read off the printed one, or has to hold in it.

/// Figures 1, 2 and 5: the points that are drawn.
Checks check_static_chart(const PapersJoint& joint, const figures::ReportFigure& drawn);
Checks check_linear_zone_chart(const PapersJoint& joint, const figures::ReportFigure& drawn);
Checks check_presliding_chart(const PapersJoint& joint);
/// Figure 3: from the lines that are drawn.
Checks check_bristle_sketch(const figures::ReportFigure& drawn);
/// Figures 6 to 8: the diagrams' graphs against the simulation.
Checks check_drive_diagram(const PapersJoint& joint);
Checks check_lugre_diagram(const PapersJoint& joint);
Checks check_joint_diagram(const PapersJoint& joint);
Checks check_gear_diagram(const PapersJoint& joint);
/// Figures 9, 10 and 12: the arm in space.
Checks check_robot(const PapersJoint& joint);
Checks check_mass_model(const PapersJoint& joint);
Checks check_motion_range(const PapersJoint& joint);
/// Figures 11, 13 and 14: the sweeps.
Checks check_sweep_motion(const PapersJoint& joint);
Checks check_rough_peak(const PapersJoint& joint);
Checks check_precise_peak(const PapersJoint& joint);
/// Figures 15 to 17: the loops.
Checks check_torque_loop(const PapersJoint& joint);
Checks check_deflection_loop(const PapersJoint& joint);
Checks check_rate_loop(const PapersJoint& joint);
/// Figures 18 to 22: the viscous curves and the choice among them.
Checks check_candidate_curves(const PapersJoint& joint);
Checks check_reference_curve(const PapersJoint& joint);
Checks check_quality_errors(const PapersJoint& joint);
Checks check_selected_curve(const PapersJoint& joint);
Checks check_torque_choice(const PapersJoint& joint);

// Speeds at which two laws are compared.

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
