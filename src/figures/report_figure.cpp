#include "figures/report_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace tribolog::figures {

std::vector<double> shown(const std::vector<double>& si_values, const AxisScale& scale) {
  std::vector<double> out(si_values.size());
  std::transform(si_values.begin(), si_values.end(), out.begin(), scale);
  return out;
}

render::Series line(const std::string& label, std::vector<double> x, std::vector<double> y,
                    render::Colour colour, double width_px, render::LineStyle style) {
  const std::size_t size = std::min(x.size(), y.size());
  x.resize(size);
  y.resize(size);
  render::Series series;
  series.label = label;
  series.x = std::move(x);
  series.y = std::move(y);
  series.colour = colour;
  series.width_px = width_px;
  series.style = style;
  return series;
}

bool add_visible(render::Panel& panel, render::Series series) {
  std::size_t drawable = 0;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (std::isfinite(series.x[i]) && std::isfinite(series.y[i])) ++drawable;
  }
  if (drawable == 0) return false;
  // A line of one point has no length.
  if (drawable == 1 && series.marker == render::Marker::none) {
    series.marker = render::Marker::circle;
  }
  panel.series.push_back(std::move(series));
  return true;
}

void add_visible(render::Panel& panel, render::PointLabel label) {
  if (std::isfinite(label.x) && std::isfinite(label.y)) {
    panel.point_labels.push_back(std::move(label));
  }
}

render::Colour lightened(render::Colour colour, double share_of_white) {
  const auto mixed = [&](std::uint8_t part) {
    return static_cast<std::uint8_t>(std::lround(part + (255 - part) * share_of_white));
  };
  return {mixed(colour.red), mixed(colour.green), mixed(colour.blue), colour.alpha};
}

render::Colour faded(render::Colour colour, int alpha) {
  colour.alpha = static_cast<std::uint8_t>(std::clamp(alpha, 0, 255));
  return colour;
}

}  // namespace tribolog::figures
