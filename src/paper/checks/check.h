#pragma once
// One line that a reader can tick off: what is expected, what the program gets, and how far apart
// the two may be.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "figures/report_figure.h"
#include "paper/checks/papers_joint.h"
#include "wording/tr.h"

namespace tribolog::paper::checks {

/// What a check compares. Only the first shows that the paper is reproduced.
enum class Kind {
  print,        ///< What the paper prints, against what is computed for its joint.
  independent,  ///< The program against another way to the same: the equation written out, a closed
                ///< form, CVODE, a balance of the log.
};

struct Check {
  std::string what;
  Kind kind{Kind::independent};
  double expected{};
  double ours{};
  double bound{};          ///< Largest |ours - expected| that counts as agreement, as it is shown.
  std::string unit;        ///< Of all three.
  std::string reason;      ///< Where the bound comes from; empty where it is 0.
  int printed_places{-1};  ///< Decimals that the paper prints `expected` with; -1: it does not.
  /// Where what is found is no number: as words, and whether it is what is expected.
  std::string expected_words;
  std::string ours_words;
  bool is_as_expected{};

  [[nodiscard]] bool is_words() const { return !expected_words.empty(); }
  [[nodiscard]] double difference() const { return ours - expected; }
  /// The difference in units of the last printed place; nothing where none is printed.
  [[nodiscard]] std::optional<double> in_last_places() const;
  /// False also where `ours` is not a number.
  [[nodiscard]] bool holds() const {
    if (is_words()) return is_as_expected;
    return std::abs(difference()) <= bound;
  }
};

using Checks = std::vector<Check>;

/// A bound as a page shows it, three digits: what is allowed and what is applied are one number.
double as_shown(double bound);

/// Torques of some newton metres whose parts are each rounded; angles are logged to 1e-16 rad.
inline constexpr double log_rounding_Nm = 1e-9;
inline constexpr const char* rounding_of_log = wording::to_translate("rounding of the log");

/// What the paper prints with so many decimals.
Check printed_value(std::string what, double expected, int places, double ours, double bound,
                    std::string unit, std::string reason);

/// A difference that is zero if the program is right.
Check vanishing(std::string what, double ours, double bound, std::string unit, std::string reason);

/// The same quantity by another way.
Check other_way(std::string what, double expected, double ours, double bound, std::string unit,
                std::string reason);

/// A number of the method's description that is known to so many decimals.
Check known_value(std::string what, double expected, int places, double ours, double bound,
                  std::string unit, std::string reason);

/// Names and signs, the same in every language: they must be equal.
Check by_name(std::string what, Kind kind, std::string expected, std::string ours);

/// What is so, or is not: in words for either.
Check in_words(std::string what, Kind kind, bool is_so, std::string expected,
               std::string otherwise);

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

/// The larger of `largest` and |value|; not a number where either is not, so that no comparison
/// takes what could not be computed for agreement.
inline double larger_size(double largest, double value) {
  return std::isnan(largest) || std::isnan(value) ? std::numeric_limits<double>::quiet_NaN()
                                                  : std::max(largest, std::abs(value));
}

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

/// Largest |deviation(x)|; not a number where one of them is not.
template <class Deviation>
double largest_over(const std::vector<double>& at, Deviation deviation) {
  double largest = 0;
  for (const double x : at) largest = larger_size(largest, deviation(x));
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
