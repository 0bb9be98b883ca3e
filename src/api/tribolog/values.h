#pragma once
// The values that make up a dataset and a calibration: plain data, owned by their holder.
//
// Numbers are SI. Torques and friction speeds are at the motor unless a name says joint; angles are
// at the joint.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tribolog/export.h"

namespace tribolog {

/// A statement, as a code for programs and in words for people.
struct Message {
  std::string code;   ///< Stable: "gravity.one_direction"; empty if an older file has none.
  std::string words;  ///< In the requested language; empty: there is nothing to say.
};

/// An estimate with its interval: low <= value <= high.
struct Estimate {
  double value{};
  double low{};
  double high{};
  double coverage{0.95};  ///< Share of experiments in which the interval contains the true value.
};

/// How far a result can be relied on, from best to worst.
enum class Verdict { usable, doubtful, not_identifiable };

/// "usable", "doubtful" or "not_identifiable", as files have it.
TRIBOLOG_EXPORT std::string code_of(Verdict verdict);

/// A result, with its own verdict.
struct Quantity {
  std::string name;   ///< Stable: "coulomb_torque".
  std::string words;  ///< "Coulomb torque", in the requested language.
  std::string unit;   ///< "N·m"; empty for a curve. The same on both sides of the gear.
  /// At the motor; at the joint for what exists only there (angle of the centre of gravity,
  /// surrogate mass). Absent for a curve, and if it was not found.
  std::optional<Estimate> estimate;
  /// The same at the joint: torque times the gear ratio, speed divided by it, coefficients of
  /// torque per speed, angle or acceleration times its square.
  std::optional<Estimate> at_joint;
  Verdict verdict{Verdict::not_identifiable};
  bool decides{};                ///< Counts towards the overall verdict.
  std::vector<Message> reasons;  ///< Most important first; empty only if it is usable.
  Message experiment;            ///< What to record next; empty only if it is usable.
};

/// Friction torque at a speed, the mean of both directions, in N·m, or in A where the joint's
/// torque_is_in_amperes; with its own verdict.
struct FrictionAtSpeed {
  double speed_rad_s{};           ///< Of the motor.
  Estimate torque;                ///< At the motor.
  double speed_at_joint_rad_s{};  ///< The same divided by the gear ratio's size.
  Estimate torque_at_joint;       ///< The same times the gear ratio's size.
  Verdict verdict{Verdict::not_identifiable};
  Message reason;    ///< Empty only if it is usable.
  bool is_stated{};  ///< The manifest asks for this speed.
  /// While the joint's angle rises and while it falls, both at the motor: what the drive gives
  /// beside gravity, friction with the torque's offset, which no motion tells from friction that
  /// differs. Absent: of a file that an older program wrote.
  std::optional<Estimate> forward;
  std::optional<Estimate> backward;
};

/// A check on the recordings, before anything is identified.
struct Check {
  enum class State { passed, warns, fails, not_applicable };
  std::string name;  ///< Stable: "speed_scale".
  std::string words;
  State state{State::not_applicable};
  std::string recording;           ///< The one the number comes from; empty: none, or all.
  std::optional<double> measured;  ///< In `unit`, like the limits for passing.
  std::optional<double> at_least;
  std::optional<double> at_most;
  std::string unit;  ///< "1" for a pure number.
  Message found;
  Message consequence;  ///< For the results; empty if it passed.
  Message experiment;   ///< What to record instead; empty if it passed.
};

/// How far a step of the method came.
struct Stage {
  enum class State { done, partial, not_identifiable, skipped };
  std::string name;  ///< Stable: "surrogate_masses".
  State state{State::skipped};
  Message reason;  ///< Empty only if it is done.
};

/// Rows of a log that were not used.
struct SkippedRows {
  Message reason;
  std::size_t rows{};
};

/// A file that went into the numbers.
struct InputFile {
  std::string name;  ///< As in the manifest, without machine-specific directories.
  std::string role;  ///< "manifest", "robot", or the recording's: "rough_sweep".
  std::uint64_t bytes{};
  std::string sha256;  ///< 64 hexadecimal digits.
  std::size_t rows_read{};
  std::size_t rows_used{};
  std::vector<SkippedRows> skipped;
  /// A recording's own log; not the manifest, nor a file with further columns of such a log.
  bool is_recording{};
};

/// The joint measured, as stated in the manifest; empty or absent if not stated.
struct Joint {
  std::string robot;
  std::string serial;
  std::string joint;
  std::string measured_on;  ///< Free text, or an ISO date.
  std::string operator_name;
  std::string note;
  std::string payload;
  std::optional<double> payload_kg;
  std::optional<double> payload_distance_m;  ///< Of its centre of gravity from the joint axis.
  std::optional<double> temperature_C;
  double gear_ratio{1};  ///< Motor angle / joint angle; may be negative.
  /// The torque constant is not known: what is called a torque is a current, in A.
  bool torque_is_in_amperes{};
};

/// Called in the caller's thread with the next step, in English, and the steps (done, all). Must
/// not throw.
using Progress = std::function<void(const std::string& what, std::size_t done, std::size_t all)>;

/// Codes of the available languages, English first: "en", "pl".
TRIBOLOG_EXPORT std::vector<std::string> languages();

/// "0.2.0": the version of the running library.
TRIBOLOG_EXPORT std::string version();

}  // namespace tribolog
