#pragma once
// Known further loads, subtracted from the torque of a log that is being read.

#include <cstddef>
#include <vector>

#include "ingest/log/log_table.h"
#include "joint/known_load.h"
#include "joint/recording.h"

namespace tribolog {

/// Adds the columns that the loads of this role follow, each once, to those wanted.
void add_load_columns(const std::vector<KnownLoad>& loads, Role role,
                      std::vector<WantedColumn>& wanted);

/// @throw InputError for a unit in the log's header that contradicts the manifest.
void refuse_unusable_load_columns(const std::vector<KnownLoad>& loads, Role role,
                                  const LogTable& table);

/// Takes each load of the recording's role out of its torque, and counts it in the load.
/// @param rows of the table, one for each sample of the recording.
void subtract_known_loads(const LogTable& table, const std::vector<std::size_t>& rows,
                          double gear_ratio, std::vector<KnownLoad>& loads, Recording& recording);

}  // namespace tribolog
