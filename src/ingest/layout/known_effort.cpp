#include "ingest/layout/known_effort.h"

#include <algorithm>

#include "ingest/layout/known_loggers.h"
#include "ingest/layout/name_pattern.h"

namespace tribolog {
namespace {

bool has_angle(const KnownLogger& logger, const std::string& column, const std::string& joint) {
  return std::any_of(logger.columns.begin(), logger.columns.end(), [&](const KnownColumn& known) {
    return known.quantity == Quantity::angle && joint_in_name(column, known.pattern) == joint;
  });
}

}  // namespace

std::optional<LoggedEffort> known_effort(const std::string& angle_column,
                                         const std::string& effort_column) {
  for (const KnownLogger& logger : known_loggers()) {
    for (const KnownColumn& known : logger.columns) {
      if (known.quantity != Quantity::torque && known.quantity != Quantity::current) continue;
      const auto joint = joint_in_name(effort_column, known.pattern);
      if (!joint || !has_angle(logger, angle_column, *joint)) continue;
      return LoggedEffort{std::string(logger.name), effort_column,       known.kind, known.side,
                          known.is_target,          known.is_behind_gear};
    }
  }
  return std::nullopt;
}

}  // namespace tribolog
