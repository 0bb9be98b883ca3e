#pragma once
// Tables of a manifest: which column of a log is what, known loads, limits, and how its logs are to
// be read.

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "ingest/log/log_table.h"
#include "ingest/log/register.h"
#include "ingest/log/units.h"
#include "ingest/manifest/toml_table.h"
#include "ingest/text/csv_dialect.h"
#include "joint/certificate.h"
#include "joint/dataset.h"
#include "joint/drive.h"
#include "joint/gravity_load.h"

namespace tribolog::ingest::manifest {

// The `columns` table.

/// @throw InputError if the table's `kind` is a voltage or a duty cycle.
void refuse_voltage_kind(const TomlTable& effort);

/// @throw InputError if the column's `unit` is one of voltage or duty cycle.
void refuse_voltage_unit(const TomlTable& column);

/// The second column of a clock that stands in two.
struct ClockPart {
  std::string name;
  log::ColumnReading reading{log::ColumnReading::number};
  double si_factor{1.0};
};

/// Of a log in which each row is one joint's: which rows.
struct RowsEntry {
  std::string name;   ///< Of the column that tells whose they are.
  std::string value;  ///< As it stands there.
  Location where;
};

struct ColumnEntry {
  std::string name;
  std::string unit;
  log::Quantity quantity{};
  double si_factor{1.0};  ///< Negative: the column counts the other way round (`sign = -1`).
  joint::Side side{
      joint::Side::joint};  ///< Of angle, speed and load; bristles are always on the motor side.
  Location where;
  log::ColumnReading reading{log::ColumnReading::number};
  /// In which the column stands, relative to the manifest; empty: the recording's.
  std::string file{};
  std::string time_in_file{};  ///< Name of the time there; empty: the recording's, if it is there.
  bool any_rate{};             ///< Of the time: so stated, however many samples a second it makes.
  /// Of the time: the log has no clock, its rows come at this rate.
  std::optional<double> rate_Hz{};
  std::optional<ClockPart> plus{};             ///< Of the time: is added to it.
  std::optional<log::Register> of_register{};  ///< Its numbers lack their sign.
  bool is_proposed{};  ///< `confirmed = false`: the unit is proposed, not stated.
};

struct ColumnEntries {
  std::optional<ColumnEntry> time;
  std::optional<ColumnEntry> angle;
  std::optional<ColumnEntry> speed;
  std::optional<ColumnEntry> effort;
  std::optional<ColumnEntry> bristle;
  std::optional<ColumnEntry> bristle_rate;
  std::optional<ColumnEntry> temperature;
  std::optional<ColumnEntry> load;  ///< Of friction points: torque that loads the gear.
  std::optional<RowsEntry> rows;    ///< Absent: all.
};

/// Reads a `columns` table; what it does not mention is taken from `otherwise`.
/// @param effort_kind decides whether the effort is a current or a torque; with EffortKind::none an
///        effort is refused.
/// @throw InputError for an unknown unit, an unknown key, or a unit that contradicts the kind; for
///        an effort in volt or per cent of the duty cycle, which no torque follows from; for a file
///        of the time.
ColumnEntries read_columns(const TomlTable& table, joint::EffortKind effort_kind,
                           const ColumnEntries& otherwise);

// Known loads.

/// All tables [[known_load]]; none: empty.
/// @throw InputError for a missing, unknown or impossible key, or a role that does not exist.
std::vector<joint::KnownLoad> read_known_loads(const TomlTable& top);

/// @throw InputError for a missing, unknown or impossible key.
std::optional<joint::StatedGravity> read_known_gravity(const TomlTable& top);

// The robot's other joints, whose motion changes what gravity does to the tested one:
//
//   [[other_joint]]                                # of a single joint's manifest; those of a robot
//   name = "J2"                                    # are its [[joints]]
//   angle = { name = "q2_rad", unit = "rad" }      # side = "motor" with gear_ratio; sign = -1

/// All tables [[other_joint]]; none: empty. @param file of the manifest, for messages.
/// @throw InputError for a missing, unknown or impossible key, or a name that stands twice.
std::vector<joint::OtherJoint> read_other_joints(const TomlTable& top, const std::string& file);

/// What [robot] and [uncertainty] say of a description with masses (URDF): `gravity`, of the base's
/// frame, and `description_percent`; absent where the description is none.
/// @throw InputError for a gravity without direction or of another planet, and where the keys stand
///        without such a description.
std::optional<joint::ArmGravity> read_arm_gravity(const TomlTable& robot,
                                                  const std::string& description);

// The acceptance limits of a manifest:
//
//   [[limit]]
//   quantity = "coulomb_joint_Nm"    # one of limited_quantities(), the unit in its name
//   max = 15.0                       # of these four one or more
//   min = 5.0
//   half_width = 0.5                 # largest half width of the 95 % interval
//   half_width_percent = 5           # the same, of the estimate

/// @throw InputError for an unknown quantity (with the closest known one), a limit without a
///        number, min above max, or a width that is not positive.
std::vector<joint::AcceptanceLimit> read_limits(const TomlTable& manifest);

/// Numbers of amperes cannot be held against what is stated in N·m, or follows from masses.
/// @throw InputError: torques are in amperes, and some of it is stated.
void refuse_torques_beside_amperes(const TomlTable& effort, const joint::Manifest& manifest);

// Texts of several tables.

/// The key `name`. @throw InputError if it is missing or blank, with the hint.
std::string required_name(const TomlTable& table, const std::string& hint);

/// A date as ISO 8601, or words; empty: not stated. @throw InputError for a time that there is not.
std::string read_date(const TomlTable& table, const std::string& key);

// The [certificate] table of a manifest: what a calibration certificate says beside the results.
//
//   [certificate]
//   number, replaces, laboratory, laboratory_address, country ("DE"), customer, customer_address,
//   place, received_on, procedure, conditions, humidity_percent, adjustment, decision_rule,
//   responsible
//   [[certificate.instrument]]
//   name, identification, traceability, used_for

/// @throw InputError for an unknown key, another type, an instrument without a name, a country that
///        is no code, a humidity beyond 100 %, a time that there is not.
joint::Certificate read_certificate(const TomlTable& top);

// The [log] table of a manifest.

/// [log] decimal_comma = false, delimiter = "comma" | "semicolon" | "tab" | "spaces",
///       encoding = "utf8" | "latin1", header_line = 7, skip_bad_rows = false.
/// @throw InputError for an unknown key, or commas for both.
text::TextLogRules read_text_log_rules(const TomlTable& log);

}  // namespace tribolog::ingest::manifest
