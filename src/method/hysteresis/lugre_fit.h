#pragma once
// Stage 8, first half: every LuGre parameter that recorded loops T(q) can show, and the gravity
// torque, without a measured bristle deflection: z is the fitted model's.
//
// All recordings together, of any amplitude, frequency and position: friction and inertia are
// shared, gravity torque and initial deflection are separate for each recording (torque ripple is a
// constant over a micro-oscillation). The motion is what was fitted to q(t): harmonics, or a spline
// where a torque drove the joint (traced_motion.h); a recording may begin anywhere in a loop, and
// the first reversal erases where. The data decide which parameters the loops support
// (lugre_ladder.h); one that they do not show is held and reported without a number, with the
// experiment that would show it.
//
// Intervals: block regression over half cycles, valid for residuals that are correlated within a
// stroke; wrong where the model is wrong, which the residuals' scatter shows in comparison with the
// noise. Along a spline the noise of the angle is added (traced_loop.h).

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "joint/recording.h"
#include "method/hysteresis/contact_comparison.h"
#include "method/hysteresis/cycle_misfit.h"
#include "method/hysteresis/fall_of_damping.h"
#include "method/hysteresis/loop_effects.h"
#include "method/hysteresis/loop_misfit.h"
#include "method/hysteresis/loop_timing.h"
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
  std::optional<double> held_at;  ///< The value at which the fit held it.
  /// Relative standard error; absent where it was held.
  std::optional<double> relative_error;
  /// Torque (rms over the samples) that the parameter makes and no other can imitate; absent where
  /// it was held.
  std::optional<double> effect_Nm;
  std::vector<EffectShare> shares;  ///< Of the estimate's variance, largest first.
  Statement why_not;                ///< Why it is not shown; empty if it is.
  Statement experiment;             ///< What would show it; empty if it is shown.
};

/// Identifiability by the singular values of the scaled Jacobian. Columns are scaled by the
/// parameters' natural sizes (the value at which a parameter's torque would be that of friction),
/// those of single recordings other than the first are projected out, and rows are averaged: a unit
/// change along a direction changes the torque by its singular value [N·m, rms].
struct LuGreIdentifiability {
  std::vector<Statement> names;                  ///< Of the columns.
  std::vector<double> singular_values_Nm;        ///< Descending.
  double condition{};                            ///< First over last.
  std::vector<double> weakest;                   ///< Singular vector of the last, in the order of
                                                 ///< `names`.
  Statement weakest_statement;                   ///< Columns of that direction, the largest first.
  std::vector<std::vector<double>> correlation;  ///< Of the estimates, in the order of `names`.
};

enum class LoopMotion {
  harmonics,  ///< Harmonics fitted to the angle.
  spline,     ///< Smoothing spline through the angle.
};

/// Stable: "harmonics".
std::string to_string(LoopMotion motion);

/// The fit's results for one recording.
struct LuGreLoop {
  std::string recording;
  std::optional<statistics::Estimate>
      gravity_Nm;  ///< At the gravity peak; ripple of its position included.
  double start_deflection_rad{};
  std::size_t samples_left_out{};  ///< At the beginning, where the drive starts the motion.
  double left_out_s{};             ///< Their duration.
  double residual_Nm{};            ///< Standard deviation of T - model.
  LoopMisfit misfit;
  CycleMisfit cycle_misfit;  ///< Only of a periodic loop.
  double height_Nm{};        ///< Largest minus smallest torque, without the jump of a start.
  /// Root mean square of the residual that noise does not explain.
  double systematic_Nm{};
  LoopMotion motion{};               ///< What drove the model.
  double motion_residual_rad{};      ///< Standard deviation of the recorded angle about that
                                     ///< motion.
  std::optional<TracedLoop> traced;  ///< Only with a spline.
};

/// Share of a loop's height from which on what LuGre leaves of it indicates another contact: a
/// joint whose loop differs by 0.6 % can be 26 % stiffer or softer
/// (tests/identify/other_friction_test.cpp).
inline constexpr double lugre_misfit = 0.005;

struct LuGreFit {
  bool converged{false};
  std::optional<LuGreRung> rung;           ///< Absent where there was nothing to fit.
  std::vector<LuGreParameter> parameters;  ///< All of them, shown or not.
  std::optional<statistics::Estimate>
      gravity_Nm;  ///< Motor side, at the peak, over all recordings.
  LuGreIdentifiability identifiability;
  std::vector<LuGreLoop> loops;  ///< In the order given.
  double residual_Nm{};          ///< Standard deviation of T - model.
  double height_Nm{};            ///< Height of the highest loop.
  double peak_speed_rad_s{};     ///< Largest motor speed in the loops.
  double motor_amplitude_rad{};  ///< Largest.
  double frequency_Hz{};         ///< Of the loop with the largest motor amplitude.
  std::optional<FallOfDamping> damping_fall;
  ContactComparison contacts;  ///< Held where LuGre leaves what repeats.
  int iterations{};
  Statement reason;  ///< Why nothing was fitted, or what the loops cannot show.

  /// The loop in which the unexplained residual is the largest share of the height; null without
  /// loops.
  [[nodiscard]] const LuGreLoop* worst_described() const;
  /// That residual by the loop's height; absent without loops.
  [[nodiscard]] std::optional<double> misfit_share() const;
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

/// What sweeps and runs say of the loops.
struct KnownOfLoops {
  KnownEffects effects;
  std::optional<statistics::Estimate> inertia_kgm2;  ///< Motor side.
};

struct FittedLuGre {
  LuGreFit fit;
  std::vector<LuGreSignals> signals;  ///< In the order of LuGreFit::loops.
  /// Gravity, its interval not yet widened by ripple; present with LuGreFit::gravity_Nm.
  std::optional<PositionMean> positions;
};

/// @param loops at least one.
/// @param q_peak_rad angle at which gravity is largest.
/// @param ripple that the sweep shows; widens gravity where distinct positions are fewer than
/// three.
/// @throw std::invalid_argument if there is no loop.
FittedLuGre fit_lugre(const std::vector<LuGreInput>& loops, double gear_ratio, double q_peak_rad,
                      const gravity::Ripple& ripple = {}, const KnownOfLoops& known = {});

}  // namespace tribolog::method::hysteresis
