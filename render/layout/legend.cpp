#include "render/layout/legend.h"

#include <algorithm>
#include <cmath>

#include "render/figure/draw_list.h"

namespace tribolog::render::layout {
namespace {

constexpr double most_of_plot = 0.45;  // share of the plot that a legend inside may take
constexpr double search_step_px = 8.0;

}  // namespace

Legend::Legend(const figure::Panel& panel, int panel_index, const text::Font& font,
               const FigureStyle& style, double most_width, std::vector<Statement>& warnings,
               text::TextFaults& faults)
    : style_(style),
      panel_(panel_index),
      row_height_(1.36 * style.legend.size_px),
      sample_width_(style.legend_sample),
      padding_(12 * style.unit) {
  if (!panel.show_legend) return;
  const double text_width = most_width - sample_width_ - 3 * padding_;
  const auto add = [&](const std::string& text, const figure::Series* series,
                       const figure::Band* band, int index) {
    if (text.empty()) return;
    bool cut = false;
    auto lines = text::wrap_lines(font, text, style.legend, text_width, 1, faults, cut);
    if (cut) warnings.push_back({"drawing.legend_cut", {{"text", text.substr(0, 60)}}});
    entries_.push_back({series,
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
