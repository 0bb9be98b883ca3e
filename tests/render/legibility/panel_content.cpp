#include "render/legibility/panel_content.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace tribolog::render::legibility {
namespace {

constexpr double rounding_px = 0.6;

bool is_ink(Role role) {
  return role == Role::series || role == Role::series_marker || role == Role::error_bar ||
         role == Role::band || role == Role::label_marker;
}

bool has_unit(const std::string& title) {
  const std::size_t open = title.rfind('[');
  return open != std::string::npos && open + 2 < title.size() && title.back() == ']';
}

}  // namespace

Findings empty_panels(const DrawList& list, const Figure& figure) {
  Findings out;
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    const bool shows =
        std::any_of(list.primitives.begin(), list.primitives.end(), [&](const Primitive& one) {
          const Owner& owner = owner_of(one);
          return owner.panel == static_cast<int>(p) && is_ink(owner.role);
        });
    if (shows) continue;
    const PixelBox place = p < list.plots.size() ? list.plots[p] : PixelBox{};
    out.push_back({"panel " + std::to_string(p + 1) + " shows no data", place});
  }
  return out;
}

Findings axes_without_unit(const Figure& figure, const std::vector<std::string>& without_unit) {
  Findings out;
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    for (const Axis* axis : {&figure.panels[p].x, &figure.panels[p].y}) {
      const bool is_excused =
          std::find(without_unit.begin(), without_unit.end(), axis->title) != without_unit.end();
      if (axis->dates || is_excused || has_unit(axis->title)) continue;
      out.push_back(
          {"the axis '" + axis->title + "' of panel " + std::to_string(p + 1) + " has no unit",
           {}});
    }
  }
  return out;
}

Findings data_outside_axes(const DrawList& list) {
  Findings out;
  const auto tell = [&](const Owner& owner, PixelPoint p) {
    out.push_back({"series " + std::to_string(owner.index + 1) + " of panel " +
                       std::to_string(owner.panel + 1) + " leaves its axes",
                   {p.x, p.y, p.x, p.y}});
  };
  for (const Primitive& one : list.primitives) {
    const Owner& owner = owner_of(one);
    if (owner.role != Role::series && owner.role != Role::series_marker) continue;
    const auto panel = static_cast<std::size_t>(owner.panel);
    if (panel >= list.plots.size()) continue;
    const PixelBox plot = list.plots[panel].grown(rounding_px);
    const auto* line = std::get_if<Polyline>(&one);
    const auto* markers = std::get_if<Markers>(&one);
    if (line == nullptr && markers == nullptr) continue;
    const auto& points = line != nullptr ? line->points : markers->centres;
    const auto beyond =
        std::find_if(points.begin(), points.end(), [&](PixelPoint p) { return !plot.contains(p); });
    if (beyond != points.end()) tell(owner, *beyond);
  }
  return out;
}

}  // namespace tribolog::render::legibility
