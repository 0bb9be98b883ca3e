#pragma once
// Internal to the stage: one regression over the cells of all pairs of strokes.
//
//   T = gravity(q) + offset + offset drift * time + asymmetry * level
//     + direction * (level of the pair + per load |G/n cos(q - q_peak)| + level * angle(q)
//                    + lag * speed * slope of gravity)
//
// gravity(q) = b cos + c sin [+ cos 2q, sin 2q where the data require them]; angle(q) has a sine of
// q and both of 2q. Each pair of strokes has a level of its own, so that speed does not enter the
// other terms. Motor side.

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "method/session/stroke_pairs.h"
#include "statistics/block_regression.h"

namespace tribolog::method::session {

/// Which terms of the model are fitted.
struct ConditionTerms {
  bool second_of_angle{};  ///< cos 2q and sin 2q of the part that does not change sign with the
                           ///< direction.
  bool load{};
  bool angle{};
  bool asymmetry{};
  bool drift_of_offset{};
  bool lag{};
};

struct ConditionFit {
  statistics::BlockRegression regression;
  // Columns; -1: not fitted.
  Eigen::Index gravity{-1};  ///< Two, then two more with second_of_angle.
  Eigen::Index second{-1};
  Eigen::Index offset{-1};
  Eigen::Index offset_drift{-1};
  Eigen::Index asymmetry{-1};
  Eigen::Index load{-1};
  Eigen::Index angle{-1};  ///< Three: sin x, cos 2x, sin 2x with x = q - q_peak.
  Eigen::Index lag{-1};
  std::vector<double> level_Nm;        ///< Level of each pair, at the reference load.
  std::vector<double> level_error_Nm;  ///< Standard errors, excluding what all levels share.

  /// Probability of coefficients [first, first + count) as large as these without any effect.
  [[nodiscard]] double chance_of(Eigen::Index first, Eigen::Index count) const;
};

struct GravityGuess {
  double q_peak_rad{};
  double gravity_Nm{};  ///< Amplitude, motor side.
};

/// Origin of load and angle terms: means over the angles at which friction was recorded.
struct ReferenceCondition {
  double load{};                      ///< |cos x|, x = q - q_peak.
  Eigen::RowVector3d angle{0, 0, 0};  ///< sin x, cos 2x, sin 2x.
};

/// sin x, cos 2x, sin 2x.
Eigen::RowVector3d angle_terms(double from_peak_rad);

/// @param taken_off one per cell: subtracted from its torque; may be empty.
ConditionFit fit_conditions(const StrokePairs& strokes, const GravityGuess& gravity,
                            const ReferenceCondition& reference, const ConditionTerms& terms,
                            const std::vector<double>& taken_off = {});

}  // namespace tribolog::method::session
