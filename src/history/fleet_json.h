#pragma once
// The fleet sheet for scripts.

#include <string>

#include "history/fleet.h"

namespace tribolog::archive {

/// {"schema": "tribolog-fleet-1", "limit", "robots": [{"joints": [{"quantities": [...]}]}]}: the
/// latest result of each quantity (SI, motor side) with both distances; the furthest robot first.
std::string fleet_json(const Fleet& fleet);

}  // namespace tribolog::archive
