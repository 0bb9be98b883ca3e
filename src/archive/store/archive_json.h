#pragma once
// What an archive holds, as JSON for scripts. Keys are in the same order always.

#include <string>
#include <vector>

#include "archive/store/calibration_archive.h"

namespace tribolog::archive::store {

/// {"schema": "tribolog-archive-1", "calibrations": [...]}, each with its last decision or null.
std::string entries_json(const std::vector<calibration::Entry>& entries,
                         const calibration::Decisions& decisions);

/// One with its quantities, inputs, documents and reviews.
std::string entry_json(const calibration::Entry& entry,
                       const std::vector<calibration::Quantity>& quantities,
                       const std::vector<calibration::Input>& inputs,
                       const std::vector<StoredDocument>& documents,
                       const std::vector<calibration::Review>& reviews);

/// One line: {"id": "...", "is_new": true, "file": "cal.json"}.
std::string added_json(const Added& added, const std::string& file);

/// {"schema": "tribolog-archive-removed-1", "removed": ["id", ...]}
std::string removed_json(const std::vector<calibration::Entry>& entries);

std::string verification_json(const Verification& outcome);

}  // namespace tribolog::archive::store
