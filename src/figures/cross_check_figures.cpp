#include "figures/cross_check_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/requirements.h"
#include "figures/report_figure.h"
#include "truth/readings.h"
#include "wording/axis_scale.h"
#include "wording/labels.h"
#include "wording/number_text.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::figures {

namespace {

using wording::tr;
using wording::tr_count;

constexpr double apart = 0.12;  // of the two intervals of one way, of the distance of two

/// Bars and centres of one kind of interval.
void add_intervals(render::figure::Panel& panel,
                   const std::vector<method::intervals::CrossCheck>& checks, bool resampled,
                   const wording::AxisScale& scale) {
  const render::figure::Colour colour =
      resampled ? render::figure::palette::vermilion : render::figure::palette::blue;
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t k = 0; k < checks.size(); ++k) {
    if (resampled && !checks[k].resampled_kg) continue;
    const statistics::Estimate& mass =
        resampled ? present(checks[k].resampled_kg) : checks[k].mass_kg;
    if (!std::isfinite(mass.low) || !std::isfinite(mass.high)) continue;
    const double at = static_cast<double>(k + 1) + (resampled ? apart : -apart);
    x.push_back(at);
    y.push_back(scale(mass.value));
    panel.error_bars.push_back({at, scale(mass.low), scale(mass.high), colour});
  }
  render::figure::Series series =
      line(resampled ? tr("bootstrap") : tr("closed form"), std::move(x), std::move(y), colour, 2.5,
           render::figure::LineStyle::none);
  series.marker = resampled ? render::figure::Marker::square : render::figure::Marker::circle;
  series.marker_size_px = 12.0;
  add_visible(panel, std::move(series));
}

/// Of all masses with their intervals.
wording::Extent extent_of(const std::vector<method::intervals::CrossCheck>& checks) {
  wording::Extent extent;
  for (const method::intervals::CrossCheck& check : checks) {
    extent.add({check.mass_kg.low, check.mass_kg.high});
    if (check.resampled_kg) extent.add({check.resampled_kg->low, check.resampled_kg->high});
  }
  return extent;
}

}  // namespace

std::optional<ReportFigure> mass_comparison_figure(const calibration::Calibration& calibration) {
  const std::vector<method::intervals::CrossCheck>& checks = calibration.cross_checks.checks;
  if (checks.size() < 2) return std::nullopt;
  const auto recommended =
      std::find_if(checks.begin(), checks.end(),
                   [](const method::intervals::CrossCheck& c) { return c.is_recommended; });
  ReportFigure out;
  out.id = "fig-masses-by-way";
  out.is_primary = true;
  out.title = tr("Surrogate mass by every estimator");
  out.stage = "cross-checks";
  const wording::AxisScale scale = wording::levelled("kg", extent_of(checks));
  render::figure::Panel panel;
  panel.x.title = tr("estimator, numbered as below");
  panel.x.counts = true;
  panel.x.minimum = 0.5;
  panel.x.maximum = static_cast<double>(checks.size()) + 0.5;
  panel.y.title = wording::axis_title(tr("surrogate mass m"), scale, "kg");
  add_intervals(panel, checks, false, scale);
  add_intervals(panel, checks, true, scale);
  if (panel.series.empty()) return std::nullopt;
  if (recommended != checks.end()) {
    panel.reference_lines.push_back(
        {render::figure::ReferenceLine::Direction::horizontal, scale(recommended->mass_kg.value),
         "", render::figure::palette::grey, render::figure::LineStyle::dash});
  }
  out.figure.panels.push_back(std::move(panel));

  std::vector<std::string> names;
  std::size_t disagree = 0;
  for (std::size_t k = 0; k < checks.size(); ++k) {
    names.push_back(fmt::format(
        "{} {}", k + 1,
        wording::words_for("estimator", method::intervals::to_string(checks[k].method))));
    disagree += checks[k].disagrees ? 1 : 0;
  }
  const std::string agreement =
      disagree == 0
          ? tr("All agree with the recommended one within the interval of the difference.")
          : tr_count(static_cast<std::int64_t>(disagree),
                     "{ways} estimator disagrees with the recommended one beyond the interval of "
                     "the difference.",
                     "{ways} estimators disagree with the recommended one beyond the interval of "
                     "the difference.",
                     {{"ways", disagree}});
  const std::string ways = wording::listed(names);
  out.caption = tr("95 % intervals of {ways}.", {{"ways", ways}}) + " " + agreement;
  out.how_to_read =
      tr("Each estimator fails in a different way. In a sound measurement all bars cross the "
         "dashed line of the recommended one; one that misses it points to the assumption that it "
         "depends on. The two "
         "bars of an estimator should be equally long.");
  out.alt = tr("Surrogate mass with 95 % intervals by {count} estimators: {ways}.",
               {{"count", checks.size()}, {"ways", ways}}) +
            " " + agreement;
  return out;
}

