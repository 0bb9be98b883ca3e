#include "figures/truth_check_figure.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "figures/plot_data.h"
#include "truth/readings.h"
#include "wording/number_text.h"
#include "wording/reading_label.h"

namespace tribolog::figures {
namespace {

/// Further out than this a point stands at the edge: how far says no more than that it is out.
constexpr double farthest_shown = 5;
constexpr double least_shown = 2;  ///< The interval itself must not fill the picture.

/// Half widths to either side that hold all, up to farthest_shown.
double reach_of(const std::vector<const ReturnedQuantity*>& shown) {
  double reach = least_shown;
  for (const ReturnedQuantity* q : shown) {
    for (const double off : q->in_half_widths) {
      if (std::isfinite(off)) reach = std::max(reach, std::ceil(std::abs(off)));
    }
  }
  return std::min(reach, farthest_shown);
}

std::string place_words(const std::vector<const ReturnedQuantity*>& shown) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    words.push_back(fmt::format("{} {}", i + 1, reading_words(shown[i]->name)));
  }
  return listed(words);
}

}  // namespace

std::optional<ReportFigure> truth_check_figure(const Calibration& calibration) {
  const TruthCheckResult& check = calibration.truth_check;
  std::vector<const ReturnedQuantity*> shown;
  for (const ReturnedQuantity& q : check.quantities) {
    if (!q.in_half_widths.empty()) shown.push_back(&q);
  }
  if (shown.empty()) return std::nullopt;

  ReportFigure out;
  out.id = "fig-known-truth";
  out.title = "What came back of what was put in";
  out.stage = "known-truth";
  render::Panel panel;
  panel.x.title = "deviation from what was put in, in half widths of the stated 95 % interval";
  panel.y.title = "quantity";
  const double reach = reach_of(shown);
  panel.x.minimum = -reach - 0.5;
  panel.x.maximum = reach + 0.5;
  panel.y.minimum = 0.2;
  panel.y.maximum = static_cast<double>(shown.size()) + 0.8;
  panel.bands.push_back(
      {"inside the interval", {-1, 1}, {0.2, 0.2}, {*panel.y.maximum, *panel.y.maximum}});
  render::Series inside;
  render::Series outside;
  std::size_t held = 0;
  std::size_t all = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    // The first quantity on top.
    const double level = static_cast<double>(shown.size() - i);
    held += shown[i]->inside;
    all += shown[i]->found;
    for (std::size_t k = 0; k < shown[i]->in_half_widths.size(); ++k) {
      const double off = shown[i]->in_half_widths[k];
      if (!std::isfinite(off)) continue;
      // Runs above one another within the row, so that equal deviations stay apart.
      const double row = level +
                         0.5 * (static_cast<double>(k) + 0.5) /
                             static_cast<double>(shown[i]->in_half_widths.size()) -
                         0.25;
      render::Series& series = std::abs(off) <= 1 ? inside : outside;
      series.x.push_back(std::clamp(off, -farthest_shown, farthest_shown));
      series.y.push_back(row);
    }
    panel.y.names.push_back({level, reading_label(shown[i]->name)});
  }
  inside.label = "held by its interval";
  outside.label = "not held";
  for (render::Series* series : {&inside, &outside}) {
    series->style = render::LineStyle::none;
    series->marker = series == &inside ? render::Marker::circle : render::Marker::cross;
    series->marker_size_px = series == &inside ? 8 : 12;
    series->colour = series == &inside ? render::palette::blue : render::palette::vermilion;
    add_visible(panel, std::move(*series));
  }
  out.figure.panels.push_back(std::move(panel));
  out.figure.height_px = std::max(600, 240 + 84 * static_cast<int>(shown.size()));
  out.caption = fmt::format(
      "Deviations of {} in units of the half width that each run states for itself: "
      "{} of {} are held by their intervals. From top: {}",
      counted(check.runs, "simulation"), held, all, place_words(shown));
  out.how_to_read =
      "One mark is one simulation of what was identified, at the noise that was found. Between −1 "
      "and 1 its interval holds what was put in: about 19 of 20 should. A row that lies to one "
      "side "
      "is biased on these motions; one that spreads wider has intervals that are too narrow.";
  if (reach >= farthest_shown) {
    out.how_to_read += fmt::format(" Marks at ±{:.0f} lie there or beyond.", reach);
  }
  out.alt = fmt::format("{} of {} returned values lie within their stated intervals: {}.", held,
                        all, place_words(shown));
  return out;
}

}  // namespace tribolog::figures
