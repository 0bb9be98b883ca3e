#pragma once
// Where an estimator can be trusted: the levels of each factor, about the base case, at which its
// errors stay within a bound and its stated intervals hold what they promise.

#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "study/study.h"

namespace tribolog::study {

/// What errors of a quantity matter. Both are absolute, in the quantity's unit.
struct PracticalBounds {
  double fine{};    ///< Gravity: 0.1 %. The bound beyond which a bias counts as one.
  double coarse{};  ///< Gravity: 0.3 %
};

/// Gravity 0.1 and 0.3 %; the peak's angle 0.02 and 0.1 degrees; parameters of friction 1 and 5 %.
PracticalBounds practical_bounds(truth::ReadingKind quantity, double truth);

enum class Criterion {
  fine,      ///< 95 of 100 errors within the fine bound.
  coarse,    ///< 95 of 100 errors within the coarse bound.
  coverage,  ///< The stated 95 % interval holds the truth in 91 % of the runs or more.
};

/// Does the criterion hold in a case? A quantity that was found in fewer than 95 of 100 runs does
/// not meet any.
bool holds(const StudiedCase& studied, truth::ReadingName reading, Criterion criterion);

/// The unbroken row of levels about the base case at which a criterion holds.
struct TrustedRange {
  bool at_base{};        ///< Else there is none, and the levels are not valid.
  std::size_t lowest{};  ///< Indices of the factor's levels.
  std::size_t highest{};
  bool all_levels{};  ///< Nothing that was tried breaks it.
};

TrustedRange trusted_range(const StudyResult& study, const StudyFactor& factor,
                           truth::ReadingName reading, Criterion criterion);

/// The estimator that a calibration would recommend: midline, or sweep where no oscillation is
/// recorded. Absent: neither was found.
std::optional<truth::ReadingName> recommended_reading(const StudyResult& study);

/// How far the recommended estimator, the fit and point B can be trusted in the base case, in one
/// sentence.
Statement study_sentence(const StudyResult& study);

/// What the study found, one sentence each, most important first.
std::vector<Statement> study_findings(const StudyResult& study);

}  // namespace tribolog::study
