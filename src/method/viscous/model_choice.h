#pragma once
// Which model the viscous curve supports, chosen by cross-validation over speeds.
//
// Each speed (both directions and all repetitions of it) is held out in turn, the others are
// fitted, and the error is evaluated there; with six or more speeds the slowest and the fastest are
// never held out, so a model is tested by interpolation only. The simplest model is chosen whose
// error exceeds that of the best by no more than one standard error of the difference over the
// speeds. The training error falls with every further parameter and decides nothing.
//
// Terms for direction and load are added only if they reduce the error at held-out speeds by more
// than twice the standard error of the gain. The load shows only where runs differ in it.
//
// It fails where few speeds were recorded: the standard error is then coarse and the simplest model
// wins, which is what the data support.

#include <string>
#include <vector>

#include "base/statement.h"
#include "method/viscous/curve_model.h"
#include "method/viscous/sliding_law.h"
#include "method/viscous/viscous_curves.h"
#include "statistics/estimate.h"

namespace tribolog::method::viscous {

/// One model tested. Torques on the motor's side.
struct CurveModelTrial {
  CurveModel model;
  Statement excluded_because;  ///< Empty: it was tested, and the errors are valid.
  double training_rms_Nm{};
  double held_out_rms_Nm{};
  /// Friction at CurveModelChoice::curve_speed_rad_s, at the mean load, mean of the directions, for
  /// figures.
  std::vector<double> curve_Nm;
};

/// A parameter of the chosen model, motor side.
struct CurveParameter {
  std::string name;   ///< "coulomb_Nm", "viscous_exponent": with its unit, for results.
  Statement title;    ///< Name and symbol.
  std::string unit;   ///< "N·m"; empty: none, or see `unit_as`.
  Statement unit_as;  ///< The other parameter whose unit it has; else empty.
  statistics::Estimate estimate;
};

struct CurveModelChoice {
  bool chosen_any{false};  ///< The values below are valid.
  Statement sentence;      ///< What was chosen and why, or why nothing was; never empty.
  std::optional<hysteresis::Estimator> curve;  ///< Whose curve it is; absent if made from samples.
  CurveModel chosen;
  std::vector<CurveModelTrial> ladder;     ///< The laws, all with the terms that were added.
  std::vector<CurveModelTrial> options;    ///< The terms tried, with the law they were tried with.
  std::vector<CurveParameter> parameters;  ///< Of the chosen model, with 95 % intervals.
  std::vector<double> curve_speed_rad_s;
  std::size_t speeds{};  ///< Number of groups: speeds, or parts of a sweep.
  /// Whether the curve supports Waiboer's five parameters: that law was chosen.
  bool carries_five{false};
  Statement five_sentence;  ///< Explains carries_five; empty if nothing was chosen.
  /// The headline: not fitted where nothing was chosen, and from a sweep.
  SlidingLaw sliding;

  [[nodiscard]] const CurveModelTrial* find(CurveLaw law) const;
};

/// @param estimator whose curve is taken; without one, or without its curve, nothing is chosen.
CurveModelChoice choose_curve_model(const ViscousCurvesResult& curves,
                                    std::optional<hysteresis::Estimator> estimator);

/// The same from samples, for curves that come from elsewhere. @param sweep laws with a Stribeck
/// effect are not tried: speed and angle change together in a sweep.
CurveModelChoice choose_curve_model(const std::vector<CurveSample>& samples, bool sweep);

}  // namespace tribolog::method::viscous
