#pragma once
// The columns that a manifest names, with what makes signals of them.

#include <vector>

#include "ingest/manifest/manifest_columns.h"
#include "joint/drive.h"

namespace tribolog {

struct LoggedColumn {
  LoggedSignal signal{};
  const ColumnEntry* entry{};  ///< Of the manifest; not null.
};

/// In the order in which they are read; the time comes first.
std::vector<LoggedColumn> logged_columns(const ColumnEntries& columns);

/// Angle and speed to the joint's side, effort to torque at the motor, all to SI.
/// @param effort_sign 1 or -1.
ColumnConversion conversion_of(const LoggedColumn& column, const Drive& drive, double effort_sign);

/// Those of all columns, in the same order.
std::vector<ColumnConversion> conversions_of(const ColumnEntries& columns, const Drive& drive,
                                             double effort_sign);

}  // namespace tribolog
