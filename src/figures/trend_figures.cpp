#include "figures/trend_figures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "figures/history_axes.h"
#include "figures/plot_data.h"
#include "figures/trend_panels.h"
#include "statistics/student_t.h"
#include "wording/number_text.h"

namespace tribolog {
namespace {

using figures::AxisScale;
using history::FoundChange;
using history::HistoryPoint;
using history::LeftOut;
using history::QuantityTrend;

std::string change_words(const FoundChange& change, const AxisScale& scale) {
  const std::string size = change.percent ? fmt::format("{:.2g} %", std::abs(*change.percent))
                                          : figures::with_unit(std::abs(change.size.value),
                                                               {scale.factor, scale.unit}, 2);
  if (change.is_slow) {
    return fmt::format("slowly {} by {} since {}, visible from {}",
                       change.direction > 0 ? "risen" : "fallen", size,
                       figures::date_of(change.from), figures::date_of(change.alarm));
  }
  std::string words =
      fmt::format("{} by {}, visible from {}, alarm {}", change.direction > 0 ? "risen" : "fallen",
                  size, figures::date_of(change.from), figures::date_of(change.alarm));
  if (!change.back.empty()) words += ", back from " + figures::date_of(change.back);
  return words;
}

std::string caption_of(const QuantityTrend& trend, const AxisScale& scale) {
  const std::size_t used = trend.count(LeftOut::none);
  std::string caption = trend.words + ": ";
  if (trend.state == history::TrendState::too_few) {
    caption += fmt::format("{} that can be used, too few to say anything yet",
                           figures::counted(used, "calibration"));
  } else if (trend.changes.empty()) {
    caption += fmt::format("no change visible over {}", figures::counted(used, "calibration"));
  } else {
    std::vector<std::string> changes;
    for (const FoundChange& change : trend.changes) changes.push_back(change_words(change, scale));
    for (std::size_t k = 0; k < changes.size(); ++k) caption += (k > 0 ? "; " : "") + changes[k];
  }
  if (trend.reference) {
    caption += fmt::format(
        ". Reference {} from {}",
        figures::with_interval(
            symmetric_estimate(trend.reference->level,
                               normal_975 * std::sqrt(trend.reference->level_variance), ""),
            scale),
        figures::counted(trend.reference->members, "calibration"));
  }
  return caption + ".";
}

ReportFigure figure_of(const QuantityTrend& trend, std::string id) {
  figures::Extent extent;
  for (const HistoryPoint& p : trend.points) {
    extent.add(p.estimate.low);
    extent.add(p.estimate.high);
  }
  const AxisScale scale = figures::quantity_axis(trend.unit, extent.largest());
  ReportFigure out;
  out.id = std::move(id);
  out.title = trend.words + " over time";
  out.stage = "trend";
  out.figure.panels.push_back(figures::trend_panel(trend, scale));
  if (trend.judged > 0) out.figure.panels.push_back(figures::sum_panel(trend));
  out.figure.panels_share_x = true;
  out.figure.height_px = trend.judged > 0 ? 1200 : 750;
  out.figure.id = out.id;
  out.figure.title = out.title;
  out.caption = caption_of(trend, scale);
  out.how_to_read =
      "Above, points that leave the band to one side for good are a change; single ones are not. ";
  if (figures::is_visibly_corrected(trend)) {
    out.how_to_read += "All but the plus signs are brought to one temperature. ";
  }
  if (trend.judged > 0) {
    out.how_to_read +=
        "Below, a sum that climbs to its limit is the alarm; the change began where the climb did. "
        "Behind the "
        "alarm it is drawn up to twice the limit.";
  }
  out.alt = fmt::format("{} over time from {} to {}. {}", trend.words,
                        figures::date_of(trend.points.front().measured_at),
                        figures::date_of(trend.points.back().measured_at), out.caption);
  return out;
}

/// Those with a change that stands first.
std::vector<std::size_t> by_weight(const std::vector<QuantityTrend>& quantities) {
  std::vector<std::size_t> order(quantities.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return quantities[a].state > quantities[b].state;
  });
  return order;
}

}  // namespace

std::vector<ReportFigure> trend_figures(const std::vector<history::JointTrend>& trends) {
  std::vector<ReportFigure> all;
  for (std::size_t j = 0; j < trends.size(); ++j) {
    const std::vector<QuantityTrend>& quantities = trends[j].quantities;
    for (const std::size_t q : by_weight(quantities)) {
      if (quantities[q].points.empty()) continue;
      all.push_back(figure_of(quantities[q], fmt::format("trend-{}-{}", j + 1, q + 1)));
    }
  }
  return all;
}

}  // namespace tribolog
