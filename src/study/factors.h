#pragma once
// What a Monte-Carlo study varies: one factor at a time about the base case, at stated levels.

#include <string>
#include <vector>

#include "simulate/scenario.h"

namespace tribolog::study {

/// One setting of a factor.
struct StudyLevel {
  double value{};    ///< In the axis' unit.
  std::string text;  ///< "20 mN·m", "131072 counts"
  bool is_base{};
  std::string case_name;  ///< Levels of one name, of any factors, are one case: it is run once.
  simulate::Scenario scenario;
};

struct StudyFactor {
  std::string key;    ///< Stable: "torque_noise", "ripple_one_position", ...
  std::string title;  ///< "White torque noise"
  std::string axis;   ///< "white torque noise [mN·m]"
  std::string note;   ///< What is varied, and what is left out of the recordings; a sentence.
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
