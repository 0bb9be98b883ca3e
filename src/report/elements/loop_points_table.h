#pragma once
// Points A to F of one turn, as a table.

#include <string>
#include <vector>

#include "method/hysteresis/loop_points.h"
#include "report/elements/elements.h"

namespace tribolog::report::elements {

Table loop_points_table(const std::vector<method::hysteresis::LoopPoint>& points,
                        const std::string& id, const std::string& caption);

}  // namespace tribolog::report::elements
