#pragma once
// Numbers that no joint of a robot gives, whatever was measured: a damaged row, another unit.

#include <string>

#include "ingest/dataset/row_choice.h"
#include "ingest/log/log_table.h"
#include "ingest/manifest/manifest_file.h"
#include "joint/drive.h"
#include "joint/recording.h"

namespace tribolog::ingest::dataset {

/// Of a column's values, in SI and on the side on which they were logged; infinite for the time.
double largest_possible(log::Quantity quantity);

/// @throw InputError at the row's line: its value in this column is no number that a joint has.
[[noreturn]] void refuse_impossible_value(const manifest::ColumnEntry& column, double value,
                                          const log::LogTable& table, std::size_t row);

/// Notes what points to another unit: an angle of more than a turn or that wraps round, a torque
/// larger than that of the largest robots, few samples a second.
/// @throw InputError for under 5 or over 100 000 samples a second (the median), unless the manifest
///        states that this is right; with the units of time in which there would be a usual number.
void judge_units(const manifest::RecordingEntry& entry, const log::LogTable& table,
                 const joint::Drive& drive, const joint::Recording& recording,
                 RecordingNotes& notes);

}  // namespace tribolog::ingest::dataset
