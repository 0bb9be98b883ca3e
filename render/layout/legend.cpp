#include "render/layout/legend.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/figure/draw_list.h"

namespace tribolog::render::layout {
namespace {

constexpr double most_of_plot = 0.45;  // share of the plot that a legend inside may take
constexpr double search_step_px = 8.0;

double padding_of(const FigureStyle& style) { return 12 * style.unit; }

}  // namespace

double Legend::width_of(double text, const FigureStyle& style) {
  return text + style.legend_sample + 3 * padding_of(style);
}

Legend::Legend(const figure::Panel& panel, int panel_index, const text::Font& font,
               const FigureStyle& style, double most_width, std::vector<Statement>& warnings,
               text::TextFaults& faults)
    : style_(style),
      panel_(panel_index),
      row_height_(1.36 * style.legend.size_px),
      sample_width_(style.legend_sample),
      padding_(padding_of(style)) {
  if (!panel.show_legend) return;
  const double text_width = most_width - width_of(0, style);
  const auto add = [&](const std::string& text, const figure::Series* series,
                       const figure::Band* band, int index) {
    if (text.empty()) {
      if (series != nullptr && !entries_.empty()) entries_.back().series_end = series + 1;
      return;
    }
    bool cut = false;
    auto lines = text::wrap_lines(font, text, style.legend, text_width, 1, faults, cut);
    if (cut) warnings.push_back({"drawing.legend_cut", {{"text", text.substr(0, 60)}}});
    entries_.push_back({series,
                        series == nullptr ? nullptr : series + 1,
                        band,
                        {figure::Role::legend_sample, panel_index, index},
                        {figure::Role::legend_text, panel_index, static_cast<int>(entries_.size())},
                        std::move(lines.front())});
  };
  int index = 0;
  for (const figure::Series& one : panel.series) add(one.label, &one, nullptr, index++);
  index = 0;
  for (const figure::Band& one : panel.bands) add(one.label, nullptr, &one, index++);
}

Legend::Block Legend::arranged(std::size_t columns) const {
  Block block;
  block.columns = columns;
  block.rows = (entries_.size() + columns - 1) / columns;
  block.column_widths.assign(columns, 0.0);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    double& width = block.column_widths[i / block.rows];
    width = std::max(width, sample_width_ + padding_ + entries_[i].label.width);
  }
  block.width = 2 * padding_;
  for (std::size_t c = 0; c < columns; ++c) {
    block.width += std::ceil(block.column_widths[c]) + (c > 0 ? 2 * padding_ : 0.0);
  }
  block.height = static_cast<double>(block.rows) * row_height_ + padding_;
  return block;
}

Legend::Block Legend::widest_block(double width) const {
  for (std::size_t columns = entries_.size(); columns > 1; --columns) {
    const std::size_t rows = (entries_.size() + columns - 1) / columns;
    if ((entries_.size() + rows - 1) / rows != columns) continue;  // an empty last column
    Block block = arranged(columns);
    if (block.width <= width) return block;
  }
  return arranged(1);
}

std::optional<figure::PixelPoint> Legend::free_place(const Block& block,
                                                     const figure::PixelBox& plot,
                                                     const Occupancy& taken) const {
  const double inset = 14 * style_.unit;
  const figure::PixelBox room = plot.grown(-inset);
  if (block.width > room.width() || block.height > room.height()) return std::nullopt;
  if (block.width * block.height > most_of_plot * plot.area()) return std::nullopt;
  std::optional<figure::PixelPoint> best;
  double best_distance = 1e300;
  const double last_x = room.right - block.width;
  const double last_y = room.bottom - block.height;
  const auto steps = [](double from, double to) {
    return std::max(1, static_cast<int>(std::ceil((to - from) / search_step_px)));
  };
  const int columns = steps(room.left, last_x);
  const int rows = steps(room.top, last_y);
  for (int row = 0; row <= rows; ++row) {
    const double y = room.top + (last_y - room.top) * row / rows;
    for (int column = 0; column <= columns; ++column) {
      const double x = room.left + (last_x - room.left) * column / columns;
      const double distance =
          std::min(x - room.left, last_x - x) + std::min(y - room.top, last_y - y);
      if (distance >= best_distance) continue;
      const figure::PixelBox box{x, y, x + block.width, y + block.height};
      if (taken.taken(box.grown(6 * style_.unit)) > 0) continue;
      best = figure::PixelPoint{std::round(x), std::round(y)};
      best_distance = distance;
    }
  }
  return best;
}

bool Legend::draw_inside(figure::DrawList& list, const figure::PixelBox& plot,
                         const Occupancy& taken) const {
  const std::size_t most_columns = std::min<std::size_t>(entries_.size(), 3);
  for (std::size_t columns = 1; columns <= most_columns; ++columns) {
    const Block block = arranged(columns);
    const auto place = free_place(block, plot, taken);
    if (!place) continue;
    draw_block(list, block, *place, true);
    return true;
  }
  return false;
}

