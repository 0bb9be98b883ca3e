#pragma once
// Stage 6: how far each candidate's curve is from a reference, in % of the driving torque:
// 100 (Tf,candidate - Tf,reference) / T.
//
// Where no true curve is known the reference is (T(+v) - T(-v))/2 at equal angle. Gravity cannot
// enter it, so it needs no prior knowledge. It has an interval of its own, and it is the mean of
// both directions' friction: where friction differs between them, every candidate is off by the
// asymmetry, (T(+v) + T(-v))/2 less gravity.

#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "method/viscous/viscous_curves.h"
#include "statistics/estimate.h"

namespace tribolog::friction {
class StaticFriction;
}
namespace tribolog::method::selection {

/// What the candidates' curves are compared with.
enum class CurveReference {
  none,
  analytic,              ///< The true curve.
  direction_difference,  ///< (T(+v) - T(-v))/2
};

/// Stable: "direction_difference"; empty for none.
std::string to_string(CurveReference reference);

struct QualityError {
  hysteresis::Estimator estimator{};
  std::vector<double> percent;  ///< Per run of ViscousCurvesResult; NaN: no reference, or T ~ 0.
  double rms_percent{};
};

struct QualityErrorsResult {
  statistics::StageReport stage;
  CurveReference reference{CurveReference::none};
  std::vector<double> reference_Nm;             ///< Per run; NaN where there is none.
  std::vector<QualityError> errors;             ///< Per curve, in that order.
  std::vector<double> reference_half_width_Nm;  ///< Per run, 95 %; 0 where it is known exactly.
  /// Root mean square over the runs of the reference's own 95 % half width in % of the driving
  /// torque: an rms error below it is no evidence against a mass. Of the runs where it is known;
  /// NaN where it is of none.
  double reference_rms_percent{};
  Statement evidence;           ///< What the reference can show; empty without errors.
  std::size_t runs_left_out{};  ///< Without a reference or with a driving torque near zero.

  [[nodiscard]] const QualityError* find(std::optional<hysteresis::Estimator> estimator) const;
};

/// @param analytic the true curve, known in simulation; where not null it is the reference.
QualityErrorsResult identify_quality_errors(const viscous::ViscousCurvesResult& curves,
                                            const friction::StaticFriction* analytic);

}  // namespace tribolog::method::selection
