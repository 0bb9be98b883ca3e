#include "render/legibility/panel_content.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace tribolog::render::legibility {
namespace {

constexpr double rounding_px = 0.6;

bool is_ink(figure::Role role) {
  return role == figure::Role::series || role == figure::Role::series_marker ||
         role == figure::Role::error_bar || role == figure::Role::band ||
         role == figure::Role::label_marker;
}

bool has_unit(const std::string& title) {
  const std::size_t open = title.rfind('[');
  return open != std::string::npos && open + 2 < title.size() && title.back() == ']';
}

}  // namespace

Findings empty_panels(const figure::DrawList& list, const figure::Figure& figure) {
  Findings out;
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    const bool shows = std::any_of(
        list.primitives.begin(), list.primitives.end(), [&](const figure::Primitive& one) {
          const figure::Owner& owner = figure::owner_of(one);
          return owner.panel == static_cast<int>(p) && is_ink(owner.role);
        });
    if (shows) continue;
    const figure::PixelBox place = p < list.plots.size() ? list.plots[p] : figure::PixelBox{};
    out.push_back({"panel " + std::to_string(p + 1) + " shows no data", place});
  }
  return out;
}

Findings axes_without_unit(const figure::Figure& figure,
                           const std::vector<std::string>& without_unit) {
  Findings out;
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    for (const figure::Axis* axis : {&figure.panels[p].x, &figure.panels[p].y}) {
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

Findings data_outside_axes(const figure::DrawList& list) {
  Findings out;
  const auto tell = [&](const figure::Owner& owner, figure::PixelPoint p) {
    out.push_back({"series " + std::to_string(owner.index + 1) + " of panel " +
                       std::to_string(owner.panel + 1) + " leaves its axes",
                   {p.x, p.y, p.x, p.y}});
  };
  for (const figure::Primitive& one : list.primitives) {
    const figure::Owner& owner = figure::owner_of(one);
    if (owner.role != figure::Role::series && owner.role != figure::Role::series_marker) continue;
    const auto panel = static_cast<std::size_t>(owner.panel);
    if (panel >= list.plots.size()) continue;
    const figure::PixelBox plot = list.plots[panel].grown(rounding_px);
    const auto* line = std::get_if<figure::Polyline>(&one);
    const auto* markers = std::get_if<figure::Markers>(&one);
    if (line == nullptr && markers == nullptr) continue;
    const auto& points = line != nullptr ? line->points : markers->centres;
    const auto beyond = std::find_if(points.begin(), points.end(),
                                     [&](figure::PixelPoint p) { return !plot.contains(p); });
    if (beyond != points.end()) tell(owner, *beyond);
  }
  return out;
}

}  // namespace tribolog::render::legibility
