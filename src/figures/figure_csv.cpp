#include "figures/figure_csv.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace tribolog::figures {
namespace {

using render::figure::Panel;
using render::figure::Series;

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

/// "2026-11-22T06:30:00Z" of days since 1970-01-01.
std::string date(double days) {
  using std::chrono::seconds;
  constexpr double day = 86'400;
  constexpr double year_9999 = 2'932'897;
  if (!(std::abs(days) < year_9999)) return "";
  const std::chrono::sys_seconds at{seconds(std::llround(days * day))};
  return fmt::format("{:%FT%TZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(at)));
}

/// A cell. One that a spreadsheet would take for a formula gets an apostrophe in front.
std::string quoted(const std::string& markup) {
  std::string text = plain(markup);
  if (!text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos)
    text.insert(text.begin(), '\'');
  if (text.find_first_of("\",") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell.append(c == '"' ? 2 : 1, c);
  return cell + '"';
}

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

/// Of every block of samples the lowest and the highest that are there, in their order.
/// @param is_there of a sample: that it can be drawn
std::vector<std::size_t> kept_samples(const std::vector<double>& y,
                                      const std::vector<bool>& is_there, std::size_t most) {
  std::vector<std::size_t> kept;
  const std::size_t block = y.size() <= most ? 1 : (2 * y.size() + most - 1) / most;
  for (std::size_t from = 0; from < y.size(); from += block) {
    const std::size_t to = std::min(from + block, y.size());
    std::size_t low = to;
    std::size_t high = to;
    for (std::size_t i = from; i < to; ++i) {
      if (!is_there[i]) continue;
      if (low == to || y[i] < y[low]) low = i;
      if (high == to || y[i] > y[high]) high = i;
    }
    if (low == to) continue;
    kept.push_back(std::min(low, high));
    if (low != high) kept.push_back(std::max(low, high));
  }
  return kept;
}

std::string scale(const render::figure::Axis& axis) {
  return axis.logarithmic ? " (logarithmic)" : "";
}

std::size_t samples_in(const render::figure::Figure& figure) {
  std::size_t sum = 0;
  for (const render::figure::Panel& panel : figure.panels) {
    for (const render::figure::Series& series : panel.series) sum += series.x.size();
    for (const render::figure::Band& band : panel.bands) sum += band.x.size();
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
    for (const render::figure::Panel& panel : figure.figure.panels) add(panel, ++number);
  }

  [[nodiscard]] std::string text() const {
    return comments_ + "panel,what,name,x,y,low,high\n" + rows_;
  }

 private:
  void add(const render::figure::Panel& panel, int number) {
    panel_ = number;
    x_ = &panel.x;
    comments_ +=
        fmt::format("# panel {}{}: x = {}{}; y = {}{}\n", number,
                    panel.title.empty() ? "" : " (" + plain(panel.title) + ")",
                    plain(panel.x.title), scale(panel.x), plain(panel.y.title), scale(panel.y));
    for (const render::figure::Series& series : panel.series) add(series);
    for (const render::figure::Band& band : panel.bands) add(band);
    for (const render::figure::ErrorBar& bar : panel.error_bars)
      row("interval", "", bar.x, not_there, bar.low, bar.high);
    for (const render::figure::AxisName& name : panel.x.names)
      row("name", name.text, name.at, not_there);
    for (const render::figure::AxisName& name : panel.y.names)
      row("name", name.text, not_there, name.at);
    for (const render::figure::PointLabel& point : panel.point_labels)
      row("point", point.text, point.x, point.y);
    for (const render::figure::ReferenceLine& line : panel.reference_lines) {
      const bool is_vertical = line.direction == render::figure::ReferenceLine::Direction::vertical;
      row("line", line.text, is_vertical ? line.at : not_there, is_vertical ? not_there : line.at);
    }
  }

  void add(const render::figure::Series& series) {
    const char* const what = series.style == render::figure::LineStyle::none ? "marks" : "curve";
    std::vector<bool> is_there(series.x.size());
    for (std::size_t i = 0; i < is_there.size(); ++i)
      is_there[i] = std::isfinite(series.x[i]) && std::isfinite(series.y[i]);
    add_samples(what, series.label, series.y, is_there,
                [&](std::size_t i) { row(what, series.label, series.x[i], series.y[i]); });
  }

  void add(const render::figure::Band& band) {
    std::vector<bool> is_there(band.x.size());
    for (std::size_t i = 0; i < is_there.size(); ++i)
      is_there[i] =
          std::isfinite(band.x[i]) && std::isfinite(band.low[i]) && std::isfinite(band.high[i]);
    add_samples("interval", band.label, band.high, is_there, [&](std::size_t i) {
      row("interval", band.label, band.x[i], not_there, band.low[i], band.high[i]);
    });
  }

  /// Rows of the samples that are kept, and one without numbers for each break between them.
  template <typename AddRow>
  void add_samples(const char* what, const std::string& label, const std::vector<double>& y,
                   const std::vector<bool>& is_there, const AddRow& add_row) {
    const std::vector<std::size_t> kept = kept_samples(y, is_there, rows_of(y.size()));
    std::size_t seen = 0;
    for (const std::size_t i : kept) {
      bool is_broken = false;
      for (; seen < i; ++seen) is_broken = is_broken || !is_there[seen];
      if (is_broken && i != kept.front()) row(what, label, not_there, not_there);
      add_row(i);
    }
    const auto there = static_cast<std::size_t>(std::count(is_there.begin(), is_there.end(), true));
    if (kept.size() < there) {
      tell(label, fmt::format("{} of {} samples, the lowest and highest of each block", kept.size(),
                              there));
    }
    if (there < y.size()) {
      tell(label, fmt::format("{} of {} samples are no numbers", y.size() - there, y.size()));
    }
  }

  [[nodiscard]] std::size_t rows_of(std::size_t samples) const {
    const auto part = static_cast<std::size_t>(share_ * static_cast<double>(samples));
    return share_ < 1.0 ? std::max(fewest_rows, part) : samples;
  }

  void tell(const std::string& label, const std::string& words) {
    comments_ += fmt::format("# panel {}, {}: {}\n", panel_,
                             label.empty() ? "a curve" : plain(label), words);
  }

  void row(const char* what, const std::string& name, double x, double y, double low = not_there,
           double high = not_there) {
    rows_ += fmt::format("{},{},{},{},{},{},{}\n", panel_, what, quoted(name),
                         x_->dates ? date(x) : number(x), number(y), number(low), number(high));
  }

  static constexpr double not_there = std::numeric_limits<double>::quiet_NaN();
  double share_;  ///< Of the samples that become rows.
  int panel_{};
  const render::figure::Axis* x_{};  ///< Of that panel.
  std::string comments_;
  std::string rows_;
};

}  // namespace

std::string figure_csv(const ReportFigure& figure, std::size_t most_rows) {
  if (figure.figure.panels.empty() || figure.figure.diagram) return "";
  return Writer(figure, most_rows).text();
}

std::vector<ReportFigure> figures_in(const wording::Language& language,
                                     const std::function<std::vector<ReportFigure>()>& make) {
  const auto made_in = [&make](const wording::Language& its) {
    const wording::WordsIn words(its);
    return make();
  };
  std::vector<ReportFigure> figures = made_in(language);
  if (!language.is_english()) take_english_data(made_in(wording::Language{}), figures);
  return figures;
}

void take_english_data(const std::vector<ReportFigure>& english,
                       std::vector<ReportFigure>& figures) {
  for (ReportFigure& figure : figures) {
    const auto same = std::find_if(english.begin(), english.end(),
                                   [&](const ReportFigure& one) { return one.id == figure.id; });
    if (same != english.end()) figure.english_csv = figure_csv(*same, most_csv_rows);
  }
}

}  // namespace tribolog::figures
