#pragma once
// Angles of other joints that a log's own names tell, without a word in the manifest.

#include <string>
#include <vector>

#include "ingest/dataset/log_reader.h"
#include "ingest/log/log_table.h"
#include "ingest/manifest/manifest_file.h"
#include "joint/other_joints.h"

namespace tribolog::ingest::dataset {

/// The names of all columns of a table.
std::vector<log::ColumnHeader> headers_of(const log::LogTable& table);

/// By the names of a log's columns: measured angles of joints other than that of the entry's angle,
/// the first of each, in the unit of that.
/// @param header of all columns. @return none where the entry's angle is not among them.
std::vector<joint::OtherJoint> joints_in_columns(const std::vector<log::ColumnHeader>& header,
                                                 const manifest::RecordingEntry& entry);

/// Of a log in which each row is one joint's: adds the angles of the others at the rows of the
/// entry's, each as it was logged last; NaN before.
/// @param named_by the column of words that tells whose row it is. @param angle of all rows [unit
/// of the entry's]. @param part the entry's rows.
void add_joints_in_rows(const manifest::RecordingEntry& entry, const log::LogColumn& named_by,
                        const log::LogColumn& angle, ReadLog& part);

}  // namespace tribolog::ingest::dataset
