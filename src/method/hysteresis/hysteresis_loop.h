#pragma once
// Stage 3: the micro-oscillation about the gravity peak; loops T(q), z(q), dz/dt(q) and the points
// A to F of the paper's table 2.
//
// The points, in the order of time (definitions of ours under which a LuGre joint reproduces the
// whole table): A z = 0 while the arm rises; C largest z; F smallest dz/dt (arm dropping, z > 0);
// B z = 0 while the arm drops; D smallest z; E largest dz/dt (arm rising, z < 0).
//
// The log of a real drive contains no z. It then comes from a LuGre model fitted to T(t) (stage 8).

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "joint/recording.h"
#include "method/gravity/cog_sweep.h"
#include "method/hysteresis/estimator.h"
#include "method/hysteresis/lugre_fit.h"
#include "method/hysteresis/position_mean.h"
#include "statistics/estimate.h"

namespace tribolog::method::hysteresis {

struct LoopPoint {
  Estimator name{Estimator::A};  ///< One of loop_points.
  double t_s{};
  double q_rad{};
  double torque_Nm{};      ///< Motor side.
  double torque_low_Nm{};  ///< 95 % interval of the reading.
  double torque_high_Nm{};
  double z_rad{};
  double dz_rad_s{};
};

/// One oscillation with its bristle state, sample by sample: for figures and readings.
struct LoopTrace {
  std::string recording;
  std::vector<double> t_s;
  std::vector<double> q_rad;
  std::vector<double> torque_Nm;
  std::vector<double> z_rad;  ///< Recorded or from the fitted model; empty if neither.
  std::vector<double> dz_rad_s;
  std::vector<double> model_torque_Nm;  ///< Of the fitted model; empty without a fit.
  /// Mid-line of the steady loop: mean of the rising and the falling branch at equal angle.
  std::vector<double> midline_q_rad;
  std::vector<double> midline_Nm;
};

struct Oscillation {
  double centre_rad{};
  double amplitude_rad{};
  double frequency_Hz{};
  double cycles{};            ///< Whole cycles in the recording.
  double steady_cycles{};     ///< Those after the start-up stroke, used for the mid-line.
  double encoder_step_rad{};  ///< Smallest step seen in q; 0: continuous.
  bool step_is_of_print{};    ///< It is that of the log's decimals; see AngleStep.
  double second_harmonic{};   ///< Of the motion, as a share of the first; 0: not known.
  double third_harmonic{};
};

struct HysteresisResult {
  statistics::StageReport stage;
  bool found{false};
  /// "loop.bristle_recorded", "loop.bristle_fitted", or empty where there is no deflection.
  Statement bristle_source;
  std::vector<Oscillation> oscillations;  ///< One per recording used.
  /// The paper's reading: from the first strokes of the first recording, in the order A..F. Empty
  /// if no bristle state is available.
  std::vector<LoopPoint> points;
  /// The same points of the steady loop, averaged over its cycles.
  std::vector<LoopPoint> steady_points;
  std::optional<statistics::Estimate>
      midline_Nm;                 ///< Motor-side torque of the steady loop's mid-line at q_peak.
  double midline_q_rad{};         ///< Mean angle of the loop.
  double midline_mean_cos{1.0};   ///< Mean of cos(q - q_peak) over the loop.
  std::size_t samples_at_rest{};  ///< Before and after the motion; left out.
  double loop_height_Nm{};        ///< Largest minus smallest torque of the loop, motor side.
  /// Mean friction of the loops behind the mid-line: the mean distance of their torque from it.
  double midline_friction_Nm{};
  bool midline_by_angle{};  ///< Some are means over the angle: their motion has even harmonics.
  /// Whether the scatter of the mid-lines over distinct positions includes the torque ripple.
  bool positions_hold_ripple{};

  /// Where pre-sliding cannot be resolved, what shows it: travel after a reversal within which
  /// friction reverses, and the encoder's step.
  std::optional<double> presliding_travel_rad;
  std::optional<double> encoder_step_rad;
  bool step_is_of_print{};  ///< That step is of the log's decimals; see AngleStep.
};

struct Hysteresis {
  HysteresisResult result;
  std::vector<LoopTrace> traces;     ///< In the order of HysteresisResult::oscillations.
  std::optional<FittedLuGre> lugre;  ///< Stage 8; its signals have been moved into the traces.
  std::size_t steady_cycles{};       ///< Of the first recording that have a mid-line.
};

/// @param oscillations recordings of that role; may be empty.
/// @param sweep the rough sweep, and what was found in it: its reversals show pre-sliding where no
/// oscillation does.
/// @param lag of the torque behind the angle.
/// @param q_peak_rad from the sweeps, or nullopt: the arm is then assumed to swing about the
/// gravity peak.
Hysteresis identify_hysteresis(const std::vector<const joint::Recording*>& oscillations,
                               const motion::Sweep& sweep, const gravity::CogSweepResult& rough,
                               double gear_ratio,
                               const std::optional<statistics::Estimate>& q_peak_rad,
                               const KnownOfLoops& known = {});

}  // namespace tribolog::method::hysteresis
