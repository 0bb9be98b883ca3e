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
  std::optional<std::string> time_unit;    ///< Of the clock: "ms", "0.5 ms".
  std::optional<std::string> angle_unit;   ///< Of all angles: "rad", "deg", "0.088 deg".
  std::optional<std::string> speed_unit;   ///< Of all speeds: "rpm".
  std::optional<std::string> effort_unit;  ///< Of all efforts: "Nm", "0.0013 Nm", "mA".
  /// A torque or a current is said to be there, whatever column it is: of a joint with both, the
  /// current.
  std::optional<ingest::log::Quantity> effort_is;
  std::optional<joint::Side> angle_side;  ///< Of all angles and speeds.
  std::optional<double> rate_Hz;          ///< The logs have no clock: their rows come at this rate.
  std::optional<double> gear_ratio;       ///< Of all joints: of angles on the motor's side.
  std::map<std::string, double> gear_ratio_of;  ///< Of single joints, instead.

  [[nodiscard]] std::optional<double> gear_ratio_for(const std::string& joint) const {
    const auto own = gear_ratio_of.find(joint);
    return own == gear_ratio_of.end() ? gear_ratio : std::optional(own->second);
  }
};

/// Whether the user says which column it is. @param key "effort"
bool states(const StatedColumns& stated, const std::string& key);

/// @param option "--effort-unit", for messages. @param quantities that it may be of.
/// @return the unit. @throw UsageError: it is none of these.
std::string parse_unit(const std::string& option, const std::string& text,
                       const std::vector<ingest::log::Quantity>& quantities);

/// Splits "angle=q_3". @throw UsageError for another key, or no name.
std::pair<std::string, std::string> parse_stated_column(const std::string& text);

/// Puts what is stated in the place of what the names say.
/// @return the stated names of which there is no column.
std::vector<std::string> put_stated(const StatedColumns& stated,
                                    const std::vector<ingest::log::ColumnHeader>& header,
                                    ingest::layout::LogLayout& layout);

}  // namespace tribolog::inspect::survey
