#pragma once
// The gravity torque and the mass by every estimator, compared with the recommended one.
//
// The one model reads sweeps and runs, the mid-line and the loop fit read the oscillations: their
// errors are independent, and a difference beyond both intervals is one that neither explains.

#include <optional>
#include <vector>

#include "base/statement.h"
#include "method/hysteresis/hysteresis_loop.h"
#include "method/hysteresis/surrogate_masses.h"
#include "statistics/estimate.h"

namespace tribolog::method::selection {

struct CrossCheck {
  hysteresis::Estimator estimator{};
  statistics::Estimate gravity_Nm;  ///< Motor side.
  statistics::Estimate mass_kg;     ///< The same, as a surrogate mass.
  bool is_recommended{};
  bool is_biased{};             ///< A pair mean of a loop whose motion has harmonics.
  bool has_same_samples{};      ///< Read from what the recommended one was read from.
  double difference_percent{};  ///< Of the recommended mass.
  double difference_half_width_percent{};
  /// |difference| in units of its 95 % half width; above 1 the difference is significant. 0 if both
  /// are exact.
  double difference_in_intervals{};
  bool disagrees{};  ///< By more than chance among all estimators, and by more than 0.1 %.

  /// Whether it should agree with the recommended one, and says something that this does not.
  [[nodiscard]] bool counts() const { return !is_recommended && !is_biased && !has_same_samples; }
};

struct CrossChecksResult {
  /// Including the recommended one; empty without one, or where it is indistinguishable from zero.
  std::vector<CrossCheck> checks;
  std::vector<Statement> findings;  ///< Those that disagree, with likely causes.
  bool doubtful{};                  ///< They disagree by more than a mass may be off.
};

/// A smaller relative difference is of no consequence, however narrow the intervals.
inline constexpr double least_difference = 1e-3;
/// Relative accuracy of numerics and model.
inline constexpr double numerical_share = 1e-4;
/// From this relative difference on, both intervals included, the recommended mass is doubtful.
inline constexpr double largest_spread = 1e-2;

/// @param gear_ratio > 0. @param recommended absent: there is nothing to compare with.
CrossChecksResult cross_check(const hysteresis::SurrogateMassesResult& masses,
                              const std::optional<hysteresis::Estimator>& recommended,
                              const hysteresis::HysteresisResult& loops, double gear_ratio);

}  // namespace tribolog::method::selection
