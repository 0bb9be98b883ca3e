#pragma once
// Meanings of columns that their names do not tell, by their numbers.

#include <optional>
#include <string>
#include <vector>

#include "ingest/layout/log_layout.h"
#include "ingest/log/log_table.h"

namespace tribolog::inspect::survey {

struct GuessedMeaning {
  ingest::layout::ColumnMeaning meaning;
  std::string reason;  ///< "its slope is column '#3'"
};

/// Columns without names that come in groups, in each one for each joint: the angles, then the
/// speeds, then others.
struct ColumnGroups {
  std::size_t first{};   ///< Column of the first joint's angle.
  std::size_t joints{};  ///< Columns in a group, two or more.

  /// "1" for the first joint.
  [[nodiscard]] std::string joint_of(std::size_t column) const;
};

struct GuessedLayout {
  std::vector<GuessedMeaning> meanings;
  std::optional<ColumnGroups> groups;
};

/// Only what the layout lacks: a clock is the first column that rises all the way and is no
/// counter; where no angle is known, it is a column whose slope over the clock another column
/// holds, which is the speed. Of columns without names the distance between the two tells the
/// groups, where the rest can be cut into such. Of what is left nothing tells which one is an
/// effort.
GuessedLayout guess_by_numbers(const ingest::log::LogTable& table,
                               const ingest::layout::LogLayout& layout);

/// In columns that come in groups, the first behind angles and speeds that may be the efforts: it
/// changes and is neither a set point of angle or speed nor an acceleration, as the joint with the
/// widest motion shows.
/// @return the column of its first joint; nothing where there is none.
std::optional<std::size_t> first_effort_by_place(const ingest::log::LogTable& table,
                                                 std::size_t clock, const ColumnGroups& groups);

/// Whole numbers that rise by one nearly always: they count rows, or are the milliseconds of a
/// clock, and which of the two they do not tell.
bool looks_like_counter(const std::vector<double>& values);

/// Speed over the slope of an angle, where they go together: 1 in the same units, pi/180 for a
/// speed in rad/s of an angle in degrees; negative where the speed counts the other way. Nothing
/// where they do not, or either stands still.
/// @param t_s the clock, of the length of `angle` and `speed`.
std::optional<double> speed_by_slope(const std::vector<double>& t_s,
                                     const std::vector<double>& angle,
                                     const std::vector<double>& speed);

/// Whether angles without a stated unit are degrees: no joint turns by thirty radians.
/// @param gear_ratio of angles on the motor's side; 1: they are the joint's.
bool looks_like_degrees(const std::vector<double>& angles, double gear_ratio = 1);

}  // namespace tribolog::inspect::survey
