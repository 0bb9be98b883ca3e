#pragma once
// A figure of the report: the picture's description, the words that go with it, and its data
// made ready.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "render/figure/figure.h"
#include "wording/axis_scale.h"

namespace tribolog::figures {

/// `title`, `caption`, `how_to_read` and `alt` are plain UTF-8 text: no markup, no HTML.
/// Texts inside `figure` use the markup of render/figure/figure.h.
struct ReportFigure {
  std::optional<int> paper_number;  ///< Absent: not one of the paper's.
  std::string id;                   ///< File-name and anchor safe: "fig-15-hysteresis".
  std::string title;
  std::string caption;      ///< One or two sentences with the key numbers.
  std::string how_to_read;  ///< What to look for, and what a bad one looks like.
  std::string alt;          ///< The picture in words, made from the numbers.
  std::string stage;        ///< Name of the StageReport that it belongs to.
  /// Shown at once; the others support it, and a report may fold them.
  bool is_primary{};
  render::figure::Figure figure;
  std::string english_csv;  ///< Its data (figure_csv.h), where its words are in another language.
};

// Numbers of a recording or a result made ready for a panel: scaled, selected, never altered.

/// All values as the axis shows them.
std::vector<double> shown(const std::vector<double>& si_values, const wording::AxisScale& scale);

/// A line with the shorter of the two lengths.
render::figure::Series line(const std::string& label, std::vector<double> x, std::vector<double> y,
                            render::figure::Colour colour, double width_px = 2.5,
                            render::figure::LineStyle style = render::figure::LineStyle::solid);

/// Adds the series if at least one of its points can be drawn.
/// @return whether it was added.
bool add_visible(render::figure::Panel& panel, render::figure::Series series);

/// Adds the labelled point if it can be drawn.
void add_visible(render::figure::Panel& panel, render::figure::PointLabel label);

/// The colour mixed with white. Opaque: where a pale line crosses itself it grows no darker.
render::figure::Colour lightened(render::figure::Colour colour, double share_of_white);

/// The same colour, `alpha` of 255 opaque.
render::figure::Colour faded(render::figure::Colour colour, int alpha);

}  // namespace tribolog::figures
