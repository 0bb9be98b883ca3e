#include "figures/figure_csv.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace tribolog {
namespace {

using render::Panel;
using render::Series;

constexpr std::size_t fewest_rows = 40;  ///< Of a curve.

/// "T_{f} [N·m]" -> "T_f [N·m]", in one line.
std::string plain(const std::string& markup) {
  std::string text;
  bool is_shifted = false;
  for (std::size_t i = 0; i < markup.size(); ++i) {
    const char c = markup[i];
    const bool opens = c == '{' && i > 0 && (markup[i - 1] == '_' || markup[i - 1] == '^');
    if (opens) {
      is_shifted = true;
    } else if (c == '}' && is_shifted) {
      is_shifted = false;
    } else {
      text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return text;
}

/// A cell. One that a spreadsheet would take for a formula gets an apostrophe in front.
std::string quoted(const std::string& markup) {
  std::string text = plain(markup);
  if (!text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos)
    text.insert(0, "'");
  if (text.find_first_of("\",") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell.append(c == '"' ? 2 : 1, c);
  return cell + '"';
}

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

/// Of every block of samples the lowest and the highest, in their order.
std::vector<std::size_t> kept_samples(const std::vector<double>& y, std::size_t most) {
  std::vector<std::size_t> kept;
  const std::size_t block = y.size() <= most ? 1 : (2 * y.size() + most - 1) / most;
  for (std::size_t from = 0; from < y.size(); from += block) {
    const std::size_t to = std::min(from + block, y.size());
    std::size_t low = from;
    std::size_t high = from;
    for (std::size_t i = from; i < to; ++i) {
      if (y[i] < y[low] || !std::isfinite(y[low])) low = i;
      if (y[i] > y[high] || !std::isfinite(y[high])) high = i;
    }
    kept.push_back(std::min(low, high));
    if (low != high) kept.push_back(std::max(low, high));
  }
  return kept;
}

std::size_t samples_in(const render::Figure& figure) {
  std::size_t sum = 0;
  for (const Panel& panel : figure.panels) {
    for (const Series& series : panel.series) sum += series.x.size();
    for (const render::Band& band : panel.bands) sum += band.x.size();
  }
  return sum;
}

class Writer {
 public:
  Writer(const ReportFigure& figure, std::size_t most_rows)
      : share_(std::min(
            1.0, static_cast<double>(most_rows) /
                     static_cast<double>(std::max<std::size_t>(1, samples_in(figure.figure))))) {
    comments_ = fmt::format("# {}: {}\n", figure.id, plain(figure.title));
    int number = 0;
    for (const Panel& panel : figure.figure.panels) add(panel, ++number);
  }

  [[nodiscard]] std::string text() const {
    return comments_ + "panel,what,name,x,y,low,high\n" + rows_;
  }

 private:
  void add(const Panel& panel, int number) {
    panel_ = number;
    comments_ += fmt::format("# panel {}{}: x = {}; y = {}\n", number,
                             panel.title.empty() ? "" : " (" + plain(panel.title) + ")",
                             plain(panel.x.title), plain(panel.y.title));
    for (const Series& series : panel.series) add(series);
    for (const render::Band& band : panel.bands) add(band);
    for (const render::ErrorBar& bar : panel.error_bars)
      row("interval", "", bar.x, not_there, bar.low, bar.high);
    for (const render::AxisName& name : panel.x.names) row("name", name.text, name.at, not_there);
    for (const render::AxisName& name : panel.y.names) row("name", name.text, not_there, name.at);
    for (const render::PointLabel& point : panel.point_labels)
      row("point", point.text, point.x, point.y);
    for (const render::ReferenceLine& line : panel.reference_lines) {
      const bool is_vertical = line.direction == render::ReferenceLine::Direction::vertical;
      row("line", line.text, is_vertical ? line.at : not_there, is_vertical ? not_there : line.at);
    }
  }

  void add(const Series& series) {
    const auto kept = kept_samples(series.y, rows_of(series.y.size()));
    for (const std::size_t i : kept) row("curve", series.label, series.x[i], series.y[i]);
    tell_thinned(series.label, kept.size(), series.y.size());
  }

  void add(const render::Band& band) {
    const auto kept = kept_samples(band.high, rows_of(band.high.size()));
    for (const std::size_t i : kept)
      row("interval", band.label, band.x[i], not_there, band.low[i], band.high[i]);
    tell_thinned(band.label, kept.size(), band.x.size());
  }

  [[nodiscard]] std::size_t rows_of(std::size_t samples) const {
    const auto part = static_cast<std::size_t>(share_ * static_cast<double>(samples));
    return share_ < 1.0 ? std::max(fewest_rows, part) : samples;
  }

  void tell_thinned(const std::string& label, std::size_t kept, std::size_t of) {
    if (kept == of) return;
    comments_ +=
        fmt::format("# panel {}, {}: {} of {} samples, the lowest and highest of each block\n",
                    panel_, label.empty() ? "a curve" : plain(label), kept, of);
  }

  void row(const char* what, const std::string& name, double x, double y, double low = not_there,
           double high = not_there) {
    rows_ += fmt::format("{},{},{},{},{},{},{}\n", panel_, what, quoted(name), number(x), number(y),
                         number(low), number(high));
  }

  static constexpr double not_there = std::numeric_limits<double>::quiet_NaN();
  double share_;  ///< Of the samples that become rows.
  int panel_{};
  std::string comments_;
  std::string rows_;
};

}  // namespace

std::string figure_csv(const ReportFigure& figure, std::size_t most_rows) {
  if (figure.figure.panels.empty() || figure.figure.diagram) return "";
  return Writer(figure, most_rows).text();
}

}  // namespace tribolog
