#pragma once
// The columns that a manifest names, with what makes signals of them.

#include <vector>

#include "ingest/manifest/manifest_columns.h"
#include "joint/drive.h"

namespace tribolog::ingest::dataset {

struct LoggedColumn {
  joint::LoggedSignal signal{};
  const manifest::ColumnEntry* entry{};  ///< Of the manifest; not null.
};

/// In the order in which they are read; the time comes first.
std::vector<LoggedColumn> logged_columns(const manifest::ColumnEntries& columns);

/// Angle and speed to the joint's side, effort to torque at the motor, all to SI.
/// @param effort_sign 1 or -1.
joint::ColumnConversion conversion_of(const LoggedColumn& column, const joint::Drive& drive,
                                      double effort_sign);

/// Those of all columns, in the same order.
std::vector<joint::ColumnConversion> conversions_of(const manifest::ColumnEntries& columns,
                                                    const joint::Drive& drive, double effort_sign);

}  // namespace tribolog::ingest::dataset
