#pragma once
// Stage 8, first half: every LuGre parameter that recorded loops T(q) can show, and the gravity
// torque, with no bristle deflection measured: z is the fitted model's own.
//
// All recordings together, of any amplitude, frequency and position: friction and inertia are
// shared, gravity torque and the deflection at the start are each recording's own (torque ripple is
// a constant over a micro-oscillation). The motion is what was fitted to q(t): harmonics, or a
// spline where a torque drove the joint (traced_motion.h); a recording may begin anywhere in a
// loop, and the first reversal makes it forget where. Which parameters the loops carry is decided
// by the data (lugre_ladder.h); one that they do not show is held, is given no number, and comes
// with the experiment that would show it.
//
// Intervals: block regression over half cycles, right for residuals that hang together within a
// stroke; wrong where the model is, which the residual's scatter against the noise tells. Along a
// spline the noise of the angle is added (traced_loop.h).

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "joint/recording.h"
#include "method/hysteresis/cycle_misfit.h"
#include "method/hysteresis/loop_misfit.h"
#include "method/hysteresis/lugre_ladder.h"
#include "method/hysteresis/lugre_problem.h"
#include "method/hysteresis/position_mean.h"
#include "method/hysteresis/traced_loop.h"
#include "statistics/estimate.h"

namespace tribolog::statistics {
struct LinearisedFit;
}

namespace tribolog::method::hysteresis {

/// In the order of LuGreFit::parameters.
enum class LuGreParameterName {
  bristle_stiffness,
  bristle_damping,
  viscous,
  static_torque,
  coulomb_torque,
  stribeck_speed,
  speed_weakening,  ///< (Ts - Tc)/ws^2, the start of the fall.
  inertia,
};

inline constexpr std::array lugre_parameters{
    LuGreParameterName::bristle_stiffness, LuGreParameterName::bristle_damping,
    LuGreParameterName::viscous,           LuGreParameterName::static_torque,
    LuGreParameterName::coulomb_torque,    LuGreParameterName::stribeck_speed,
    LuGreParameterName::speed_weakening,   LuGreParameterName::inertia};

/// Stable, with its unit: "static_Nm".
std::string to_string(LuGreParameterName name);

struct LuGreParameter {
  LuGreParameterName name{};
  /// Present only where the loops show it. Motor side.
  std::optional<statistics::Estimate> estimate;
  std::optional<double> held_at;  ///< Where the fit did not vary it.
  /// Standard error over the value; absent where it was held.
  std::optional<double> relative_error;
  /// Torque (rms over the samples) that the parameter makes and no other can imitate; absent where
  /// it was held.
  std::optional<double> effect_Nm;
  Statement why_not;     ///< Why it is not shown; empty if it is.
  Statement experiment;  ///< What would show it; empty if it is shown.
};

/// What the singular values of the scaled Jacobian tell. Columns are scaled by the parameters'
/// natural sizes (the value at which its torque would be that of friction), those of single
/// recordings other than the first are projected out, and rows are averaged: a unit change along a
/// direction changes the torque by its singular value [N·m, rms].
struct LuGreIdentifiability {
  std::vector<Statement> names;                  ///< Of the columns.
  std::vector<double> singular_values_Nm;        ///< Descending.
  double condition{};                            ///< First over last.
  std::vector<double> weakest;                   ///< Direction of the last, by names.
  Statement weakest_statement;                   ///< Columns that make it up, the largest first.
  std::vector<std::vector<double>> correlation;  ///< Of the estimates, by names.
};

enum class LoopMotion {
  harmonics,  ///< Of the angle.
  spline,     ///< Through it.
};

/// Stable: "harmonics".
std::string to_string(LoopMotion motion);

/// The fit's view of one recording.
struct LuGreLoop {
  std::string recording;
  std::optional<statistics::Estimate>
      gravity_Nm;  ///< At the gravity peak; ripple of its position included.
  double start_deflection_rad{};
  double residual_Nm{};  ///< Standard deviation of T - model.
  LoopMisfit misfit;
  CycleMisfit cycle_misfit;  ///< Of a loop with a period.
  double height_Nm{};        ///< Largest less smallest torque.
  /// What the model leaves and noise does not explain, root mean square.
  double systematic_Nm{};
  LoopMotion motion{};               ///< What drove the model.
  double motion_residual_rad{};      ///< Standard deviation of the recorded angle less that motion.
  std::optional<TracedLoop> traced;  ///< Of a spline.
};

struct LuGreFit {
  bool converged{false};
  std::optional<LuGreRung> rung;           ///< Absent where there was nothing to fit.
  std::vector<LuGreParameter> parameters;  ///< All of them, shown or not.
  std::optional<statistics::Estimate>
      gravity_Nm;  ///< Motor side, at the peak, over all recordings.
  LuGreIdentifiability identifiability;
  std::vector<LuGreLoop> loops;  ///< In the order given.
  double residual_Nm{};          ///< Standard deviation of T - model.
  double height_Nm{};            ///< Largest height of a loop.
  double peak_speed_rad_s{};     ///< Largest motor speed in the loops.
  double motor_amplitude_rad{};  ///< Largest.
  double frequency_Hz{};         ///< Of the loop with the largest motor amplitude.
  int iterations{};
  Statement reason;  ///< Why nothing was fitted, or what the loops cannot show.

  /// The loop in which what noise does not explain is the largest share of the height; null
  /// without loops.
  [[nodiscard]] const LuGreLoop* worst_described() const;
  /// Present only where the parameter is shown.
  [[nodiscard]] std::optional<statistics::Estimate> shown(LuGreParameterName name) const;
};

/// The model's signals at the samples of one recording.
struct LuGreSignals {
  std::vector<double> torque_Nm;
  std::vector<double>
      z_rad;  ///< Empty where the fit has no bristle of its own (no gravity torque).
  std::vector<double> dz_rad_s;
};

struct FittedLuGre {
  LuGreFit fit;
  std::vector<LuGreSignals> signals;  ///< In the order of LuGreFit::loops.
  /// Gravity before ripple is laid on it; present with LuGreFit::gravity_Nm.
  std::optional<PositionMean> positions;
  /// For resampling, of a fit that converged (statistics/levenberg_marquardt.h).
  std::shared_ptr<const statistics::LinearisedFit> linearised;
  std::vector<LuGreParameterName> readings;  ///< What those of `linearised` are, in their order.
};

/// @param loops at least one.
/// @param q_peak_rad angle at which gravity is largest.
/// @param ripple that the sweep shows; widens gravity where distinct positions are fewer than
/// three.
/// @throw std::invalid_argument if there is no loop.
/// @param lag_half_width_s how far the torque may still be late or early against the angle (95 %):
/// it looks like bristle damping, and widens what rests on that.
FittedLuGre fit_lugre(const std::vector<LuGreInput>& loops, double gear_ratio, double q_peak_rad,
                      const gravity::Ripple& ripple = {}, double lag_half_width_s = 0);

}  // namespace tribolog::method::hysteresis
