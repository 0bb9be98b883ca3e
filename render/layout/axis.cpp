#include "render/layout/axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tribolog::render::layout {

namespace {

constexpr double largest_magnitude = 1e300;
constexpr double farthest_pixel = 1e9;

/// Where a value lies along an axis, before it is scaled to pixels.
double along(double value, bool logarithmic, double linear_within) {
  if (logarithmic) return std::log10(value);
  return linear_within > 0 ? std::asinh(value / linear_within) : value;
}

}  // namespace

bool drawable(double value, bool logarithmic) {
  if (!(std::abs(value) <= largest_magnitude)) return false;
  return !logarithmic || value >= 1.0 / largest_magnitude;
}

AxisMap::AxisMap(AxisRange range, const figure::Axis& axis, double pixel_low, double pixel_high)
    : range_(range),
      logarithmic_(axis.logarithmic),
      linear_within_(axis.linear_within),
      origin_(along(range.low, logarithmic_, linear_within_)),
      pixel_low_(pixel_low),
      scale_((pixel_high - pixel_low) /
             (along(range.high, logarithmic_, linear_within_) - origin_)) {}

double AxisMap::pixel(double value) const {
  const double from_low = along(value, logarithmic_, linear_within_) - origin_;
  return std::clamp(pixel_low_ + from_low * scale_, -farthest_pixel, farthest_pixel);
}

namespace {

constexpr double constant_margin = 0.05;  // of the value
constexpr double negligible = 1e-290;     // nothing measured is smaller; its inverse is finite
constexpr double resolved_steps = 4.0;    // representable numbers that a range must hold

/// Only points that are drawable in both coordinates count.
template <typename Add>
void for_each_point(const figure::Panel& panel, const Add& add) {
  const auto offer = [&](double x, double y) {
    if (drawable(x, panel.x.logarithmic) && drawable(y, panel.y.logarithmic)) add(x, y);
  };
  for (const figure::Series& one : panel.series) {
    for (std::size_t i = 0; i < std::min(one.x.size(), one.y.size()); ++i) {
      offer(one.x[i], one.y[i]);
    }
  }
  for (const figure::Band& band : panel.bands) {
    for (std::size_t i = 0; i < std::min({band.x.size(), band.low.size(), band.high.size()}); ++i) {
      offer(band.x[i], band.low[i]);
      offer(band.x[i], band.high[i]);
    }
  }
  for (const figure::ErrorBar& bar : panel.error_bars) {
    offer(bar.x, bar.low);
    offer(bar.x, bar.high);
  }
  for (const figure::PointLabel& label : panel.point_labels) offer(label.x, label.y);
}

void add_reference_lines(const figure::Panel& panel, figure::ReferenceLine::Direction direction,
                         DataExtent& extent) {
  for (const figure::ReferenceLine& line : panel.reference_lines) {
    if (line.direction == direction) extent.add(line.at);
  }
}

double spacing_at(double value) {
  return std::nextafter(std::abs(value), std::numeric_limits<double>::max()) - std::abs(value);
}

AxisRange around_constant(double value, bool logarithmic) {
  if (logarithmic) return {value / 10.0, value * 10.0};
  const double half = value == 0.0 ? 1.0 : std::abs(value) * constant_margin;
  return {value - half, value + half};
}

AxisRange with_margin(const DataExtent& extent, const figure::Axis& axis, double share) {
  const bool logarithmic = axis.logarithmic;
  if (extent.empty()) return logarithmic ? AxisRange{1.0, 10.0} : AxisRange{0.0, 1.0};
  const double low = extent.low();
  const double high = extent.high();
  const double magnitude = std::max(std::abs(low), std::abs(high));
  if (!logarithmic && magnitude < negligible) return {-1.0, 1.0};
  if (high - low < resolved_steps * spacing_at(magnitude)) {
    return around_constant(low, logarithmic);
  }
  if (logarithmic) {
    const double factor = std::pow(high / low, share);
    return {low / factor, high * factor};
  }
  if (axis.linear_within > 0) {
    const double first = along(low, false, axis.linear_within);
    const double last = along(high, false, axis.linear_within);
    const double margin = (last - first) * share;
    return {axis.linear_within * std::sinh(first - margin),
            axis.linear_within * std::sinh(last + margin)};
  }
  return {low - (high - low) * share, high + (high - low) * share};
}

}  // namespace

void DataExtent::add(double value) {
  if (!drawable(value, logarithmic_)) return;
  low_ = std::min(low_, value);
  high_ = std::max(high_, value);
}

void DataExtent::add(const DataExtent& other) {
  if (other.empty()) return;
  add(other.low_);
  add(other.high_);
}

DataExtent x_extent(const figure::Panel& panel) {
  DataExtent extent(panel.x.logarithmic);
  for_each_point(panel, [&](double x, double) { extent.add(x); });
  add_reference_lines(panel, figure::ReferenceLine::Direction::vertical, extent);
  return extent;
}

DataExtent y_extent(const figure::Panel& panel) {
  DataExtent extent(panel.y.logarithmic);
  for_each_point(panel, [&](double, double y) { extent.add(y); });
  add_reference_lines(panel, figure::ReferenceLine::Direction::horizontal, extent);
  return extent;
}

AxisRange choose_range(const DataExtent& extent, const figure::Axis& axis, double margin_share,
                       std::vector<Statement>& warnings) {
  const AxisRange free = with_margin(extent, axis, margin_share);
  const auto usable = [&](const std::optional<double>& end) {
    if (!end) return false;
    if (drawable(*end, axis.logarithmic)) return true;
    warnings.push_back({"drawing.axis_end_ignored", {{"axis", axis.title}}});
    return false;
  };
  const bool fixed_low = usable(axis.minimum);
  const bool fixed_high = usable(axis.maximum);
  AxisRange range{fixed_low ? axis.minimum.value_or(free.low) : free.low,
                  fixed_high ? axis.maximum.value_or(free.high) : free.high};
  const double magnitude = std::max(std::abs(range.low), std::abs(range.high));
  const double least = std::max(resolved_steps * spacing_at(magnitude), negligible);
  if (range.high - range.low >= least) return range;
  if (fixed_low && fixed_high) {
    warnings.push_back({"drawing.axis_ends_ignored", {{"axis", axis.title}}});
    return free;
  }
  return fixed_low ? AxisRange{range.low, around_constant(range.low, axis.logarithmic).high}
                   : AxisRange{around_constant(range.high, axis.logarithmic).low, range.high};
}

}  // namespace tribolog::render::layout
