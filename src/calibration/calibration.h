#pragma once
// A calibration: every stage's result, its inputs, and the verdict.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "calibration/quantity_verdict.h"
#include "calibration/reading_name.h"
#include "joint/dataset.h"
#include "method/checks/data_check.h"
#include "method/gravity/cog_sweep.h"
#include "method/hysteresis/break_away.h"
#include "method/hysteresis/hysteresis_loop.h"
#include "method/hysteresis/loop_shape.h"
#include "method/hysteresis/position_plan.h"
#include "method/hysteresis/surrogate_masses.h"
#include "method/model/model_quantities.h"
#include "method/motion/false_stamps.h"
#include "method/motion/plateaus.h"
#include "method/motion/torque_outliers.h"
#include "method/selection/cross_checks.h"
#include "method/selection/friction_parameters.h"
#include "method/selection/quality_errors.h"
#include "method/selection/selection.h"
#include "method/viscous/viscous_curves.h"

namespace tribolog::calibration {

/// The joint's way through one recording, thinned for a picture.
struct LogTrace {
  std::string recording;
  joint::Role role{};
  std::vector<double> t_s;
  std::vector<double> q_rad;
};

/// What figures draw besides the numbers: samples and fitted curves, no results.
struct Curves {
  method::gravity::SweepCurves rough;
  method::gravity::SweepCurves precise;
  std::vector<method::hysteresis::LoopTrace> loops;  ///< One for each oscillation in the result.
  std::vector<LogTrace> log{};                       ///< Of each recording, in the dataset's order.
};

/// One quantity of the simulated joint, as identified over the runs.
struct ReturnedQuantity {
  ReadingName name{};
  std::string unit;
  double put_in{};
  double came_back{};   ///< Mean over the runs in which it was found; NaN: found in none.
  double scatter{};     ///< Standard deviation over the runs; NaN with fewer than two.
  double half_width{};  ///< Mean half width of the stated intervals.
  std::size_t found{};
  std::size_t inside{};  ///< Runs whose stated interval contains what was put in.
  /// (came back - put in) / half width for each run in which it was found; between -1 and 1:
  /// inside.
  std::vector<double> in_half_widths;
  /// Found in most runs, and inside the interval in most of those or off by a negligible amount.
  bool comes_back{};
};

/// A quantity that is not recovered.
struct TruthFinding {
  ReadingName name{};
  Statement finding;
};

struct TruthCheckResult {
  std::size_t runs{};  ///< 0: the check was not made.
  std::uint64_t seed{};
  double white_Nm{};        ///< Found in the torque: median over the recordings, motor side.
  double torque_step_Nm{};  ///< 0: continuous.
  double ripple_Nm{};       ///< Standard deviation; 0: none.
  std::vector<ReturnedQuantity> quantities;
  std::vector<Statement> left_out;     ///< What could not be simulated, and why.
  std::vector<TruthFinding> findings;  ///< What is not recovered.

  [[nodiscard]] const ReturnedQuantity* find(ReadingName name) const;
};

/// The verdict, with what it rests on.
struct Judgement {
  Verdict verdict{Verdict::not_identifiable};
  Statement sentence;                       ///< For the top of the report.
  std::vector<Statement> findings;          ///< What the reader must know, most important first.
  std::vector<QuantityVerdict> quantities;  ///< Each with its own verdict, in the report's order.
  std::vector<FrictionAtSpeed> friction_at_speed;  ///< Rising speed; empty: none was measured.
  std::vector<RuleOutcome> rules;                  ///< All rules applied, in the table's order.

  [[nodiscard]] const QuantityVerdict* find(joint::Quantity quantity) const;
};

/// By how much a quantity changes where an influence that acts on the torque sample by sample
/// (masses of the arm's description, hoses) is off by what is stated of it: found by identifying
/// the recordings again with so much more and less taken off.
struct InfluenceShift {
  Influence influence{};
  joint::Quantity quantity{};
  /// In the quantity's own unit; nullopt: at one of the influence's limits the quantity is not
  /// found at all, and no interval holds what that does.
  std::optional<double> half_width;
};

struct Calibration {
  joint::Manifest manifest;
  std::vector<joint::InputFile> inputs;
  std::vector<Statement> notes;  ///< From reading the input.
  std::vector<method::motion::SpeedSource> speed_sources;

  method::motion::FalseStamps false_stamps;
  method::motion::TorqueOutliers torque_outliers;
  method::checks::DataChecksResult data_checks;
  method::gravity::CogSweepResult rough;
  method::gravity::CogSweepResult precise;
  std::optional<statistics::Estimate>
      q_peak_rad;  ///< Joint angle of the gravity peak, from the sweep with the narrower interval,
                   ///< else from the runs.
  std::optional<method::gravity::PeakSource> q_peak_source;  ///< Present with the angle.
  method::hysteresis::HysteresisResult hysteresis;
  std::optional<method::hysteresis::LuGreFit> lugre;  ///< Of all oscillations, where it was tried.
  method::hysteresis::SurrogateMassesResult masses;
  method::viscous::ViscousCurvesResult viscous;
  method::selection::QualityErrorsResult quality;
  method::selection::SelectionResult selection;
  method::selection::FrictionParametersResult friction;
  std::vector<method::hysteresis::LoopShape>
      loop_shapes;  ///< Of the oscillations, without any model.
  method::hysteresis::BreakAwayResult break_away;
  method::selection::CrossChecksResult cross_checks;
  method::model::ModelResult model;  ///< Of sweeps, runs and points at once.
  std::optional<method::hysteresis::PositionPlan>
      position_plan;  ///< Where to oscillate next, if ripple requires it.
  /// Where gravity of the other joints was taken off, or a torque of hoses is stated; else empty.
  std::vector<InfluenceShift> influence_shifts;
  Judgement judgement;
  TruthCheckResult truth_check;
  Curves curves;

  /// All stages' reports in the order of the method; that of break-away ramps, which are not in the
  /// paper, only if there are any.
  [[nodiscard]] std::vector<statistics::StageReport> stages() const;
};

}  // namespace tribolog::calibration
