#pragma once
// Coulomb and viscous friction of each direction separately:  |Tf| = Coulomb + viscous |w|.
//
// Plateaus of one recording, direction and speed count as one run. Runs that travel less than a
// quarter of the longest are left out if enough remain: torque ripple that repeats with the angle
// averages out over a long travel only; over a short one a piece of it is read as friction. The
// line starts beyond the Stribeck dip of its direction.
//
// A difference between the two Coulomb torques is friction that differs between the directions, or
// an offset of the torque signal, or an error of the gravity torque: at one load they are
// indistinguishable.

#include <cstddef>
#include <optional>
#include <vector>

#include "base/statement.h"
#include "method/hysteresis/surrogate_masses.h"
#include "method/viscous/viscous_curves.h"
#include "statistics/estimate.h"

namespace tribolog::method::viscous {

/// Magnitudes, motor side.
struct DirectionLine {
  statistics::Estimate coulomb_Nm;
  statistics::Estimate viscous_Nms_rad;
  double residual_Nm{};
  double slowest_rad_s{};  ///< Speeds used.
  double fastest_rad_s{};
  std::size_t runs{};
  std::size_t runs_left_out{};  ///< Too short a travel, or in the dip.
};

struct CurveDirectionLines {
  hysteresis::Estimator estimator{};
  std::optional<DirectionLine> rising;  ///< Joint angle rising; absent: too few speeds.
  std::optional<DirectionLine> falling;
};

struct DirectionLinesResult {
  /// For the recommended curve, and for that of the stated gravity where there is one.
  std::vector<CurveDirectionLines> curves;

  [[nodiscard]] const CurveDirectionLines* find(
      std::optional<hysteresis::Estimator> estimator) const;
};

DirectionLinesResult fit_direction_lines(const ViscousCurvesResult& curves,
                                         std::optional<hysteresis::Estimator> recommended);

// Is friction the same in both directions?
//
// At equal angle and speed (T(+v) + T(-v))/2 is gravity plus the part of friction that does not
// change sign with the motion. Less the recommended gravity torque it is the asymmetry: half the
// difference of the two directions' friction. It limits the reference (T(+v) - T(-v))/2, which is
// their mean. An offset of the torque signal looks the same, and so does an error of the gravity
// torque within its interval.

struct DirectionAsymmetryResult {
  bool examined{false};             ///< The numbers below are valid.
  bool found{false};                ///< Larger than its half width and the error of gravity
                                    ///< together.
  Statement sentence;               ///< The outcome in words; never empty.
  std::vector<double> speed_rad_s;  ///< Per pair of runs, motor side, > 0.
  std::vector<double> asymmetry_Nm;
  statistics::Estimate mean_Nm;       ///< Mean of the pairs; interval from their scatter.
  double gravity_could_explain_Nm{};  ///< Half width of the gravity torque, at the pairs' angles.
};

/// @param mass the recommended one, or nullptr.
/// @param sweep_offset_Nm what was subtracted from the pairs' torque where they come from a sweep
/// [N·m].
DirectionAsymmetryResult identify_direction_asymmetry(const ViscousCurvesResult& curves,
                                                      const hysteresis::SurrogateMass* mass,
                                                      double sweep_offset_Nm);

}  // namespace tribolog::method::viscous
