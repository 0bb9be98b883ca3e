#pragma once
// Calendar dates on an axis of time.

#include "render/layout/ticks.h"

namespace tribolog::render::layout {

/// Whole years ("2026"), months ("2026-03"), days ("2026-03-05") or hours ("2026-03-05 06:00"), at
/// most `most` of them, and at least one where the range holds a whole hour. UTC.
/// @param range days since 1970-01-01; outside of the years 1 to 9999, or shorter than two hours,
///        the ticks are those of plain numbers.
TickSet date_ticks(const AxisRange& range, int most);

}  // namespace tribolog::render::layout
