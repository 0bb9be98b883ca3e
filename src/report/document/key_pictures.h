#pragma once
// The two diagrams of page one, as paths and labels: hysteresis loop (or the sweep, where no loop
// was recorded) and friction curve. Made from the numbers alone, whether figures are drawn or not.

#include <vector>

#include "calibration/calibration.h"
#include "report/document/report_view.h"

namespace tribolog::report::document {

inline constexpr int picture_width = 440;
inline constexpr int picture_height = 250;

/// None, one or both, as far as there is something to draw.
std::vector<KeyPicture> key_pictures(const calibration::Calibration& calibration);

}  // namespace tribolog::report::document
