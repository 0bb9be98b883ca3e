#pragma once
// The manifest of a dataset: a TOML file that says what was measured, on which joint, and which
// column of which log is what. Nothing in it is guessed.
//
//   schema = "tribolog-dataset-1"
//   [robot]       name; serial, operator, measured_on, note (optional)
//                 description (file of the arm, relative to the manifest; robot_file.h; optional)
//   [joint]       name, gear_ratio (motor angle / joint angle)
//   [effort]      kind = "motor_current" | "motor_torque" | "joint_torque"
//                 side = "motor" | "joint"; torque_constant_Nm_A (with motor_current only)
//                 sign = 1 | -1 (optional; -1: positive effort moves the joint to negative angles)
//   [payload]     mass_kg, note (optional)
//   [temperature] degC (optional)
//   [surrogate]   distance_m = 0.5, gravity_m_s2 = 9.81 (optional)
//   [columns]     time, angle, effort = {name, unit}; speed, bristle, bristle_rate (optional);
//                 angle and speed: side = "joint" (default) | "motor"
//   [reference.<law>]  the known friction curve (optional; motor side): the parameters of a static
//                 law ("waiboer", "stribeck", "threshold_speed"), or of a dynamic model, of which
//                 the torque at constant speed is meant
//   [[recording]] role = "rough_sweep" | "precise_sweep" | "oscillation" | "constant_speed" |
//                 "break_away", file (relative to the manifest); from_s, to_s, columns, note
//                 (optional)

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/manifest_columns.h"
#include "joint/dataset.h"

namespace tribolog {

struct RecordingEntry {
  Role role{};
  std::string file;  ///< As written.
  std::optional<double> from_s;
  std::optional<double> to_s;
  ColumnEntries columns;  ///< Time, angle and effort are there.
  std::string note;
  Location where;
};

struct ManifestFile {
  Manifest manifest;
  double effort_sign{1.0};
  std::vector<RecordingEntry> recordings;  ///< One or more.
};

inline constexpr std::uint64_t largest_manifest_bytes = 1 << 20;

/// @throw InputError at file:line:column for whatever is missing, unknown, impossible or misspelt.
ManifestFile read_manifest(const std::string& path);

/// The same from a text. @param file its name, for messages.
ManifestFile parse_manifest(std::string_view text, const std::string& file);

}  // namespace tribolog
