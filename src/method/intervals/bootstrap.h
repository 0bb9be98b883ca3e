#pragma once
// Intervals of the whole chain by resampling.
//
// Every stage is reduced once to the shift of its result by each of its blocks; a resample draws
// blocks with replacement and repeats only the small algebra: no sample is read again. Blocks are
// fixed: neighbours within the strokes of a sweep, whole cycles of the oscillation, tenths of a
// run's plateau, and runs for the fitted curve (random_stream.h, parameter_resample.h). With
// several oscillations: half cycles for LuGre's parameters, and the positions' scatter for gravity.
// Angle and gravity drawn in a resample enter its masses, curves and parameters, so that errors
// with a common cause are correlated. Ripple at the position of a single oscillation is drawn at
// any phase.
//
// Each resample has its own random stream: the same seed gives the same numbers on any number of
// threads.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "joint/dataset.h"
#include "method/gravity/cog_sweep.h"
#include "method/hysteresis/hysteresis_loop.h"
#include "method/hysteresis/surrogate_masses.h"
#include "method/selection/friction_parameters.h"
#include "method/selection/independent_gravity.h"
#include "method/selection/quality_errors.h"
#include "method/selection/selection.h"
#include "method/viscous/viscous_curves.h"

namespace tribolog::method::intervals {

/// The chain's results; all must outlive the call.
struct ChainResults {
  const gravity::CogSweep& rough_sweep;
  const gravity::CogSweep& precise_sweep;
  const std::optional<statistics::Estimate>& q_peak_rad;
  std::optional<gravity::PeakSource> q_peak_source;
  const hysteresis::Hysteresis& loop;
  const std::optional<hysteresis::LuGreFit>& lugre;  ///< Its parameters as they are stated.
  const hysteresis::SurrogateMassesResult& masses;
  const viscous::ViscousCurves& curves;
  const selection::QualityErrorsResult& quality;
  const selection::SelectionResult& selection;
  const selection::FrictionParametersResult& friction;
  const selection::IndependentGravities& independent;
  double gear_ratio{};

  const gravity::CogSweepResult& rough = rough_sweep.result;
  const gravity::CogSweepResult& precise = precise_sweep.result;
  const hysteresis::HysteresisResult& hysteresis = loop.result;
  const viscous::ViscousCurvesResult& viscous = curves.result;
};

/// One quantity with both its intervals.
struct TwoIntervals {
  std::string
      name;  ///< Stable, with its unit: "q_peak_rad", "mass_kg.midline", "waiboer.stribeck_power".
  std::optional<statistics::Estimate> closed_form;  ///< Absent where there is none.
  std::optional<statistics::Estimate> bootstrap;    ///< Absent without resamples.
  bool bootstrap_is_stated{};                       ///< Which of the two the report states.

  [[nodiscard]] const statistics::Estimate* stated() const;
  /// Width by resampling over width by the closed form; 0 where one is missing or empty.
  [[nodiscard]] double ratio() const;
};

/// 95 % band of a friction curve, one value per run. The gravity of the curve is the same in all
/// runs: the band's width is common to them, not scatter from run to run.
struct CurveBand {
  hysteresis::Estimator estimator{};
  std::vector<double> low_Nm;
  std::vector<double> high_Nm;
};

/// How often the paper's rule chose a point.
struct ChoiceShare {
  hysteresis::Estimator estimator{};
  double share{};
};

/// How a gravity torque was found: as one of the masses, or as one of IndependentGravities.
using GravityMethod = std::variant<hysteresis::Estimator, selection::IndependentMethod>;

/// Stable: "midline", "classical".
std::string to_string(const GravityMethod& method);

/// Difference of a gravity torque from the recommended one, with an interval of its own: both were
/// resampled together.
struct GravityDifference {
  GravityMethod method;
  statistics::Estimate gravity_Nm;
  statistics::Estimate difference_Nm;
};

struct IntervalsResult {
  std::size_t resamples{};  ///< 0: closed forms alone.
  std::uint64_t seed{};
  std::vector<TwoIntervals> quantities;
  std::vector<CurveBand> bands;                ///< Per curve, in the order of the curves.
  std::vector<ChoiceShare> choices;            ///< A to F; empty if the rule could not be applied.
  std::vector<GravityDifference> differences;  ///< Empty without resamples or recommendation.

  [[nodiscard]] const TwoIntervals* find(const std::string& name) const;
  [[nodiscard]] const CurveBand* band(hysteresis::Estimator estimator) const;
};

struct ResamplingOptions {
  std::size_t resamples{1000};
  std::uint64_t seed{1};
  std::size_t threads{0};  ///< 0: all cores.
};

/// @param progress receives the number of resamples done; may be empty.
/// @throw Refusal if the resamples are not allowed (joint/dataset.h).
IntervalsResult resample_chain(const ChainResults& results, const ResamplingOptions& options,
                               const std::function<void(std::size_t done)>& progress = {});

/// The parameters with the resampled interval where that is the stated one. Values do not change;
/// without resamples nothing does.
selection::FrictionParametersResult with_stated_intervals(
    selection::FrictionParametersResult friction, const IntervalsResult& intervals);

}  // namespace tribolog::method::intervals
