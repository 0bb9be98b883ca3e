#pragma once
// The change from one estimate to another, with its interval.
//
// The two are of different recordings: their errors are independent. With d = x2 - x1 the sides of
// the 95 % interval add in quadrature, each with the side that moves d the same way:
//
//   d - sqrt((x2 - low2)^2 + (high1 - x1)^2)   to   d + sqrt((high2 - x2)^2 + (x1 - low1)^2)
//
// Exact for normal errors; for lopsided ones the usual approximation (R. Barlow, "Asymmetric
// errors", PHYSTAT 2003). What both estimates share, such as a torque constant that is wrong in
// both, cancels; an influence that both manifests state, but each from another source, adds to both
// sides. Where the stated intervals hold such an error all the same, that of the model for
// one, the interval of the change is too wide, never too narrow.

#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "calibration/archived_calibration.h"
#include "statistics/estimate.h"

namespace tribolog::history {

struct Change {
  statistics::Estimate absolute;  ///< In the quantity's unit.
  std::optional<statistics::Estimate>
      percent;       ///< Of the first value as it stands; absent near zero.
  double chance{1};  ///< Of a change at least this large without one, two-sided, normal errors.
};

/// @param is_angle the difference is taken on the circle, -pi to pi, and not in percent.
/// @param further_half_width of errors beside the estimates' own that the two do not share.
Change change_between(const statistics::Estimate& first, const statistics::Estimate& second,
                      bool is_angle, double further_half_width = 0);

/// Holm's step-down adjustment (1979): with these, the chance of one wrong "changed" among all is
/// the chance that is compared with, whatever depends on what.
std::vector<double> holm_adjusted(const std::vector<double>& chances);

// Two calibrations of a joint side by side: each quantity with its change and a plain word.
//
// The interval shown is the 95 % interval of the one change. The word "changed" takes into account
// that many are looked at: it needs a chance of 5 % or less after Holm's adjustment over all that
// are comparable, so that one pair in twenty at most gets a "changed" without any change.
//
// The intervals hold what each calibration's recordings show. How much the joint differs from day
// to day is in no pair: see control_chart.h.

enum class ChangeWord { no_change_seen, changed, not_comparable };

Statement statement_of(ChangeWord word);  ///< "no change seen"

/// What may differ between two that are compared.
struct AllowedDifference {
  double temperature_K{3};  ///< Friction changes by some 3 % over it: as much as is looked for.
  double rate_factor{2};    ///< Between the sampling rates, for what is read from fast changes.
};

inline constexpr double changed_chance = 0.05;

struct ComparedQuantity {
  std::string name;
  std::string words;
  std::string unit;
  std::optional<statistics::Estimate> first;  ///< SI, motor side.
  std::optional<statistics::Estimate> second;
  std::optional<Change> change;  ///< Where both have an estimate, comparable or not.
  double adjusted_chance{1};     ///< By Holm; of those that are comparable.
  ChangeWord word{ChangeWord::not_comparable};
  std::vector<Statement> why_not;   ///< Empty unless not comparable.
  std::vector<Statement> cautions;  ///< What else may have made a change.
};

struct Comparison {
  calibration::Entry first;
  calibration::Entry second;
  AllowedDifference allowed;
  std::vector<ComparedQuantity> quantities;  ///< In the first's order; those without an estimate in
                                             ///< both are left out.
  std::vector<Statement> remarks;            ///< On the pair as a whole.

  [[nodiscard]] std::size_t count(ChangeWord word) const;
  /// Of those that changed the one whose interval leaves most of the change, in percent of the
  /// first value; angles only where nothing else changed. @return null: nothing changed.
  [[nodiscard]] const ComparedQuantity* largest_change() const;
};

/// @param different_joints allows two of different joints, which the remarks then say.
/// @throw UsageError: different joints otherwise; the same calibration twice.
Comparison compare(const calibration::Measured& first, const calibration::Measured& second,
                   const AllowedDifference& allowed, bool different_joints);

}  // namespace tribolog::history
