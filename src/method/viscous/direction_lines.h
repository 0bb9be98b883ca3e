#pragma once
// Coulomb and viscous friction of each direction by itself:  |Tf| = Coulomb + viscous |w|.
//
// Plateaus of one recording, direction and speed count as one run. Runs that travel less than a
// quarter of the widest way take no part where enough are left: torque ripple that repeats with the
// angle averages out over a long way only, and a short one reads a piece of it as friction. The
// line starts beyond the Stribeck dip of its direction.
//
// A difference of the two Coulomb torques is friction that is not the same in both directions, or
// an offset of the torque signal, or an error of the gravity torque: at one load they look alike.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "method/viscous/viscous_curves.h"
#include "statistics/estimate.h"

namespace tribolog {

/// Magnitudes, motor side.
struct DirectionLine {
  Estimate coulomb_Nm;
  Estimate viscous_Nms_rad;
  double residual_Nm{};
  double slowest_rad_s{};  ///< Speeds used.
  double fastest_rad_s{};
  std::size_t runs{};
  std::size_t runs_left_out{};  ///< Too short a way, or below the dip.
};

struct CurveDirectionLines {
  std::string estimator;
  std::optional<DirectionLine> rising;  ///< Joint angle rising; absent: too few speeds.
  std::optional<DirectionLine> falling;
};

struct DirectionLinesResult {
  /// For the recommended curve, and for that of the stated gravity where there is one.
  std::vector<CurveDirectionLines> curves;

  [[nodiscard]] const CurveDirectionLines* find(const std::string& estimator) const;
};

/// @param recommended estimator; empty: none.
DirectionLinesResult fit_direction_lines(const ViscousCurvesResult& curves,
                                         const std::string& recommended);

}  // namespace tribolog