namespace {

/// Further out than this a point stands at the edge: how far says no more than that it is out.
constexpr double farthest_shown = 5;
constexpr double least_shown = 2;  ///< The interval itself must not fill the picture.

/// Half widths to either side that hold all, up to farthest_shown.
double reach_of(const std::vector<const calibration::ReturnedQuantity*>& shown) {
  double reach = least_shown;
  for (const calibration::ReturnedQuantity* q : shown) {
    for (const double off : q->in_half_widths) {
      if (std::isfinite(off)) reach = std::max(reach, std::ceil(std::abs(off)));
    }
  }
  return std::min(reach, farthest_shown);
}

std::string place_words(const std::vector<const calibration::ReturnedQuantity*>& shown) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    words.push_back(
        fmt::format("{} {}", i + 1, wording::words_for("reading", to_string(shown[i]->name))));
  }
  return wording::listed(words);
}

}  // namespace

std::optional<ReportFigure> truth_check_figure(const calibration::Calibration& calibration) {
  const calibration::TruthCheckResult& check = calibration.truth_check;
  std::vector<const calibration::ReturnedQuantity*> shown;
  for (const calibration::ReturnedQuantity& q : check.quantities) {
    if (!q.in_half_widths.empty()) shown.push_back(&q);
  }
  if (shown.empty()) return std::nullopt;

  ReportFigure out;
  out.id = "fig-known-truth";
  out.title = tr("Recovery of the simulated values");
  out.stage = "known-truth";
  render::figure::Panel panel;
  panel.x.title =
      tr("deviation from the simulated value, in half widths of the stated 95 % interval");
  panel.y.title = tr("quantity");
  const double reach = reach_of(shown);
  panel.x.minimum = -reach - 0.5;
  panel.x.maximum = reach + 0.5;
  panel.y.minimum = 0.2;
  panel.y.maximum = static_cast<double>(shown.size()) + 0.8;
  panel.bands.push_back(
      {tr("within the interval"), {-1, 1}, {0.2, 0.2}, {*panel.y.maximum, *panel.y.maximum}});
  render::figure::Series inside;
  render::figure::Series outside;
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
      render::figure::Series& series = std::abs(off) <= 1 ? inside : outside;
      series.x.push_back(std::clamp(off, -farthest_shown, farthest_shown));
      series.y.push_back(row);
    }
    panel.y.names.push_back({level, wording::reading_label(to_string(shown[i]->name))});
  }
  inside.label = tr("within its interval");
  outside.label = tr("outside its interval");
  for (render::figure::Series* series : {&inside, &outside}) {
    series->style = render::figure::LineStyle::none;
    series->marker =
        series == &inside ? render::figure::Marker::circle : render::figure::Marker::cross;
    series->marker_size_px = series == &inside ? 8 : 12;
    series->colour =
        series == &inside ? render::figure::palette::blue : render::figure::palette::vermilion;
    add_visible(panel, std::move(*series));
  }
  out.figure.panels.push_back(std::move(panel));
  out.figure.height_px = std::max(600, 240 + 84 * static_cast<int>(shown.size()));
  const std::string quantities = place_words(shown);
  out.caption = tr_count(static_cast<std::int64_t>(check.runs),
                         "Deviations of {simulations} simulation in units of the half width stated "
                         "by each run: {held} of {values} lie within their intervals.",
                         "Deviations of {simulations} simulations in units of the half width "
                         "stated by each run: {held} of {values} lie within their intervals.",
                         {{"simulations", check.runs}, {"held", held}, {"values", all}}) +
                " " + tr("From top: {quantities}", {{"quantities", quantities}});
  out.how_to_read =
      tr("Each mark is one simulation of what was identified, at the noise that was found. Between "
         "−1 and 1 its interval contains the simulated value: about 19 of 20 should. A row that "
         "lies to one side is biased on these motions; one that spreads wider has intervals that "
         "are too narrow.");
  if (reach >= farthest_shown) {
    out.how_to_read +=
        " " + tr("Marks at ±{half_widths:.0f} lie there or beyond.", {{"half_widths", reach}});
  }
  out.alt =
      tr("{held} of {values} recovered values lie within their stated intervals: {quantities}.",
         {{"held", held}, {"values", all}, {"quantities", quantities}});
  return out;
}

}  // namespace tribolog::figures
