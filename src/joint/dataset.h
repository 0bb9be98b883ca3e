#pragma once
// What the user accepts: limits of identified quantities, as the manifest states them.

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "joint/certificate.h"
#include "joint/drive.h"
#include "joint/effects.h"
#include "joint/gravity_load.h"
#include "joint/other_joints.h"
#include "joint/quantity.h"
#include "joint/recording.h"

namespace tribolog::friction {
class StaticFriction;
}
namespace tribolog::robot {
struct RobotDescription;
}
namespace tribolog::joint {

/// One `[[limit]]` of the manifest. At least one of the four is set.
struct AcceptanceLimit {
  std::string quantity;       ///< A key of limited_quantities().
  std::optional<double> min;  ///< In the unit that the key names, as all but the last.
  std::optional<double> max;
  std::optional<double> half_width;          ///< Largest half width of the 95 % interval.
  std::optional<double> half_width_percent;  ///< The same, of the estimate.
};

/// A quantity on a side of the gear and in a unit, of which a limit may speak.
struct LimitedQuantity {
  std::string key;  ///< "coulomb_joint_Nm"
  Quantity quantity{};
  std::string unit;      ///< "N·m"
  double factor{1.0};    ///< From SI to the unit.
  int gear_power{0};     ///< From the motor's side: times gear ratio to this power.
  bool at_joint{false};  ///< As its key says.
};

const std::vector<LimitedQuantity>& limited_quantities();
/// nullptr if there is none of this key.
const LimitedQuantity* find_limited_quantity(const std::string& key);

// A dataset: the manifest's facts about one joint, and its recordings.

// What a logger is known to write into the column that a manifest takes for the effort.

struct LoggedEffort {
  std::string logger;              ///< "UR RTDE"
  std::string column;              ///< "target_moment_0"
  std::optional<EffortKind> kind;  ///< Absent: the logger writes one or the other.
  std::optional<Side> side;
  bool is_target{};       ///< A set point or a model's value: no measurement.
  bool is_behind_gear{};  ///< Of a sensor that most of the gear's friction does not pass.
};

/// An input file as it was read; goes into the provenance.
struct InputFile {
  std::string name;  ///< As written in the manifest (no directory of the machine).
  std::string role;  ///< "manifest", "manifest of joint J1", "robot", a Role.
  std::uint64_t bytes{};
  std::string sha256;  ///< 64 hex digits.
  std::size_t rows_read{};
  std::size_t rows_used{};
  std::vector<SkippedRows> skipped;
  std::vector<ColumnConversion> conversions;  ///< As applied to a recording; of its own file alone.
  std::optional<LoggedEffort> logged_effort;  ///< Of a log whose logger is known.
};

/// What the user knows of the errors that no recording shows (type B, JCGM 100, 4.3): half widths
/// at 95 %. What is not stated is not included.
struct StatedUncertainty {
  std::optional<double> torque_constant_percent;  ///< Or of the torque sensor's scale.
  std::optional<double> gear_ratio_percent;       ///< Of a belt, say; teeth are counted.
  std::optional<double> surrogate_distance_percent;
  std::optional<double> gravity_percent;  ///< Of the acceleration of gravity.
  std::optional<double> angle_zero_deg;   ///< Of the joint angle's zero.
  /// What an error comes from, by their keys without the unit: two calibrations that state
  /// the same share the error, and it cancels in their comparison.
  std::map<std::string, std::string> id;
  /// Of the masses in a description of the arm: where there is one, it is never absent.
  std::optional<double> description_percent{};
  /// Torque of hoses and cables: by how much it changes over one radian, in percent of the gravity
  /// torque. Over part of a turn it looks like gravity.
  std::optional<double> hoses_percent{};

  bool operator==(const StatedUncertainty&) const = default;
};

/// What the user states about the measurement. Texts may be empty where not stated.
/// Names in a manifest that was proposed for a log, for which nobody stated one.
inline constexpr const char* unnamed_robot = "unnamed robot";
inline constexpr const char* unnamed_joint = "joint";

struct Manifest {
  std::string robot;
  std::string serial;
  std::string joint;
  std::string robot_description;  ///< For drawings: file, relative to the manifest; empty: none.
  std::string operator_name;
  std::string measured_on;  ///< Free text or ISO date, as given.
  std::string note;
  Certificate certificate{};
  Drive drive{1.0, EffortKind::motor_torque, Side::motor};
  /// false: kind and side of the effort were proposed from the log's columns (`tribolog init`), and
  /// nobody confirmed them.
  bool effort_is_confirmed{true};
  /// A current whose torque constant is not known: its numbers stand for torques.
  bool torque_is_in_amperes{};
  [[nodiscard]] TorqueUnit torque_unit() const {
    return torque_is_in_amperes ? TorqueUnit::ampere : TorqueUnit::newton_metre;
  }
  /// The effort is what is left of the torque after the controller has taken gravity off: gravity
  /// is not looked for in it (known_gravity is 0).
  bool gravity_is_removed{};
  std::string payload;  ///< Words.
  std::optional<double> payload_kg;
  std::optional<double> payload_distance_m;  ///< Of its centre of gravity from the joint's axis.
  std::optional<double> temperature_C;
  double surrogate_distance_m{0.5};  ///< r_REPL, freely chosen.
  double gravity_m_s2{9.81};
  /// Speeds of the joint, rising, at which friction is to be stated; empty: a few of those
  /// measured.
  std::vector<double> friction_at_rad_s{};
  StatedUncertainty uncertainty;
  EffectSizes effects{};
  std::optional<std::uint64_t> seed;           ///< Of everything random.
  std::vector<KnownLoad> known_loads;          ///< Subtracted when the logs were read.
  std::optional<StatedGravity> known_gravity;  ///< Of the joint itself; nothing is decided by it.
  std::vector<OtherJoint> other_joints{};      ///< Whose angles were looked for in the logs.
  std::optional<ArmGravity> arm_gravity{};     ///< Of a description with masses.
  std::shared_ptr<const friction::StaticFriction>
      reference;                        ///< Known curve (simulation), motor side.
  std::vector<AcceptanceLimit> limits;  ///< What the user accepts; may be empty.
};

struct Dataset {
  Manifest manifest;
  std::vector<Recording> recordings;  ///< In the manifest's order.
  std::vector<FrictionPoints> friction_points;
  std::vector<InputFile> inputs;  ///< The manifest, the robot's description, the logs.
  std::vector<Statement> notes;   ///< What the reader noticed and the user should know.
  std::shared_ptr<const robot::RobotDescription>
      robot;  ///< For drawings; null where none is stated.

  [[nodiscard]] std::vector<const Recording*> with_role(Role role) const;
};

// The conversions of all logs of a dataset, each stated once.

/// A conversion with the logs whose columns it was applied to.
struct SharedConversion {
  ColumnConversion conversion;
  std::vector<std::string> files;  ///< In the manifest's order, each once.
  bool is_of_all{};                ///< Every log that was read has it.
};

/// By signal, and where logs differ in the order in which they come.
std::vector<SharedConversion> shared_conversions(const std::vector<InputFile>& inputs);

}  // namespace tribolog::joint
