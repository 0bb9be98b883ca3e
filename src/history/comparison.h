#pragma once
// Two calibrations of a joint side by side: each quantity with its change and a plain word.
//
// The interval shown is the 95 % interval of the one change. The word "changed" takes into account
// that many are looked at: it needs a chance of 5 % or less after Holm's adjustment over all that
// are comparable, so that one pair in twenty at most gets a "changed" without any change.
//
// The intervals hold what each calibration's recordings show. How much the joint differs from day
// to day is in no pair: see control_chart.h.

#include <string>
#include <vector>

#include "calibration/archived_calibration.h"
#include "history/change.h"

namespace tribolog::history {

enum class ChangeWord { no_change_seen, changed, not_comparable };

std::string to_string(ChangeWord word);  ///< "no change seen"

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
  std::optional<Estimate> first;  ///< SI, motor side.
  std::optional<Estimate> second;
  std::optional<Change> change;  ///< Where both have an estimate, comparable or not.
  double adjusted_chance{1};     ///< By Holm; of those that are comparable.
  ChangeWord word{ChangeWord::not_comparable};
  std::vector<std::string> why_not;   ///< Empty unless not comparable.
  std::vector<std::string> cautions;  ///< What else may have made a change.
};

struct Comparison {
  archive::Entry first;
  archive::Entry second;
  AllowedDifference allowed;
  std::vector<ComparedQuantity> quantities;  ///< In the first's order; those without an estimate in
                                             ///< both are left out.
  std::vector<std::string> remarks;          ///< On the pair as a whole.

  [[nodiscard]] std::size_t count(ChangeWord word) const;
};

/// @param different_joints allows two of different joints, which the remarks then say.
/// @throw UsageError: different joints otherwise; the same calibration twice.
Comparison compare(const archive::Measured& first, const archive::Measured& second,
                   const AllowedDifference& allowed, bool different_joints);

}  // namespace tribolog::history
