#include "figures/cross_check_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/requirements.h"
#include "figures/estimator_style.h"
#include "figures/outliers.h"
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

constexpr double beyond = 1.3;       // of the reach of the many: where the axis ends
constexpr double arrow_share = 0.1;  // of the axis

using method::selection::CrossCheck;

/// Of all masses with their intervals.
wording::Extent extent_of(const std::vector<CrossCheck>& checks) {
  wording::Extent extent;
  for (const CrossCheck& check : checks) {
    extent.add({check.mass_kg.low, check.mass_kg.high});
  }
  return extent;
}

/// What the axis shows: all intervals, or those about the middle one if a few reach far beyond.
wording::Extent shown_extent(const std::vector<CrossCheck>& checks, double middle_kg) {
  const wording::Extent all = extent_of(checks);
  std::vector<double> distances;
  for (const CrossCheck& check : checks) {
    wording::Extent one = extent_of({check});
    if (one.empty) continue;
    distances.push_back(std::max(std::abs(one.low - middle_kg), std::abs(one.high - middle_kg)));
  }
  const double reach = beyond * reach_of_the_many(std::move(distances));
  if (!(reach > 0.0)) return all;
  return {std::max(all.low, middle_kg - reach), std::min(all.high, middle_kg + reach), false};
}

/// Intervals as bars from left to right, a row each, the first on top; what reaches beyond the
/// extent ends in an arrow.
class MassRows {
 public:
  MassRows(render::figure::Panel& panel, const wording::Extent& extent,
           const wording::AxisScale& scale)
      : panel_(panel), extent_(extent), scale_(scale) {}

  void add(const std::vector<CrossCheck>& checks) {
    const render::figure::Colour colour = render::figure::palette::blue;
    render::figure::Series centres = line("", {}, {}, colour, 2.5, render::figure::LineStyle::none);
    centres.marker = render::figure::Marker::circle;
    centres.marker_size_px = 14.0;
    for (std::size_t k = 0; k < checks.size(); ++k) {
      const statistics::Estimate& mass = checks[k].mass_kg;
      if (!std::isfinite(mass.low) || !std::isfinite(mass.high)) continue;
      const double row = static_cast<double>(checks.size() - k);
      add_interval(mass, row, colour);
      if (mass.value >= extent_.low && mass.value <= extent_.high) {
        centres.x.push_back(scale_(mass.value));
        centres.y.push_back(row);
      }
      const bool is_cut = mass.low < extent_.low || mass.high > extent_.high;
      if (is_cut) name_value(mass, row);
    }
    add_visible(panel_, std::move(centres));
  }

 private:
  void add_interval(const statistics::Estimate& mass, double row, render::figure::Colour colour) {
    const double arrow = arrow_share * extent_.span();
    double low = std::clamp(mass.low, extent_.low, extent_.high - arrow);
    double high = std::clamp(mass.high, extent_.low + arrow, extent_.high);
    if (mass.low < extent_.low) {
      add_arrow(low + arrow, low, row, colour);
      low += arrow;
    }
    if (mass.high > extent_.high) {
      add_arrow(high - arrow, high, row, colour);
      high -= arrow;
    }
    if (mass.low > extent_.high || mass.high < extent_.low) return;
    // Narrower than the marker, it would be hidden.
    constexpr double marker_share = 0.03;
    if (high - low < marker_share * extent_.span()) return;
    add_visible(panel_, line("", {scale_(low), scale_(high)}, {row, row}, colour, 4.0));
  }

  void add_arrow(double from, double to, double row, render::figure::Colour colour) {
    render::figure::Series arrow = line("", {scale_(from), scale_(to)}, {row, row}, colour, 4.0);
    arrow.direction_arrows_at = {1.0};
    add_visible(panel_, std::move(arrow));
  }

  void name_value(const statistics::Estimate& mass, double row) {
    add_visible(panel_, render::figure::PointLabel{
                            scale_(std::clamp(mass.value, extent_.low, extent_.high)), row,
                            wording::with_interval(mass, wording::AxisScale{1.0, "kg"}),
                            render::figure::palette::black, render::figure::Marker::none});
  }

  render::figure::Panel& panel_;
  const wording::Extent extent_;
  const wording::AxisScale& scale_;
};

}  // namespace

std::optional<ReportFigure> mass_comparison_figure(const calibration::Calibration& calibration) {
  const std::vector<method::selection::CrossCheck>& checks = calibration.cross_checks.checks;
  if (checks.size() < 2) return std::nullopt;
  const auto recommended =
      std::find_if(checks.begin(), checks.end(),
                   [](const method::selection::CrossCheck& c) { return c.is_recommended; });
  ReportFigure out;
  out.id = "fig-masses-by-way";
  out.is_primary = true;
  out.title = tr("Surrogate mass by every estimator");
  out.stage = "cross-checks";
  const double middle_kg =
      recommended == checks.end() ? checks.front().mass_kg.value : recommended->mass_kg.value;
  const wording::Extent extent = shown_extent(checks, middle_kg);
  const wording::AxisScale scale = wording::levelled("kg", extent);
  render::figure::Panel panel;
  panel.x.title = wording::axis_title(tr("surrogate mass m"), scale, "kg");
  panel.y.title = tr("estimator");
  panel.y.minimum = 0.4;
  panel.y.maximum = static_cast<double>(checks.size()) + 0.6;
  if (extent.span() > 0.0) {
    panel.x.minimum = scale(extent.low - 0.04 * extent.span());
    panel.x.maximum = scale(extent.high + 0.04 * extent.span());
  }
  for (std::size_t k = 0; k < checks.size(); ++k) {
    panel.y.names.push_back(
        {static_cast<double>(checks.size() - k), estimator_words(checks[k].estimator)});
  }
  MassRows rows(panel, extent, scale);
  rows.add(checks);
  if (panel.series.empty()) return std::nullopt;
  if (recommended != checks.end()) {
    panel.reference_lines.push_back(
        {render::figure::ReferenceLine::Direction::vertical, scale(recommended->mass_kg.value), "",
         render::figure::palette::grey, render::figure::LineStyle::dash});
  }
  out.figure.panels.push_back(std::move(panel));
  out.figure.height_px = std::max(600, 260 + 84 * static_cast<int>(checks.size()));

  std::vector<std::string> names;
  std::size_t disagree = 0;
  for (std::size_t k = 0; k < checks.size(); ++k) {
    names.push_back(wording::words_for("estimator", to_string(checks[k].estimator)));
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
  out.caption = tr("95 % intervals, from the top: {ways}.", {{"ways", ways}}) + " " + agreement;
  out.how_to_read =
      tr("Each estimator fails in a different way. In a sound measurement all bars cross the "
         "dashed line of the recommended one; one that misses it points to the assumption that it "
         "depends on. A bar with an arrow goes on beyond the axis; its value stands beside it.");
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
