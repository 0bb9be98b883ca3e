#pragma once
// What a figure shows, as plain data: no VTK type, no pixel except line widths.
//
// Every text in a figure is UTF-8 with a small markup: `_{...}` is a subscript and `^{...}` a
// superscript ("T_{f} [N·m]", "q\u0307_{c}", "m^{2}"). A lone `_` or `^` is printed as it is.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "render/figure/diagram.h"
#include "render/figure/drawing_style.h"
#include "render/figure/scene.h"

namespace tribolog::render::figure {

/// A polyline, markers, or both. Points where x or y is not finite break the line.
struct Series {
  std::string label;  ///< Legend text; empty: not in the legend.
  std::vector<double> x;
  std::vector<double> y;  ///< As many as x.
  Colour colour{palette::black};
  double width_px{2.5};
  LineStyle style{LineStyle::solid};
  Marker marker{Marker::none};
  double marker_size_px{10.0};
  /// Arrow heads along the line that show the direction of time, at these fractions (0..1) of the
  /// points' count.
  std::vector<double> direction_arrows_at;
  /// What of it lies beyond the axes is marked at their edge: that it does is no fault.
  bool is_marked_at_edge{};
};

/// A filled region between two curves, e.g. a 95 % interval.
struct Band {
  std::string label;
  std::vector<double> x;
  std::vector<double> low;
  std::vector<double> high;
  Colour colour{palette::blue.red, palette::blue.green, palette::blue.blue, 50};
};

/// A vertical bar with caps (interval of one point).
struct ErrorBar {
  double x{};
  double low{};
  double high{};
  Colour colour{palette::black};
};

/// A named point: a marker on the data and a text beside it, placed where it covers nothing.
struct PointLabel {
  double x{};
  double y{};
  std::string text;
  Colour colour{palette::black};
  Marker marker{Marker::circle};
};

/// A straight line across the whole panel, with a text at its end.
struct ReferenceLine {
  enum class Direction { vertical, horizontal };
  Direction direction{Direction::vertical};
  double at{};
  std::string text;
  Colour colour{palette::grey};
  LineStyle style{LineStyle::dash};
};

/// What stands at a value of an axis instead of a number.
struct AxisName {
  double at{};
  std::string text;
};

struct Axis {
  std::string title;              ///< With the unit in brackets: "T [N·m]".
  std::optional<double> minimum;  ///< Fixed end; absent: from the data with a margin.
  std::optional<double> maximum;
  bool logarithmic{false};  ///< Decades; all data must be positive.
  /// Above 0: decades in both directions beyond this value, evenly divided within (as an inverse
  /// hyperbolic sine), so that slow and fast motions both ways have room.
  double linear_within{};
  bool dates{false};            ///< Values are days since 1970-01-01 UTC; ticks are calendar dates.
  bool counts{false};           ///< Values are whole numbers, and so are the ticks.
  std::vector<AxisName> names;  ///< If any, they are the ticks; no numbers are shown.
};

/// One plot area. Panels of a figure are stacked from top to bottom.
struct Panel {
  std::string title;  ///< Small heading above the panel; may be empty.
  Axis x;
  Axis y;
  std::vector<Band> bands;
  std::vector<Series> series;
  std::vector<ErrorBar> error_bars;
  std::vector<PointLabel> point_labels;
  std::vector<ReferenceLine> reference_lines;
  bool show_legend{true};
  bool labels_at_ends{};  ///< Each labelled series is named right of its last point instead.
  std::string notice{"no data"};  ///< Where there is nothing to show.
};

/// What a figure is drawn for: sizes of letters, widths of lines, margins.
enum class Look {
  report,       ///< 160 mm wide, read on a screen and on paper.
  publication,  ///< A column of a journal, with the caption below it.
};

/// Either panels, or a diagram, or a scene.
struct Figure {
  std::string id;     ///< File-name and anchor safe, e.g. "fig-15-hysteresis".
  std::string title;  ///< Printed on top of the picture.
  std::vector<Panel> panels;
  std::optional<Diagram> diagram{};  ///< If present, `panels` are not drawn.
  int width_px{1600};
  int height_px{1000};
  bool panels_share_x{false};  ///< Only the lowest panel gets tick labels and the axis title.
  std::optional<Scene> scene{};
  double width_mm{160.0};  ///< In print; letters and lines are sized for it.
  Look look{Look::report};
};

// What parts of a figure are called where something is said of them: by their text, or, where they
// have none, by their number, which counts from 1.

/// "series 'rising'", "series 3"
Statement name_of_series(const std::string& label, std::size_t index);

/// "block 'g(ω)'", "block 2"
Statement name_of_block(const Diagram& diagram, std::size_t index);

/// "wire 3"
Statement name_of_wire(std::size_t index);

/// "the text 'T_{f}'"
Statement name_of_text(const std::string& text);

/// "the part 'm_{3}'", of a scene
Statement name_of_part(const std::string& label);

}  // namespace tribolog::render::figure
