#pragma once
// Waiboer's five parameters, eq. (6), fitted to friction against speed.

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "base/statement.h"
#include "friction/static_laws.h"
#include "statistics/estimate.h"

namespace tribolog::method::viscous {

struct WaiboerFit {
  bool converged{false};
  statistics::Estimate asperity_torque_Nm;
  statistics::Estimate stribeck_speed_rad_s;
  statistics::Estimate stribeck_power;
  statistics::Estimate viscous_coefficient;
  statistics::Estimate viscous_power;
  double residual_Nm{};
};

/// Friction magnitude at an absolute motor speed.
struct CurvePoint {
  double speed_rad_s{};
  double friction_Nm{};
};

/// Residuals model - measured, and their derivatives unless `j` is null. Unknowns: log Ta, log ws,
/// log da, log cv, and the log of the viscous exponent 1 - dv, all positive by construction.
void waiboer_residuals(const std::vector<CurvePoint>& points, const Eigen::VectorXd& p,
                       Eigen::VectorXd& r, Eigen::MatrixXd* j);

/// @param points sorted by speed.
/// @param why_not receives the reason where there is no fit.
std::optional<WaiboerFit> fit_waiboer(const std::vector<CurvePoint>& points, Statement& why_not);

/// The curve that a fit describes; absent where it has not converged.
std::optional<friction::WaiboerFriction> waiboer_of(const std::optional<WaiboerFit>& fit);

}  // namespace tribolog::method::viscous