namespace {

/// Where the series end, in the plot; its bottom where they do not.
double end_of(const figure::Series* first, const figure::Series* last, const PanelFrame& frame) {
  double y = frame.plot.bottom;
  double farthest = -1e300;
  for (const figure::Series* one = first; one != last; ++one) {
    for (std::size_t i = 0; i < std::min(one->x.size(), one->y.size()); ++i) {
      if (!layout::drawable(one->x[i], frame.x.logarithmic()) ||
          !layout::drawable(one->y[i], frame.y.logarithmic()) || one->x[i] < farthest) {
        continue;
      }
      farthest = one->x[i];
      y = frame.y.pixel(one->y[i]);
    }
  }
  return std::clamp(y, frame.plot.top, frame.plot.bottom);
}

/// Rising heights, moved as little as leaves `apart` between neighbours: those that would touch
/// stand evenly about their mean.
void spread(std::vector<double>& heights, double apart) {
  struct Group {
    double sum{};  ///< Of the heights, each less its place in the group.
    std::size_t count{};
    [[nodiscard]] double first() const { return sum / static_cast<double>(count); }
  };
  std::vector<Group> groups;
  for (const double height : heights) {
    groups.push_back({height, 1});
    while (groups.size() > 1) {
      Group& before = groups[groups.size() - 2];
      const Group& last = groups.back();
      const double taken = apart * static_cast<double>(before.count);
      if (before.first() + taken <= last.first()) break;
      before.sum += last.sum - taken * static_cast<double>(last.count);
      before.count += last.count;
      groups.pop_back();
    }
  }
  std::size_t at = 0;
  for (const Group& group : groups) {
    for (std::size_t k = 0; k < group.count; ++k) {
      heights[at++] = group.first() + apart * static_cast<double>(k);
    }
  }
}

}  // namespace

void Legend::draw_beside(figure::DrawList& list, const PanelFrame& frame) const {
  std::vector<std::pair<double, const Entry*>> ends;
  for (const Entry& entry : entries_) {
    ends.emplace_back(end_of(entry.series, entry.series_end, frame), &entry);
  }
  std::stable_sort(ends.begin(), ends.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<double> heights;
  for (const auto& [end, entry] : ends) heights.push_back(end);
  spread(heights, row_height_);
  // All of them within the plot's height, if there is room.
  const double half = row_height_ / 2;
  const double below = heights.empty() ? 0 : heights.back() - (frame.plot.bottom - half);
  const double above = heights.empty() ? 0 : (frame.plot.top + half) - heights.front();
  const double shift = below > 0 ? -below : std::max(above, 0.0);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Entry& entry = *ends[i].second;
    const double y = std::round(heights[i] + shift);
    const double x = frame.plot.right + style_.gap;
    draw_sample(list, entry, {x, y});
    text::place_line(list, entry.label,
                     {x + sample_width_ + style_.gap, y + 0.36 * style_.legend.size_px}, true,
                     entry.text);
  }
}

double Legend::strip_height(double width) const {
  return std::ceil(widest_block(width).height + padding_ / 2);
}

void Legend::draw_strip(figure::DrawList& list, const figure::PixelBox& plot, double top) const {
  const double room = std::max(plot.width(), list.width - 2 * style_.margin);
  const Block block = widest_block(room);
  const double centred = plot.centre().x - block.width / 2;
  const double left = std::clamp(centred, style_.margin,
                                 std::max(style_.margin, list.width - style_.margin - block.width));
  draw_block(list, block, {std::round(left), std::round(top)}, false);
}

void Legend::draw_block(figure::DrawList& list, const Block& block, figure::PixelPoint top_left,
                        bool framed) const {
  const auto [x, y] = top_left;
  if (framed) {
    const double right = x + block.width;
    const double bottom = y + block.height;
    const figure::Owner owner{figure::Role::legend_box, panel_, 0};
    list.primitives.emplace_back(
        figure::Polygon{owner, {{x, y}, {right, y}, {right, bottom}, {x, bottom}}, ink::white});
    list.primitives.emplace_back(
        figure::Polyline{owner,
                         {{x, y}, {right, y}, {right, bottom}, {x, bottom}, {x, y}},
                         std::max(1.0, 1.5 * style_.stroke),
                         ink::frame,
                         {}});
  }
  double left = x + padding_;
  for (std::size_t column = 0, i = 0; column < block.columns; ++column) {
    for (std::size_t row = 0; row < block.rows && i < entries_.size(); ++row, ++i) {
      const Entry& entry = entries_[i];
      const double middle =
          std::round(y + padding_ / 2 + (static_cast<double>(row) + 0.5) * row_height_);
      draw_sample(list, entry, {left, middle});
      text::place_line(list, entry.label,
                       {left + sample_width_ + padding_, middle + 0.36 * style_.legend.size_px},
                       true, entry.text);
    }
    left += std::ceil(block.column_widths[column]) + 2 * padding_;
  }
}

void Legend::draw_sample(figure::DrawList& list, const Entry& entry,
                         figure::PixelPoint left_middle) const {
  const auto [x, y] = left_middle;
  const double right = x + sample_width_;
  if (entry.band != nullptr) {
    const double half = 0.3 * style_.legend.size_px;
    list.primitives.emplace_back(
        figure::Polygon{entry.sample,
                        {{x, y - half}, {right, y - half}, {right, y + half}, {x, y + half}},
                        entry.band->colour});
    return;
  }
  const figure::Series& series = *entry.series;
  if (series.style != figure::LineStyle::none) {
    list.primitives.emplace_back(
        figure::Polyline{entry.sample,
                         {{x, y}, {right, y}},
                         series.width_px,
                         series.colour,
                         figure::dash_lengths(series.style, series.width_px)});
  }
  if (series.marker != figure::Marker::none) {
    list.primitives.emplace_back(figure::Markers{entry.sample,
                                                 series.marker,
                                                 {{(x + right) / 2, y}},
                                                 std::min(series.marker_size_px, 0.9 * row_height_),
                                                 series.colour});
  }
}

}  // namespace tribolog::render::layout
