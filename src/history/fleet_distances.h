#pragma once
// Internal to the fleet: the distances of fleet.h.

#include "history/fleet.h"

namespace tribolog::archive {

/// Fills to_others and to_history of all cells.
void measure_distances(std::vector<FleetRobot>& robots);

}  // namespace tribolog::archive
