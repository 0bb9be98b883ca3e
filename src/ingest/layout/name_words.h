#pragma once
// The meaning of a column by its name.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/layout/log_layout.h"

namespace tribolog::ingest::layout {

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

/// The quantity is that of the first word that names one and does not contradict the unit; of a
/// name without such a word that of the unit alone. "target", "goal", "cmd" and the like make it a
/// set point; "error", "enable", "limit" and the like make it none of these. What other words there
/// are name the joint, and of them the number alone if there is one; words such as "actual",
/// "motor" and "joint" do not.
/// @param unit of the header, or behind the name's last underscore; empty: none.
std::optional<ColumnMeaning> meaning_by_words(std::string_view name, std::string_view unit);

}  // namespace tribolog::ingest::layout
