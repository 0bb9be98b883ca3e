#pragma once
// Internal to the viewer's data.

#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "calibration/json_values.h"
#include "calibration/read_calibration.h"
#include "render/figure/drawing_style.h"
#include "wording/axis_scale.h"

namespace tribolog::report::viewer {

using calibration::Json;

/// Units in which the loops are shown: those of the static figures.
struct LoopScales {
  wording::AxisScale angle;
  wording::AxisScale torque;
  wording::AxisScale deflection;
  wording::AxisScale rate;
};

LoopScales loop_scales(const calibration::Calibration& calibration);
/// Words, symbol and unit by column name.
void add_loop_quantities(const LoopScales& scales, bool from_first_sample, Json& quantities);
Json loops(const calibration::Calibration& calibration, const LoopScales& scales);
Json points(const calibration::Calibration& calibration, const LoopScales& scales);
Json midline(const method::hysteresis::HysteresisResult& result, const LoopScales& scales);

void add_run_quantities(const calibration::Calibration& calibration, Json& quantities);
Json runs(const calibration::Calibration& calibration);
Json candidates(const calibration::Calibration& calibration, const wording::AxisScale& torque);
wording::AxisScale friction_scale(const calibration::Calibration& calibration);
/// Steady loops and the friction curve of the joint's calibration before.
Json earlier_curves(const calibration::RecordedCurves& curves, const std::string& date,
                    const LoopScales& scales, const wording::AxisScale& friction);
/// The friction laws tried on the recommended curve; null: none.
Json laws(const calibration::Calibration& calibration);

/// What the script says by itself, in the language of the words; empty in English.
Json script_texts();
/// Compact, with what is hidden in it made visible.
std::string review_text(const Json& all);

/// A text of strangers, safe to show; null if empty.
Json shown_text(const std::string& text);
/// {"words", "symbol", "unit"}
Json quantity(const std::string& words, const std::string& symbol, const std::string& unit);
/// Numbers in the unit of the axis, six significant digits.
Json column(const std::vector<double>& si, const wording::AxisScale& scale);
Json entry(double si, const wording::AxisScale& scale);
/// {"colour": "#0072b2", "line": "dash_dot"}
Json style(render::figure::Colour colour, render::figure::LineStyle line);

}  // namespace tribolog::report::viewer
