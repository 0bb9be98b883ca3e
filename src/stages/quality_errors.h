#pragma once
// Stage 6: how far each candidate's curve is from a reference, in % of the driving torque:
// 100 (Tf,candidate - Tf,reference) / T.

#include <string>
#include <vector>

#include "friction/static_friction.h"
#include "stages/estimate.h"
#include "stages/viscous_curves.h"

namespace tribolog {

struct QualityError {
  std::string estimator;
  std::vector<double> percent;  ///< Per run of ViscousCurvesResult; NaN: no reference, or T ~ 0.
  double rms_percent{};
};

struct QualityErrorsResult {
  StageReport stage;
  std::string reference;             ///< "analytic", "direction_difference" or "" (none).
  std::vector<double> reference_Nm;  ///< Per run; NaN where there is none.
  std::vector<QualityError> errors;  ///< Per curve, in that order.
  std::size_t runs_left_out{};       ///< Without a reference or with a driving torque near zero.

  [[nodiscard]] const QualityError* find(const std::string& estimator) const;
};

/// @param analytic the true curve, known in simulation; where not null it is the reference.
QualityErrorsResult identify_quality_errors(const ViscousCurvesResult& curves,
                                            const StaticFriction* analytic);

}  // namespace tribolog
