#pragma once
// What an archive holds, as JSON for scripts. Keys are in the same order always.

#include <string>
#include <vector>

#include "archive/store/calibration_archive.h"

namespace tribolog::archive {

/// {"schema": "tribolog-archive-1", "calibrations": [...]}, each with its last decision or null.
std::string entries_json(const std::vector<Entry>& entries, const Decisions& decisions);

/// One with its quantities, inputs, documents and reviews.
std::string entry_json(const Entry& entry, const std::vector<Quantity>& quantities,
                       const std::vector<Input>& inputs,
                       const std::vector<StoredDocument>& documents,
                       const std::vector<Review>& reviews);

/// One line: {"id": "...", "is_new": true, "file": "cal.json"}.
std::string added_json(const Added& added, const std::string& file);

/// {"schema": "tribolog-archive-removed-1", "removed": ["id", ...]}
std::string removed_json(const std::vector<Entry>& entries);

std::string verification_json(const Verification& outcome);

}  // namespace tribolog::archive
