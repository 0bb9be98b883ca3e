#pragma once
// Stage 8, second half: parameters of the viscous curve of the recommended estimator.
//
// Waiboer's five of eq. (6) by Levenberg-Marquardt where the curve has enough speeds.

#include <optional>
#include <vector>

#include "method/selection/quality_errors.h"
#include "method/selection/selection.h"
#include "method/viscous/viscous_curves.h"
#include "method/viscous/waiboer_fit.h"
#include "statistics/estimate.h"

namespace tribolog::method::selection {

struct FrictionParametersResult {
  statistics::StageReport stage;
  std::optional<hysteresis::Estimator> curve;  ///< Whose curve was fitted; absent: none was.
  std::optional<viscous::WaiboerFit> waiboer;
};

FrictionParametersResult fit_friction_parameters(const viscous::ViscousCurvesResult& curves,
                                                 const SelectionResult& selection);

}  // namespace tribolog::method::selection
