#pragma once
// Stage 8, second half: parameters of the viscous curve of the recommended estimator.
//
// Waiboer's five of eq. (6) by Levenberg-Marquardt where the curve has enough speeds, and the
// straight line Coulomb + viscous beside it, which a curve of any size can carry.

#include <optional>
#include <string>
#include <vector>

#include "method/selection/quality_errors.h"
#include "method/selection/selection.h"
#include "method/viscous/viscous_curves.h"
#include "method/viscous/waiboer_fit.h"
#include "statistics/estimate.h"

namespace tribolog::method::selection {

/// |Tf| = Coulomb + viscous |w| over the speeds beyond the Stribeck dip.
struct CoulombViscousFit {
  statistics::Estimate coulomb_Nm;       ///< Motor side.
  statistics::Estimate viscous_Nms_rad;  ///< Motor side.
  double residual_Nm{};
  double slowest_rad_s{};  ///< Speeds used, motor side.
  double fastest_rad_s{};
};

struct FrictionParametersResult {
  statistics::StageReport stage;
  std::string curve;  ///< Estimator whose curve was fitted, or "direction_difference".
  std::optional<viscous::WaiboerFit> waiboer;
  std::optional<CoulombViscousFit> coulomb_viscous;
  std::vector<double> fit_speed_rad_s;  ///< For figures: speeds >= 0 and the fitted torque there.
  std::vector<double> fit_Nm;
};

FrictionParametersResult fit_friction_parameters(const viscous::ViscousCurvesResult& curves,
                                                 const SelectionResult& selection);

}  // namespace tribolog::method::selection
