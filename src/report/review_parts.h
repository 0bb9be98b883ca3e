#pragma once
// Internal to the viewer's data.

#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "calibration/json_values.h"
#include "render/figure/drawing_style.h"
#include "wording/axis_scale.h"

namespace tribolog::report::review {

using json::Json;

/// Units in which the loops are shown: those of the static figures.
struct LoopScales {
  figures::AxisScale angle;
  figures::AxisScale torque;
  figures::AxisScale deflection;
  figures::AxisScale rate;
};

LoopScales loop_scales(const HysteresisResult& loops);
/// Words, symbol and unit by column name.
void add_loop_quantities(const LoopScales& scales, bool from_first_sample, Json& quantities);
Json loops(const HysteresisResult& result, const LoopScales& scales,
           const std::optional<Estimate>& q_peak_rad);
Json points(const HysteresisResult& result, const LoopScales& scales);
Json midline(const HysteresisResult& result, const LoopScales& scales);

void add_run_quantities(const Calibration& calibration, Json& quantities);
Json runs(const Calibration& calibration);
Json candidates(const Calibration& calibration, const figures::AxisScale& torque);

/// A text of strangers, safe to show; null if empty.
Json shown_text(const std::string& text);
/// {"words", "symbol", "unit"}
Json quantity(const std::string& words, const std::string& symbol, const std::string& unit);
/// Numbers in the unit of the axis, six significant digits.
Json column(const std::vector<double>& si, const figures::AxisScale& scale);
Json entry(double si, const figures::AxisScale& scale);
/// {"colour": "#0072b2", "line": "dash_dot"}
Json style(render::Colour colour, render::LineStyle line);

}  // namespace tribolog::report::review
