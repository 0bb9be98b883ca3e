#include "render/layout/direction_arrows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace tribolog::render {
namespace {

std::optional<PixelPoint> pixel_of(const PanelFrame& frame, const Series& series, std::size_t i) {
  if (!drawable(series.x[i], frame.x.logarithmic()) ||
      !drawable(series.y[i], frame.y.logarithmic())) {
    return std::nullopt;
  }
  return PixelPoint{frame.x.pixel(series.x[i]), frame.y.pixel(series.y[i])};
}

/// The first sample at least `distance` away from sample `from`, walking by `step`; the last one
/// before a gap if there is none.
std::optional<PixelPoint> walk(const PanelFrame& frame, const Series& series, std::size_t from,
                               int step, double distance) {
  const auto start = pixel_of(frame, series, from);
  std::optional<PixelPoint> last;
  if (!start) return last;
  const auto count = static_cast<std::ptrdiff_t>(std::min(series.x.size(), series.y.size()));
  for (auto i = static_cast<std::ptrdiff_t>(from) + step; i >= 0 && i < count; i += step) {
    const auto here = pixel_of(frame, series, static_cast<std::size_t>(i));
    if (!here) break;
    last = here;
    if (std::hypot(here->x - start->x, here->y - start->y) >= distance) break;
  }
  return last;
}

}  // namespace

void draw_direction_arrows(DrawList& list, const PanelFrame& frame, const Series& series,
                           const FigureStyle& style, Owner owner) {
  const std::size_t count = std::min(series.x.size(), series.y.size());
  if (count < 2) return;
  const double length = 20 * style.marker + 2.0 * series.width_px;
  const double half_width = 0.42 * length;
  for (const double share : series.direction_arrows_at) {
    if (!(share >= 0.0 && share <= 1.0)) continue;
    const auto at = static_cast<std::size_t>(std::lround(share * static_cast<double>(count - 1)));
    const auto here = pixel_of(frame, series, at);
    if (!here || !frame.plot.contains(*here)) continue;
    const auto behind = walk(frame, series, at, -1, length / 2).value_or(*here);
    const auto ahead = walk(frame, series, at, +1, length / 2).value_or(*here);
    const double dx = ahead.x - behind.x;
    const double dy = ahead.y - behind.y;
    const double norm = std::hypot(dx, dy);
    if (norm < 1e-6) continue;
    const PixelPoint along{dx / norm, dy / norm};
    // A head lies on its sample; at the end of a line its tip does, at the start its base.
    const double before = at == 0 ? 0.0 : at + 1 == count ? length : length / 2;
    const PixelPoint base{here->x - along.x * before, here->y - along.y * before};
    const PixelPoint tip{base.x + along.x * length, base.y + along.y * length};
    list.primitives.emplace_back(
        Polygon{owner,
                {tip,
                 {base.x - along.y * half_width, base.y + along.x * half_width},
                 {base.x + along.y * half_width, base.y - along.x * half_width}},
                series.colour});
  }
}

}  // namespace tribolog::render
