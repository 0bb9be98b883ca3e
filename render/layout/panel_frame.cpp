#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/layout/axis.h"
#include "render/layout/legend.h"
#include "render/layout/panel_drawing.h"

namespace tribolog::render::layout {
namespace {

constexpr double x_margin_share = 0.02;
constexpr double y_margin_share = 0.06;
constexpr double least_plot_height = 40.0;
constexpr double most_beside = 0.35;  // of the picture's width

TickSet named_ticks(const figure::Axis& axis, const AxisRange& range) {
  TickSet ticks;
  for (const figure::AxisName& name : axis.names) {
    if (name.at >= range.low && name.at <= range.high) ticks.major.push_back({name.at, name.text});
  }
  return ticks;
}

TickSet ticks_of(const figure::Axis& axis, const AxisRange& range, int most) {
  if (!axis.names.empty()) return named_ticks(axis, range);
  if (axis.dates) return date_ticks(range, most);
  if (axis.logarithmic) return logarithmic_ticks(range, most);
  if (axis.linear_within > 0) return symmetric_ticks(range, axis.linear_within, most);
  return linear_ticks(range, most, axis.counts ? 1.0 : 0.0);
}

class Framer {
 public:
  Framer(const figure::Figure& figure, const text::Font& font, const FigureStyle& style,
         const std::vector<double>& strips, std::vector<Statement>& warnings,
         text::TextFaults& faults)
      : figure_(figure),
        font_(font),
        style_(style),
        strips_(strips),
        warnings_(warnings),
        faults_(faults) {}

  FigureFrame run() {
    wrap_titles();
    choose_ranges();
    divide_height();
    make_y_axes();
    divide_width();
    make_x_axes();
    return std::move(out_);
  }

 private:
  std::vector<text::TextLine> wrap(const std::string& text, text::TextStyle style, double width,
                                   std::size_t most_lines) {
    if (text.empty()) return {};
    bool cut = false;
    text::TextFaults found;
    std::vector<text::TextLine> lines =
        text::wrap_lines(font_, text, style, width, most_lines, found, cut);
    if (cut) {
      style.size_px = std::max(8, static_cast<int>(std::lround(style.size_px * 0.8)));
      cut = false;
      found = {};
      lines = text::wrap_lines(font_, text, style, width, most_lines, found, cut);
    }
    faults_.malformed += found.malformed;
    faults_.without_glyph += found.without_glyph;
    if (cut) warnings_.push_back({"drawing.title_cut", {{"title", text.substr(0, 60)}}});
    return lines;
  }

  static double line_pitch(const text::TextStyle& style) { return 1.28 * style.size_px; }

  static double height_of(const std::vector<text::TextLine>& lines) {
    return lines.empty() ? 0.0
                         : line_pitch(lines.front().style) * static_cast<double>(lines.size());
  }

  void wrap_titles() {
    const double width = figure_.width_px - 2 * style_.margin;
    out_.title = wrap(figure_.title, style_.figure_title, width, 3);
    out_.panels.resize(figure_.panels.size());
    for (std::size_t i = 0; i < out_.panels.size(); ++i) {
      PanelFrame& frame = out_.panels[i];
      const figure::Panel& panel = figure_.panels[i];
      frame.shows_x = !figure_.panels_share_x || i + 1 == out_.panels.size();
      frame.title = wrap(panel.title, style_.panel_title, 0.8 * width, 2);
      if (frame.shows_x) frame.x_title = wrap(panel.x.title, style_.axis_title, 0.72 * width, 2);
    }
  }

  void choose_ranges() {
    DataExtent shared(!figure_.panels.empty() && figure_.panels.back().x.logarithmic);
    for (const figure::Panel& panel : figure_.panels) shared.add(x_extent(panel));
    for (std::size_t i = 0; i < out_.panels.size(); ++i) {
      const figure::Panel& panel = figure_.panels[i];
      const bool share = figure_.panels_share_x;
      const figure::Axis& x = share ? figure_.panels.back().x : panel.x;
      std::vector<Statement> repeated;
      ranges_x_.push_back(choose_range(share ? shared : x_extent(panel), x, x_margin_share,
                                       share && i > 0 ? repeated : warnings_));
      ranges_y_.push_back(choose_range(y_extent(panel), panel.y, y_margin_share, warnings_));
      x_axes_.push_back(&x);
    }
  }

  [[nodiscard]] double head_of(const PanelFrame& frame) const {
    // Room for the scale note of the y axis is always kept, so that panels look alike.
    return std::max(height_of(frame.title) + (frame.title.empty() ? 0.0 : style_.gap / 2),
                    style_.unit * 34.0);
  }

  [[nodiscard]] double foot_of(const PanelFrame& frame) const {
    if (!frame.shows_x) return style_.gap;
    return style_.tick_mark + style_.gap + line_pitch(style_.tick) +
           std::max(height_of(frame.x_title), line_pitch(style_.tick)) + style_.gap;
  }

