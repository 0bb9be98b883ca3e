#pragma once
// The manifest of a dataset: a TOML file that says what was measured, on which joint, and which
// column of which log is what. Nothing in it is guessed.
//
//   schema = "tribolog-dataset-1"
//   [robot]       name; serial, operator, measured_on, note (optional)
//                 description (file of the arm, relative to the manifest; for drawings,
//                 robot_file.h, or with masses, urdf_file.h; optional)
//                 gravity = [0, 0, -9.80665] (in the base's frame; with masses alone; optional)
//   [joint]       name, gear_ratio (motor angle / joint angle)
//   [effort]      kind = "motor_current" | "motor_torque" | "joint_torque" | "target_torque" (of a
//                 controller or its model) | "none" (neither torque nor current was recorded: the
//                 motion alone is checked)
//                 side = "motor" | "joint"; torque_constant_Nm_A (with motor_current only;
//                 "unknown": every torque is then a number of amperes, and doubtful) confirmed =
//                 false (optional; kind and side are a proposal) gravity_removed = true (optional;
//                 the controller has taken gravity off) sign = 1 | -1 (optional; -1: positive
//                 effort moves the joint to negative angles)
//   [payload]     mass_kg, distance_m (from the axis of the joint), note (optional)
//   [temperature] degC (optional)
//   [surrogate]   distance_m = 0.5, gravity_m_s2 = 9.81 (optional)
//   [effects]     sizes of the catalogue's effects (joint/effects.h), as hoses_percent = 0, where
//                 they are not the typical ones (optional)
//   [known_gravity] amplitude_Nm (joint side), q_peak_deg, percent = 10 (half width at 95 %)
//                 (optional; of the joint, as from its design: a candidate beside those identified;
//                 where it contradicts what is found, the torque's scale is in doubt)
//   [[known_load]] amplitude_Nm (joint side), angles (columns of the log); phase_deg = 0,
//                 unit = "rad" of those columns, roles = [...] (all), note (optional; any number):
//                 amplitude cos(sum of the angles + phase) is subtracted when reading
//   [[other_joint]] name, angle = {name, unit}; gear_ratio where its side is "motor" (any number;
//                 of a robot's manifest its other joints): their motion is reported, and with
//                 masses what it changes of gravity is subtracted
//   [columns]     time, angle, effort = {name, unit}; speed, bristle, bristle_rate, temperature
//                 (optional); name = "#2": the second column; unit of the time: "iso8601",
//                 "hh:mm:ss" too; time: plus = {name, unit} where it stands in two columns:
//                 nanoseconds, or the date ("yyyy-mm-dd") of a time of day
//                 rows = {name, value} (optional): of a log in which each row is one joint's those
//                 in which the column has the value
//                 angle and speed: side = "joint" (default) | "motor"
//                 register = "unsigned 16" | "sign bit 15" ... (optional; numbers without their
//                 sign) time, angle, speed: confirmed = false (optional; the unit is a proposal)
//                 time: any_rate = true where under 5 or over 100000 samples a second are right;
//                 time = {rate_Hz}: the log has no clock, its rows come at this rate
//                 the others: file (relative to the manifest) where the column stands in another
//                 file than the recording's, row by row; time = name of the time in that file
//                 (optional; compared, as is a time of the same name)
//                 friction_points: speed, effort; temperature, load (optional; side as an angle),
//                 a row for each point, without time and angle; effort is friction alone
//   [log]         decimal_comma = false; delimiter = "comma" | "semicolon" | "tab" | "spaces"
//                 (found out unless stated); encoding = "utf8" | "latin1"; skip_bad_rows = false
//                 (of text logs; optional)
//   [reference.<law>]  the known friction curve (optional; motor side): the parameters of a static
//                 law ("waiboer", "stribeck", "threshold_speed"), or of a dynamic model, of which
//                 the torque at constant speed is meant
//   [[limit]]     quantity, and of max, min, half_width, half_width_percent one or more: what the
//                 user accepts (manifest_tables.h; optional)
//   [certificate] what a calibration certificate says of laboratory, customer and instruments
//                 (manifest_tables.h; optional)
//   [[recording]] role = "rough_sweep" | "precise_sweep" | "oscillation" | "constant_speed" |
//                 "break_away" | "friction_points", file (relative to the manifest); from_s, to_s
//                 (of a clock that counts from 1970: since its first reading), columns, note
//                 (optional)

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/manifest/manifest_tables.h"
#include "ingest/text/csv_dialect.h"
#include "joint/dataset.h"

namespace tribolog::ingest::manifest {

struct RecordingEntry {
  joint::Role role{};
  std::string file;  ///< As written.
  std::string name;  ///< Of it, without the folders that all recordings share: for people.
  std::optional<double> from_s;
  std::optional<double> to_s;
  /// Time, angle and effort (unless its kind is none) are there; of friction points speed and
  /// effort.
  ColumnEntries columns;
  /// Of a file that stands beside the recording's (companion_columns.h): read behind the columns.
  std::optional<log::WantedColumn> time_to_compare{};
  std::string note;
  Location where;
};

struct ManifestFile {
  joint::Manifest manifest;
  double effort_sign{1.0};
  text::TextLogRules text_logs;
  std::vector<RecordingEntry> recordings;  ///< One or more.
};

inline constexpr std::uint64_t largest_manifest_bytes = 1 << 20;

/// The text of a manifest. @throw InputError as read_file(), or as parse_manifest() for a log, of
/// whatever size.
std::string read_manifest_text(const std::string& path);

/// Of digits and marks alone, as a time is written, but none. What has words in it is a remark.
bool is_impossible_time(const std::string& text);

/// @throw InputError at file:line:column for whatever is missing, unknown, impossible or misspelt.
ManifestFile read_manifest(const std::string& path, const std::string& joint = {});

/// The same from a text. @param file its name, for messages.
/// @param joint whose manifest is meant, in that of a whole robot (robot_joints.h); empty: the
/// manifest is a single joint's.
/// @throw InputError too: the robot has no joint of that name, or there is no name where one is
/// needed.
ManifestFile parse_manifest(std::string_view text, const std::string& file,
                            const std::string& joint = {});

/// The joints of a whole robot's manifest, in their order; none: it is a single joint's.
/// @throw InputError as parse_manifest().
std::vector<std::string> joints_in_manifest(std::string_view text, const std::string& file);

}  // namespace tribolog::ingest::manifest
