#pragma once
// Long format: each row is one signal's reading, {"time": 0.1, "signal": "q", "value": 0.5}.

#include <vector>

#include "base/statement.h"
#include "ingest/arrays/array_tables.h"

namespace tribolog::ingest::arrays {

/// Gives each signal a column of its own, of the readings of the same time a row.
///
/// Told by columns of a file that are equally long: words called "signal", "name", "variable" and
/// the like, numbers called "value", and a time, which may be in seconds and nanoseconds. A column
/// "joint" or "axis" comes in front of the signal's name: "elbow.position"; one called "unit" says
/// the units. A signal without a reading at a time has a gap there; a second reading of the same
/// time is left out. Nothing is changed where the signals have hardly a time in common. What else
/// is said of single readings is left out with the reason.
/// @return what the user should know.
std::vector<Statement> spread_signals(FileArrays& found);

}  // namespace tribolog::ingest::arrays
