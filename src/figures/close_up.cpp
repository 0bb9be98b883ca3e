#include "figures/close_up.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "figures/estimator_style.h"
#include "figures/run_curves.h"
#include "wording/labels.h"
#include "wording/number_text.h"
#include "wording/tr.h"

namespace tribolog::figures {
namespace {

using method::hysteresis::Estimator;
using wording::tr;

constexpr double room = 2.0;              // of the chosen curves' largest value: neighbours come in
constexpr double worthwhile = 2.0;        // times larger must the whole be for a close-up
constexpr double resolved_share = 0.008;  // of an axis: about one line width

constexpr std::array unbiased{Estimator::midline, Estimator::fit, Estimator::sweep,
                              Estimator::model,   Estimator::AB,  Estimator::CD,
                              Estimator::EF};

std::ptrdiff_t rank(Estimator estimator) {
  return std::find(unbiased.begin(), unbiased.end(), estimator) - unbiased.begin();
}

bool may_be_merged(Estimator estimator) {
  return estimator != unbiased.front() && rank(estimator) < std::ssize(unbiased);
}

/// Infinite where they have no run in common.
double largest_distance(const std::vector<double>& one, const std::vector<double>& other) {
  wording::Extent distances;
  for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) {
    distances.add(one[i] - other[i]);
  }
  return distances.empty ? std::numeric_limits<double>::infinity() : distances.largest();
}

/// Takes off the curve's values on each side of standstill where none lies within the limit.
/// @return the name of what was left out; empty: nothing.
std::string leave_out_outside(const method::viscous::ViscousCurvesResult& viscous, double limit,
                              NamedValues& curve) {
  const std::size_t size = std::min(viscous.runs.size(), curve.values.size());
  std::optional<bool> positive_side_left_out;
  bool any_left = false;
  for (const bool positive : {true, false}) {
    wording::Extent distances;
    for (std::size_t i = 0; i < size; ++i) {
      if ((viscous.runs[i].speed_rad_s > 0.0) == positive) distances.add(std::abs(curve.values[i]));
    }
    if (distances.empty) continue;
    any_left = any_left || distances.low <= limit;
    if (distances.low <= limit) continue;
    positive_side_left_out = positive;
    for (std::size_t i = 0; i < size; ++i) {
      if ((viscous.runs[i].speed_rad_s > 0.0) == positive) curve.values[i] = NAN;
    }
  }
  if (!positive_side_left_out) return {};
  const std::string estimator = estimator_words(curve.estimator);
  if (!any_left) return estimator;
  return *positive_side_left_out ? tr("{estimator} (forward)", {{"estimator", estimator}})
                                 : tr("{estimator} (backward)", {{"estimator", estimator}});
}

}  // namespace

std::vector<NamedValues> in_drawing_order(std::vector<NamedValues> curves, double span) {
  std::stable_sort(curves.begin(), curves.end(), [](const auto& one, const auto& other) {
    return rank(one.estimator) < rank(other.estimator);
  });
  std::vector<NamedValues> drawn;
  for (NamedValues& curve : curves) {
    const auto twin = std::find_if(drawn.begin(), drawn.end(), [&](const NamedValues& before) {
      return may_be_merged(curve.estimator) &&
             largest_distance(curve.values, before.values) < resolved_share * span;
    });
    if (twin == drawn.end()) {
      drawn.push_back(std::move(curve));
    } else {
      const bool is_pair = method::hysteresis::points_of_pair(curve.estimator).has_value();
      twin->same.push_back(is_pair ? to_string(curve.estimator) : estimator_words(curve.estimator));
    }
  }
  return drawn;
}

std::string legend_words(const calibration::Calibration& calibration, const NamedValues& curve) {
  const std::string words = candidate_words(calibration, curve.estimator);
  return curve.same.empty() ? words : words + " = " + wording::listed(curve.same);
}

void share_legend(const render::figure::Panel& upper, render::figure::Panel& lower) {
  lower.show_legend = std::any_of(
      lower.series.begin(), lower.series.end(), [&](const render::figure::Series& series) {
        return std::none_of(upper.series.begin(), upper.series.end(),
                            [&](const auto& known) { return known.label == series.label; });
      });
}

double close_up_limit(const std::vector<NamedValues>& curves,
                      const method::selection::SelectionResult& selection) {
  wording::Extent chosen;
  wording::Extent all;
  for (const NamedValues& curve : curves) {
    all.add(curve.values);
    const bool matters =
        curve.estimator == selection.paper_rule || curve.estimator == selection.recommended;
    if (matters) chosen.add(curve.values);
  }
  const double limit = room * chosen.largest();
  return limit > 0.0 && all.largest() >= worthwhile * limit ? limit : 0.0;
}

render::figure::Panel close_up_panel(const calibration::Calibration& calibration,
                                     std::vector<NamedValues> curves, double limit,
                                     const std::string& quantity, const std::string& si_unit) {
  wording::Extent all;
  for (const NamedValues& curve : curves) all.add(curve.values);
  const double largest = limit > 0.0 ? limit : all.largest();
  const wording::AxisScale scale =
      si_unit == "%" ? wording::AxisScale{1.0, "%"}
                     : wording::prefixed(si_unit, std::max(largest, wording::torque_floor_Nm));
  render::figure::Panel panel;
  const double nothing = si_unit == "%" ? wording::percent_floor : wording::torque_floor_Nm;
  if (limit <= 0.0 && largest < nothing) {
    // No difference at all: the axis must not enlarge the computer's rounding.
    panel.y.minimum = -scale(nothing);
    panel.y.maximum = scale(nothing);
  }
  panel.x.title = wording::speed_quantity(calibration.manifest) + " [rad/s]";
  panel.y.title = wording::axis_title(quantity, scale);
  if (limit > 0.0) {
    panel.y.minimum = -scale(limit);
    panel.y.maximum = scale(limit);
    panel.title = tr("Close-up");
    std::vector<std::string> outside;
    for (NamedValues& curve : curves) {
      const std::string name = leave_out_outside(calibration.viscous, limit, curve);
      if (!name.empty()) outside.push_back(name);
    }
    if (!outside.empty()) {
      panel.title =
          tr("Close-up; outside: {candidates}", {{"candidates", wording::listed(outside)}});
    }
  }
  const double span = limit > 0.0 ? 2 * limit : std::max(all.span(), nothing);
  for (const NamedValues& curve : in_drawing_order(std::move(curves), span)) {
    add_run_curve(panel, calibration.viscous, estimator_style(curve.estimator),
                  legend_words(calibration, curve), curve.values, scale);
  }
  panel.reference_lines.push_back({render::figure::ReferenceLine::Direction::horizontal, 0.0, "",
                                   render::figure::palette::black,
                                   render::figure::LineStyle::solid});
  return panel;
}

}  // namespace tribolog::figures
