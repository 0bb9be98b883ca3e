#pragma once
// Stage 7: the estimator to use, and the corrected angle of the centre of gravity, eq. (14).

#include <optional>
#include <vector>

#include "base/statement.h"
#include "method/hysteresis/hysteresis_loop.h"
#include "method/hysteresis/surrogate_masses.h"
#include "method/selection/quality_errors.h"
#include "statistics/estimate.h"

namespace tribolog::method::selection {

struct SelectionResult {
  statistics::StageReport stage;
  /// The one of A..F with the smallest rms error; absent: cannot be determined.
  std::optional<hysteresis::Estimator> paper_rule;
  /// Those of A..F that the rule could have chosen instead: within the intervals of their masses
  /// they may be as close to the recommended mass.
  std::vector<hysteresis::Estimator> paper_rule_rivals;
  /// Ours: the first available of midline, sweep, runs and stated, but the sweep before a mid-line
  /// that is clearly less certain; absent without any of them.
  std::optional<hysteresis::Estimator> recommended;
  Statement why;  ///< A few sentences; empty without a recommendation.
  /// Eq. (14) for the paper's choice: q_c less the angle from the peak at which it was read.
  std::optional<double> q_c_corrected_rad;
  std::optional<statistics::Estimate> q_c_rad;  ///< Link angle of the centre of gravity, -q_peak.
};

SelectionResult select_estimator(const hysteresis::SurrogateMassesResult& masses,
                                 const QualityErrorsResult& errors,
                                 const hysteresis::HysteresisResult& hysteresis,
                                 const std::optional<statistics::Estimate>& q_peak_rad);

}  // namespace tribolog::method::selection
