#pragma once
// What the names of a log's columns say of them. A guess, for `inspect` to propose and for the user
// to confirm: nothing here enters a recording unasked.
//
// Loggers that are known by their columns: UR's RTDE client, libfranka's logToCSV, KUKA's FRI and
// RSI, ABB's EGM, FloBaRoID, figaroh, joint states of ROS, LeRobot. Other logs are read word by
// word: "q_deg", "tau [Nm]".

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/log/log_table.h"
#include "ingest/log/units.h"
#include "joint/dataset.h"
#include "joint/drive.h"

namespace tribolog::ingest::layout {

/// What a torque or a current is, as far as the logger is known.
struct EffortMeaning {
  std::optional<joint::EffortKind> kind;  ///< Absent: the logger writes one or the other.
  std::optional<joint::Side> side;
  std::string remark;  ///< What the user has to know; empty if nothing.
  /// Loggers write a current under this name too: the unit is the one that it has as a torque.
  bool may_be_current{};
  bool is_without_gravity{};  ///< The controller has taken gravity off.
};

/// One column's meaning.
struct ColumnMeaning {
  std::size_t column{};  ///< Index in the header.
  log::Quantity quantity{};
  std::string joint;      ///< "0", "elbow"; empty: the name has none.
  std::string unit;       ///< Of the header, or else of the logger, or else the SI one.
  bool unit_is_stated{};  ///< By the header or by the logger.
  bool unit_is_usual{};   ///< Not stated: the one that the logger writes mostly.
  /// Not stated: what is written, "Grad", stands for this unit or for another one.
  bool unit_is_ambiguous{};
  /// A set point or a model's value: no measurement.
  bool is_target{};
  /// The user states the column, and nothing says of which joint it is: of any.
  bool is_of_any_joint{};
  bool is_at_motor{};    ///< As the logger has it.
  EffortMeaning effort;  ///< Of a torque or a current.
};

/// A column whose name states its quantity, in a unit that is not known: an encoder's counts, per
/// cent of a rated value.
struct ForeignUnit {
  std::size_t column{};
  log::Quantity quantity{};
  std::string joint{};
};

struct LogLayout {
  std::string logger;                  ///< "UR RTDE"; empty: none that is known.
  std::vector<ColumnMeaning> columns;  ///< Those whose meaning can be guessed, in their order.
  std::vector<ForeignUnit> foreign;    ///< None of these is among them.

  /// The first measured one of this quantity and joint; null: none.
  [[nodiscard]] const ColumnMeaning* find(log::Quantity quantity, const std::string& joint) const;
  /// Joints that have an angle, in their order; {""} for names without one.
  [[nodiscard]] std::vector<std::string> joints() const;
};

/// Columns called after joints alone, "J1" and "Joint 2", are angles where no others are, as in
/// what ABB's and FANUC's robots log.
/// @param header of all columns.
LogLayout guess_layout(const std::vector<log::ColumnHeader>& header);

/// "Grad" is German for degrees and elsewhere a 400th of a turn: such a unit is taken as degrees,
/// and not as stated.
void doubt_ambiguous_unit(ColumnMeaning& meaning);

// Loggers that are known by the names of their columns, and what they write into them.

struct KnownColumn {
  std::string_view pattern;  ///< See joint_in_name().
  log::Quantity quantity{};
  std::string_view unit;
  bool is_target{};
  std::optional<joint::EffortKind> kind{};
  std::optional<joint::Side> side{};
  std::string_view remark{};
  bool is_behind_gear{};      ///< Of a sensor that most of the gear's friction does not pass.
  bool is_without_gravity{};  ///< The controller has taken gravity off.
  bool is_usual{};            ///< The unit: the logger writes others too.
};

struct KnownLogger {
  std::string_view name;
  std::string_view named_by;  ///< A column that no other logger has; a pattern.
  std::span<const KnownColumn> columns;
};

/// The more particular ones first.
std::span<const KnownLogger> known_loggers();

/// Columns that are known whatever else a log holds; one without a unit is logged in several.
std::span<const KnownColumn> known_names();

/// Those of these columns that may hold a torque or a current: known to be one, in whatever unit,
/// or called so, as "load" is.
std::vector<std::string> possible_efforts(const std::vector<log::ColumnHeader>& header);

/// Whether a column is a share of a rated value though its name does not say so: "$CURR_ACT[1]".
bool is_share_by_name(const std::string& name);

// What a known logger writes into one column, recognised by the names that a manifest states.

/// @param angle_column name of the joint's angle: it distinguishes loggers that share a name, and
/// has
///        to be of the same joint.
/// @return nothing where no logger that is known has both columns.
std::optional<joint::LoggedEffort> known_effort(const std::string& angle_column,
                                                const std::string& effort_column);

// The meaning of a column by its name.

/// A word that names a quantity.
struct QuantityWord {
  std::string_view word;
  log::Quantity quantity;
};

/// @param pattern with one "{}" for the joint, or none. Case does not count.
/// @return what stands for the joint (empty for a pattern without one), or nothing where the name
/// does not fit.
std::optional<std::string> joint_in_name(std::string_view name, std::string_view pattern);

// The meaning of a column by the words of its name, in any order: "i_motor_A", "elbow_position",
// "J2 Torque [Nm]", "motorCurrent", "Strom (mA)".

/// "actualJointPos_2" is actual, joint, pos, 2: cut at signs, at capitals and between letters and
/// digits; in small letters.
std::vector<std::string> words_of_name(std::string_view name);

/// "torque_percent", "pos_inc": a share of a rated value, or counts; in no unit that is known.
bool says_foreign_unit(std::string_view name);

/// "torque_enable", "position_error": none of the signals that are looked for.
bool says_other_signal(std::string_view name);

/// The quantity is that of the first word that names one and does not contradict the unit; of a
/// name without such a word that of the unit alone. "target", "goal", "cmd" and the like make it a
/// set point, "external" what is no measurement of the drive either; "error", "enable", "limit" and
/// the like make it none of these. What other words there are name the joint, and of them the
/// number alone if there is one; words such as "actual", "motor" and "joint" do not.
/// @param unit of the header, or behind the name's last underscore; empty: none.
std::optional<ColumnMeaning> meaning_by_words(std::string_view name, std::string_view unit);

}  // namespace tribolog::ingest::layout
