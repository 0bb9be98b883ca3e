#pragma once
// Stage 8, second half: parameters of the viscous curve of the recommended estimator.
//
// Waiboer's five of eq. (6) by Levenberg-Marquardt where the curve has enough speeds, and the
// straight line Coulomb + viscous in addition, which a curve of any size supports.

#include <optional>
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
  std::optional<hysteresis::Estimator> curve;  ///< Whose curve was fitted; absent: none was.
  std::optional<viscous::WaiboerFit> waiboer;
  std::optional<CoulombViscousFit> coulomb_viscous;
};

/// A friction law over motor speeds from 0 on, for figures. Motor side.
struct FrictionCurve {
  std::vector<double> speed_rad_s;
  std::vector<double> torque_Nm;
};

/// The law of the five parameters up to the fastest run, else the straight line. Empty without
/// either.
FrictionCurve fitted_curve(const FrictionParametersResult& fitted);

FrictionParametersResult fit_friction_parameters(const viscous::ViscousCurvesResult& curves,
                                                 const SelectionResult& selection);

}  // namespace tribolog::method::selection
