#include "figures/mass_comparison.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/present.h"
#include "figures/plot_data.h"
#include "wording/axis_scale.h"
#include "wording/number_text.h"

namespace tribolog::figures {
namespace {

constexpr double apart = 0.12;  // of the two intervals of one way, of the distance of two

/// Bars and centres of one kind of interval.
void add_intervals(render::Panel& panel, const std::vector<CrossCheck>& checks, bool resampled,
                   const AxisScale& scale) {
  const render::Colour colour = resampled ? render::palette::vermilion : render::palette::blue;
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t k = 0; k < checks.size(); ++k) {
    if (resampled && !checks[k].resampled_kg) continue;
    const Estimate& mass = resampled ? present(checks[k].resampled_kg) : checks[k].mass_kg;
    if (!std::isfinite(mass.low) || !std::isfinite(mass.high)) continue;
    const double at = static_cast<double>(k + 1) + (resampled ? apart : -apart);
    x.push_back(at);
    y.push_back(scale(mass.value));
    panel.error_bars.push_back({at, scale(mass.low), scale(mass.high), colour});
  }
  render::Series series = line(resampled ? "bootstrap" : "closed form", std::move(x), std::move(y),
                               colour, 2.5, render::LineStyle::none);
  series.marker = resampled ? render::Marker::square : render::Marker::circle;
  series.marker_size_px = 12.0;
  add_visible(panel, std::move(series));
}

/// The largest |value - recommended| plus interval among those shown in full.
Extent extent_without(const std::vector<CrossCheck>& checks, const std::string& left_out) {
  Extent extent;
  for (const CrossCheck& check : checks) {
    if (check.method == left_out) continue;
    extent.add({check.mass_kg.low, check.mass_kg.high});
    if (check.resampled_kg) extent.add({check.resampled_kg->low, check.resampled_kg->high});
  }
  return extent;
}

}  // namespace

std::optional<ReportFigure> mass_comparison_figure(const Calibration& calibration) {
  const std::vector<CrossCheck>& checks = calibration.cross_checks.checks;
  if (checks.size() < 2) return std::nullopt;
  const auto recommended = std::find_if(checks.begin(), checks.end(),
                                        [](const CrossCheck& c) { return c.is_recommended; });
  ReportFigure out;
  out.id = "fig-masses-by-way";
  out.title = "Surrogate mass by every way";
  out.stage = "cross-checks";
  const AxisScale scale = levelled("kg", extent_without(checks, ""));
  render::Panel panel;
  panel.x.title = "way, numbered as below";
  panel.x.counts = true;
  panel.x.minimum = 0.5;
  panel.x.maximum = static_cast<double>(checks.size()) + 0.5;
  panel.y.title = axis_title("surrogate mass m", scale, "kg");
  add_intervals(panel, checks, false, scale);
  add_intervals(panel, checks, true, scale);
  if (panel.series.empty()) return std::nullopt;
  if (recommended != checks.end()) {
    panel.reference_lines.push_back({render::ReferenceLine::Direction::horizontal,
                                     scale(recommended->mass_kg.value), "recommended",
                                     render::palette::grey, render::LineStyle::dash});
  }
  out.figure.panels.push_back(std::move(panel));

  std::vector<std::string> names;
  std::size_t disagree = 0;
  for (std::size_t k = 0; k < checks.size(); ++k) {
    names.push_back(fmt::format("{} {}", k + 1, method_in_words(checks[k].method)));
    disagree += checks[k].disagrees ? 1 : 0;
  }
  const std::string agreement =
      disagree == 0
          ? "All agree with the recommended one within the interval of the difference."
          : fmt::format(
                "{} with the recommended one beyond the interval of the "
                "difference.",
                disagree == 1 ? "1 way disagrees" : fmt::format("{} ways disagree", disagree));
  out.caption = fmt::format("95 % intervals of {}. {}", listed(names), agreement);
  out.how_to_read =
      "Each way fails differently. Bars that all cross the dashed line are what a sound "
      "measurement gives; one that lies beside it points at the assumption it rests on. The two "
      "bars of a way should be equally long.";
  out.alt = fmt::format("Surrogate mass with 95 % intervals by {} ways: {}. {}", checks.size(),
                        listed(names), agreement);
  return out;
}

}  // namespace tribolog::figures
