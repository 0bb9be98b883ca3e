#pragma once
// What to simulate: one joint, its friction, the experiments, and the noise of its drive.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "friction/friction_model.h"
#include "friction/lugre.h"
#include "joint/gravity_load.h"
#include "simulate/unmodelled_effects.h"

namespace tribolog::simulate {

/// A slow motion at constant speed from one angle to another, with smooth starts and stops.
struct SweepExperiment {
  double from_rad{};
  double to_rad{};                  ///< != from_rad
  double speed_rad_s{};             ///< > 0, joint side
  bool both_directions{true};       ///< There and back; false: there only.
  double acceleration_rad_s2{1.0};  ///< > 0, largest of the smooth ramps, joint side.
  double sample_rate_Hz{1000.0};
};

/// A slow sine as a sweep: q = centre - amplitude cos(2 pi f t), from rest at its lowest angle.
struct SineSweepExperiment {
  double centre_rad{};
  double amplitude_rad{};  ///< > 0, joint side
  double frequency_Hz{};   ///< > 0
  double cycles{};         ///< >= 1
  double sample_rate_Hz{1000.0};
};

/// q = centre + amplitude sin(2 pi f t), from an unloaded contact at t = 0.
struct OscillationExperiment {
  double centre_rad{};
  double amplitude_rad{};  ///< > 0, joint side
  double frequency_Hz{};   ///< > 0
  double cycles{};         ///< >= 1
  double sample_rate_Hz{1000.0};
  bool record_bristle{true};  ///< Write z and dz/dt of LuGre, which no real drive can.
};

/// The same oscillation at `positions` places, evenly spread over one turn of the motor about its
/// centre: torque ripple of 1 to positions - 1 periods a turn then averages out.
std::vector<OscillationExperiment> spread_over_motor_turn(const OscillationExperiment& oscillation,
                                                          std::size_t positions, double gear_ratio);

/// One recording per speed, each with one plateau in each direction.
struct ConstantSpeedExperiment {
  std::vector<double> motor_speeds_rad_s;  ///< > 0 each
  bool both_directions{true};
  double centre_rad{};           ///< Middle of the travel, joint side.
  double largest_travel_rad{};   ///< > 0: bound of a plateau's travel, joint side.
  double longest_plateau_s{};    ///< > 0: bound of a plateau's duration.
  double acceleration_rad_s2{};  ///< > 0, joint side
  double sample_rate_Hz{1000.0};
};

/// From rest, the torque rising at a steady rate until the joint slides.
struct BreakAwayExperiment {
  double centre_rad{};             ///< Where it starts.
  double rate_Nm_s{};              ///< > 0, motor side.
  double largest_torque_Nm{};      ///< > 0: largest change of the torque, motor side.
  double largest_travel_rad{0.1};  ///< > 0: the ramp ends there, joint side.
  std::size_t repeats{5};          ///< Ramps in each direction.
  bool both_directions{true};
  double sample_rate_Hz{1000.0};
};

/// What a real drive adds to its log; all zero: an ideal one.
struct Noise {
  double torque_white_Nm{};          ///< Standard deviation, motor side.
  double torque_step_Nm{};           ///< Quantisation of the torque; 0: none.
  double encoder_counts_per_turn{};  ///< Of the motor encoder; 0: continuous.
  double encoder_phase{};  ///< Share of a step by which its steps are off the angle's zero, 0 to 1.
  double speed_filter_Hz{};  ///< First-order low pass on the difference of the angle; 0: the
                             ///< true speed is logged.
  struct Ripple {
    double amplitude_Nm{};
    double periods_per_turn{};  ///< Of the motor shaft.
    double phase_rad{};
  };
  std::vector<Ripple> ripple;  ///< Torque periodic in the motor's angle.
  double clock_jitter_s{};  ///< Standard deviation of a time stamp about its tick; two stamps never
                            ///< change places.
  double lost_percent{};    ///< Of the samples: each is missing by chance, < 100.
  LogEffects effects;       ///< What else a log can have, besides noise.
  std::uint64_t seed{1};
};

/// What a controller writes into its log.
struct LogForm {
  bool keeps_friction_secret{};           ///< The manifest states no friction as known.
  double torque_constant_Nm_A{};          ///< > 0: the motor's current instead of its torque.
  std::optional<std::uint64_t> decimals;  ///< Of every number; none: all that it has.
};

struct Scenario {
  std::string name;
  std::string robot;
  std::string serial;
  std::string robot_description;       ///< File that the scenario names; empty: none.
  std::string robot_description_text;  ///< What it holds, where the scenario was read from a file.
  std::string joint;
  double gear_ratio{1.0};       ///< n > 0
  double motor_inertia_kgm2{};  ///< J of motor and gear, at the motor shaft, >= 0.
  double arm_inertia_kgm2{};    ///< I about the joint's axis, >= 0.
  joint::GravityLoad load{1.0, 1.0, 0.0};
  JointEffects effects;  ///< What the model of the method does not know.
  /// Drives the oscillation; one of dynamic_friction_models(), never null. Only LuGre records its
  /// bristle: the others have none that would compare.
  std::shared_ptr<const friction::DynamicFriction> presliding =
      std::make_shared<friction::LuGreFriction>(
          friction::LuGreFriction::Parameters{1.0, 0.0, 0.0, 1.0, 1.0, 1.0});
  /// Drives sweeps and runs; null: the model above does, unloaded at the start of each recording.
  std::shared_ptr<const friction::StaticFriction> sliding;
  double surrogate_distance_m{0.5};
  std::optional<SweepExperiment> rough_sweep;
  std::optional<SweepExperiment> precise_sweep;
  std::optional<SineSweepExperiment> sine_sweep;
  std::optional<OscillationExperiment> oscillation;  ///< The paper's: its start-up stroke is read.
  /// The same at other positions, amplitudes or frequencies; only beside `oscillation`.
  std::vector<OscillationExperiment> further_oscillations;
  std::optional<ConstantSpeedExperiment> constant_speed;
  std::optional<BreakAwayExperiment> break_away;
  Noise noise;
  LogForm log;

  /// The model that drives sweeps and runs.
  [[nodiscard]] const friction::FrictionModel& sliding_model() const;
  /// Its torque at constant speed: what an identification should find. Null where that depends on
  /// more than the speed (FrictionTraits::remembers_rest), and where it is kept secret.
  [[nodiscard]] std::shared_ptr<const friction::StaticFriction> known_curve() const;
};

}  // namespace tribolog::simulate
