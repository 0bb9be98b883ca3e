#pragma once
// What the user says of a log's columns where their names do not tell it, or tell it wrongly.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ingest/layout/log_layout.h"
#include "ingest/log/log_table.h"

namespace tribolog::inspect::survey {

struct StatedColumns {
  /// "time", "angle", "speed", "effort" or "temperature", and the column's name: with or without
  /// its unit, or "#3" for the third one. With an angle the log's other angles do not count.
  std::vector<std::pair<std::string, std::string>> names;
  std::optional<std::string> angle_unit;   ///< Of all angles: "rad", "deg".
  std::optional<std::string> effort_unit;  ///< Of all efforts: "Nm", "0.0013 Nm", "mA".
  std::optional<double> rate_Hz;     ///< The logs have no clock: their rows come at this rate.
  std::optional<double> gear_ratio;  ///< Of all joints: of angles on the motor's side.
  std::map<std::string, double> gear_ratio_of;  ///< Of single joints, instead.

  [[nodiscard]] std::optional<double> gear_ratio_for(const std::string& joint) const {
    const auto own = gear_ratio_of.find(joint);
    return own == gear_ratio_of.end() ? gear_ratio : std::optional(own->second);
  }
};

/// @return the unit. @throw UsageError: it is none of a torque or a current.
std::string parse_effort_unit(const std::string& text);

/// Splits "angle=q_3". @throw UsageError for another key, or no name.
std::pair<std::string, std::string> parse_stated_column(const std::string& text);

/// Puts what is stated in the place of what the names say.
/// @return the stated names of which there is no column.
std::vector<std::string> put_stated(const StatedColumns& stated,
                                    const std::vector<ingest::log::ColumnHeader>& header,
                                    ingest::layout::LogLayout& layout);

}  // namespace tribolog::inspect::survey
