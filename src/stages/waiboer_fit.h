#pragma once
// Waiboer's five parameters, eq. (6), fitted to friction against speed.

#include <optional>
#include <string>
#include <vector>

#include "friction/waiboer.h"
#include "stages/friction_parameters.h"

namespace tribolog {

/// Friction magnitude at an absolute motor speed.
struct CurvePoint {
  double speed_rad_s{};
  double friction_Nm{};
};

/// @param points sorted by speed.
/// @param why_not receives the reason in words where there is no fit.
std::optional<WaiboerFit> fit_waiboer(const std::vector<CurvePoint>& points, std::string& why_not);

/// The curve that a fit describes.
WaiboerFriction waiboer_of(const WaiboerFit& fit);

}  // namespace tribolog
