#pragma once
// The paper's joint with short experiments: a study of it takes seconds.

#include "simulate/scenario.h"

namespace tribolog::test {

/// Realistic noise; a rough sweep over the same range but twenty times as fast, five cycles of
/// oscillation, no precise sweep, no runs at constant speed.
simulate::Scenario small_scenario();

}  // namespace tribolog::test
