#include "figures/report_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace tribolog::figures {

std::vector<double> shown(const std::vector<double>& si_values, const wording::AxisScale& scale) {
  std::vector<double> out(si_values.size());
  std::transform(si_values.begin(), si_values.end(), out.begin(), scale);
  return out;
}

render::figure::Series line(const std::string& label, std::vector<double> x, std::vector<double> y,
                            render::figure::Colour colour, double width_px,
                            render::figure::LineStyle style) {
  const std::size_t size = std::min(x.size(), y.size());
  x.resize(size);
  y.resize(size);
  render::figure::Series series;
  series.label = label;
  series.x = std::move(x);
  series.y = std::move(y);
  series.colour = colour;
  series.width_px = width_px;
  series.style = style;
  return series;
}

bool add_visible(render::figure::Panel& panel, render::figure::Series series) {
  std::size_t drawable = 0;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (std::isfinite(series.x[i]) && std::isfinite(series.y[i])) ++drawable;
  }
  if (drawable == 0) return false;
  // A line of one point has no length.
  if (drawable == 1 && series.marker == render::figure::Marker::none) {
    series.marker = render::figure::Marker::circle;
  }
  panel.series.push_back(std::move(series));
  return true;
}

void add_visible(render::figure::Panel& panel, render::figure::PointLabel label) {
  if (std::isfinite(label.x) && std::isfinite(label.y)) {
    panel.point_labels.push_back(std::move(label));
  }
}

render::figure::Colour lightened(render::figure::Colour colour, double share_of_white) {
  const auto mixed = [&](std::uint8_t part) {
    return static_cast<std::uint8_t>(std::lround(part + (255 - part) * share_of_white));
  };
  return {mixed(colour.red), mixed(colour.green), mixed(colour.blue), colour.alpha};
}

render::figure::Colour faded(render::figure::Colour colour, int alpha) {
  colour.alpha = static_cast<std::uint8_t>(std::clamp(alpha, 0, 255));
  return colour;
}

}  // namespace tribolog::figures
