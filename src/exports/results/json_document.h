#pragma once
// The results as JSON for a script.

#include <string>

#include "exports/results/archived_joint.h"

namespace tribolog::exports::results {

/// Schema "tribolog-export-1", described by templates/export.schema.json: what the calibration is
/// of, the conversions, each quantity on each side, and the friction curve on both sides.
std::string json_document(const ArchivedJoint& joint);

}  // namespace tribolog::exports::results
