#pragma once
// A calibration: every stage's result, what it was made from, and the verdict.

#include <optional>
#include <string>
#include <vector>

#include "joint/dataset.h"
#include "stages/break_away.h"
#include "stages/cog_sweep.h"
#include "stages/friction_parameters.h"
#include "stages/hysteresis_loop.h"
#include "stages/loop_shape.h"
#include "stages/quality_errors.h"
#include "stages/selection.h"
#include "stages/surrogate_masses.h"
#include "stages/viscous_curves.h"

namespace tribolog {

enum class Verdict { usable, doubtful, not_identifiable };

std::string to_string(Verdict verdict);

/// The verdict, with what it rests on.
struct Judgement {
  Verdict verdict{Verdict::not_identifiable};
  std::string sentence;               ///< One sentence for the top of the report.
  std::vector<std::string> findings;  ///< What the reader must know, most important first.
};

struct Calibration {
  Manifest manifest;
  std::vector<InputFile> inputs;
  std::vector<std::string> notes;  ///< From reading the input.

  CogSweepResult rough;
  CogSweepResult precise;
  std::optional<Estimate> q_peak_rad;  ///< The one of the two with the narrower interval.
  std::string q_peak_source;           ///< "cog_rough" or "cog_precise"
  HysteresisResult hysteresis;
  SurrogateMassesResult masses;
  ViscousCurvesResult viscous;
  QualityErrorsResult quality;
  SelectionResult selection;
  FrictionParametersResult friction;
  std::vector<LoopShape> loop_shapes;  ///< Of the oscillations, without any model.
  BreakAwayResult break_away;
  Judgement judgement;

  /// All stages' reports in the order of the method; break-away ramps, which the paper has not,
  /// only where there are some.
  [[nodiscard]] std::vector<StageReport> stages() const;
};

}  // namespace tribolog
