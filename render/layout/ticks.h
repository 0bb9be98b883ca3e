#pragma once
// Round numbers on an axis and how to write them.

#include <string>
#include <vector>

#include "render/layout/axis_map.h"

namespace tribolog::render {

struct Tick {
  double value{};
  std::string label;  ///< Figure markup.
};

/// Labels are distinct. `scale_note` (markup, often empty) says what to do with every label:
/// "×10^{6}" to multiply, "+ 1.7·10^{9}" to add, or both in this order.
struct TickSet {
  std::vector<Tick> major;
  std::vector<double> minor;  ///< Logarithmic axes only.
  std::string scale_note;
};

/// Multiples of 1, 2 or 5 times a power of ten, at most `most` of them (at least 2 where the range
/// allows it), no closer than `least_step`. @pre range as AxisRange demands; most >= 2.
TickSet linear_ticks(const AxisRange& range, int most, double least_step = 0.0);

/// Decades; where the range is short also their 2- and 5-fold, or linear ticks.
TickSet logarithmic_ticks(const AxisRange& range, int most);

}  // namespace tribolog::render
