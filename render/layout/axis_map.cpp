#include "render/layout/axis_map.h"

#include <algorithm>
#include <cmath>

namespace tribolog::render {
namespace {

constexpr double largest_magnitude = 1e300;
constexpr double farthest_pixel = 1e9;

}  // namespace

bool drawable(double value, bool logarithmic) {
  if (!(std::abs(value) <= largest_magnitude)) return false;
  return !logarithmic || value >= 1.0 / largest_magnitude;
}

AxisMap::AxisMap(AxisRange range, bool logarithmic, double pixel_low, double pixel_high)
    : range_(range), logarithmic_(logarithmic), pixel_low_(pixel_low) {
  origin_ = logarithmic ? std::log10(range.low) : range.low;
  const double end = logarithmic ? std::log10(range.high) : range.high;
  scale_ = (pixel_high - pixel_low) / (end - origin_);
}

double AxisMap::pixel(double value) const {
  const double along = (logarithmic_ ? std::log10(value) : value) - origin_;
  return std::clamp(pixel_low_ + along * scale_, -farthest_pixel, farthest_pixel);
}

}  // namespace tribolog::render
