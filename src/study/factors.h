#pragma once
// What a Monte-Carlo study varies: one factor at a time about the base case, at stated levels.

#include <string>
#include <vector>

#include "base/statement.h"
#include "simulate/scenario.h"

namespace tribolog::study {

/// One setting of a factor.
struct StudyLevel {
  double value{};  ///< In the axis' unit.
  Statement text;  ///< "20 mN·m", "131072 counts"
  bool is_base{};
  std::string case_name;  ///< Levels of one name, of any factors, are one case: it is run once.
  simulate::Scenario scenario;
};

/// Its words, by the key: "factor" is its title, "factor_axis" that of an axis, "factor_note" what
/// is varied, and what is left out of the recordings.
struct StudyFactor {
  std::string key;  ///< Stable: "torque_noise", "ripple_one_position", ...
  bool logarithmic{};
  std::vector<StudyLevel> levels;  ///< Ascending; one is the base case.
};

/// The factors that the scenario's experiments allow, in the order of the report: white torque
/// noise, torque step, encoder; with an oscillation also ripple from one and from eight positions,
/// amplitude, cycles. Levels are multiples of the scenario's own value, or where it states none, of
/// that of method.md section 8 by its share of the gravity torque.
///
/// Recordings that the factor does not touch are left out where no estimator of that factor needs
/// them: the precise sweep and the runs at constant speed take no part where the oscillation alone
/// is changed. The rough sweep always does: the angle of the peak and the ripple that widens the
/// intervals come from it.
std::vector<StudyFactor> study_factors(const simulate::Scenario& base);

/// The scenario as the study takes it: no bristle deflection in the log, which no drive measures,
/// no break-away ramps, which none of its estimators reads, and noise as above where none is
/// stated.
simulate::Scenario study_base(const simulate::Scenario& scenario);

}  // namespace tribolog::study