  void divide_height() {
    double y = style_.margin + height_of(out_.title);
    out_.title_bottom = y;
    double taken = y + style_.margin / 2;
    for (std::size_t i = 0; i < out_.panels.size(); ++i) {
      taken += head_of(out_.panels[i]) + foot_of(out_.panels[i]) + strips_[i];
    }
    const double count = std::max<double>(1.0, static_cast<double>(out_.panels.size()));
    double plot_height = std::floor((figure_.height_px - taken) / count);
    if (plot_height < least_plot_height) {
      if (!out_.panels.empty()) warnings_.push_back({"drawing.too_low_for_panels"});
      plot_height = least_plot_height;
    }
    for (std::size_t i = 0; i < out_.panels.size(); ++i) {
      PanelFrame& frame = out_.panels[i];
      y += head_of(frame);
      frame.plot.top = std::round(y);
      frame.plot.bottom = frame.plot.top + plot_height;
      frame.below = frame.plot.bottom + foot_of(frame);
      y = frame.below + strips_[i];
    }
  }

  void make_y_axes() {
    for (std::size_t i = 0; i < out_.panels.size(); ++i) {
      PanelFrame& frame = out_.panels[i];
      const figure::Panel& panel = figure_.panels[i];
      frame.y = AxisMap(ranges_y_[i], panel.y, frame.plot.bottom, frame.plot.top);
      const int most = std::clamp(
          static_cast<int>(frame.plot.height() / (2.2 * style_.tick.size_px)) + 1, 2, 11);
      frame.y_ticks = ticks_of(panel.y, ranges_y_[i], most);
      const double room = frame.plot.height() + 0.5 * head_of(frame);
      frame.y_title = wrap(panel.y.title, style_.axis_title, room, 3);
    }
  }

  double label_width(const TickSet& ticks) {
    double widest = 0;
    for (const Tick& tick : ticks.major) {
      widest = std::max(widest, text::shape_line(font_, tick.label, style_.tick, faults_).width);
    }
    return widest;
  }

  /// Of the names beside the plots.
  double width_beside() {
    double widest = 0;
    for (const figure::Panel& panel : figure_.panels) {
      if (!panel.labels_at_ends) continue;
      for (const figure::Series& one : panel.series) {
        if (one.label.empty()) continue;
        widest = std::max(widest, text::shape_line(font_, one.label, style_.legend, faults_).width);
      }
    }
    if (widest == 0) return 0;
    return std::min(std::ceil(Legend::width_of(widest, style_)) + style_.gap,
                    most_beside * figure_.width_px);
  }

  void divide_width() {
    double titles = 0;
    double labels = 0;
    for (PanelFrame& frame : out_.panels) {
      titles = std::max(titles, height_of(frame.y_title));
      labels = std::max(labels, label_width(frame.y_ticks));
    }
    const double most_left = 0.6 * figure_.width_px;
    double left = style_.margin + titles + (titles > 0 ? style_.gap : 0.0) + labels + style_.gap +
                  style_.tick_mark;
    left = std::round(std::min(left, most_left));
    const double beside = std::max(width_beside(), 1.2 * style_.tick.size_px);
    const double right = std::round(figure_.width_px - style_.margin - beside);
    for (PanelFrame& frame : out_.panels) {
      frame.plot.left = left;
      frame.plot.right = std::max(right, left + least_plot_height);
      frame.y_title_left =
          left - style_.tick_mark - 2 * style_.gap - labels - height_of(frame.y_title);
    }
  }

  bool crowded(const PanelFrame& frame) {
    double previous = -1e9;
    for (const Tick& tick : frame.x_ticks.major) {
      const double half = text::shape_line(font_, tick.label, style_.tick, faults_).width / 2;
      const double at = frame.x.pixel(tick.value);
      if (at - half < previous + 0.8 * style_.tick.size_px) return true;
      previous = at + half;
    }
    return false;
  }

  /// A date is wider than the margin that numbers need at the ends of an axis.
  void drop_dates_beyond_the_picture(PanelFrame& frame) {
    std::erase_if(frame.x_ticks.major, [&](const Tick& tick) {
      const double half = text::shape_line(font_, tick.label, style_.tick, faults_).width / 2;
      const double at = frame.x.pixel(tick.value);
      return at - half < 0 || at + half > figure_.width_px;
    });
  }

  void make_x_axes() {
    for (std::size_t i = 0; i < out_.panels.size(); ++i) {
      PanelFrame& frame = out_.panels[i];
      const figure::Axis& axis = *x_axes_[i];
      frame.x = AxisMap(ranges_x_[i], axis, frame.plot.left, frame.plot.right);
      for (int most = 13; most >= 2; --most) {
        frame.x_ticks = ticks_of(axis, ranges_x_[i], most);
        if (axis.dates) drop_dates_beyond_the_picture(frame);
        if (!crowded(frame)) break;
      }
      if (crowded(frame) && frame.x_ticks.major.size() > 2) frame.x_ticks.major.resize(2);
    }
  }

  const figure::Figure& figure_;
  const text::Font& font_;
  const FigureStyle& style_;
  const std::vector<double>& strips_;
  std::vector<Statement>& warnings_;
  text::TextFaults& faults_;
  FigureFrame out_;
  std::vector<AxisRange> ranges_x_;
  std::vector<AxisRange> ranges_y_;
  std::vector<const figure::Axis*> x_axes_;  ///< Of each panel; one for all where it is shared.
};

}  // namespace

FigureFrame frame_figure(const figure::Figure& figure, const text::Font& font,
                         const FigureStyle& style, const std::vector<double>& strip_heights,
                         std::vector<Statement>& warnings, text::TextFaults& faults) {
  return Framer(figure, font, style, strip_heights, warnings, faults).run();
}

}  // namespace tribolog::render::layout
