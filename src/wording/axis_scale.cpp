#include "wording/axis_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "joint/degrees.h"
#include "wording/number_text.h"
#include "wording/torques_in.h"

namespace tribolog::wording {
namespace {

constexpr double smallest_shown = 0.5;
constexpr double flat_share = 2e-3;  // of the level: ticks would need five digits and more

struct Prefix {
  const char* name;
  double factor;
};
constexpr std::array<Prefix, 4> prefixes{{{"", 1.0}, {"m", 1e3}, {"µ", 1e6}, {"n", 1e9}}};

/// The offset without the zeros that its rounding left at the end.
std::string level_text(const AxisScale& scale) {
  const double digits = std::log10(std::abs(scale.offset) * scale.factor) + 1;
  std::string text =
      significant(std::abs(scale.offset), std::clamp(static_cast<int>(digits), 2, 12));
  if (text.find('.') == std::string::npos || text.find('e') != std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

void Extent::add(double value) {
  if (!std::isfinite(value)) return;
  low = empty ? value : std::min(low, value);
  high = empty ? value : std::max(high, value);
  empty = false;
}

void Extent::add(const std::vector<double>& values) {
  for (const double value : values) add(value);
}

double Extent::largest() const { return empty ? 0.0 : std::max(std::abs(low), std::abs(high)); }

Extent extent_of(const std::vector<double>& values) {
  Extent extent;
  extent.add(values);
  return extent;
}

AxisScale prefixed(const std::string& si_unit, double largest) {
  const std::string unit = shown_units(si_unit);
  const double magnitude = std::abs(largest);
  if (!std::isfinite(magnitude) || magnitude == 0.0) return {1.0, unit};
  for (const Prefix& prefix : prefixes) {
    if (magnitude * prefix.factor >= smallest_shown) return {prefix.factor, prefix.name + unit};
  }
  return {prefixes.back().factor, prefixes.back().name + unit};
}

AxisScale degrees() { return {joint::degrees_per_rad, "°"}; }

AxisScale levelled(const std::string& si_unit, const Extent& extent) {
  const double span = extent.span();
  const double level = extent.largest();
  if (!(span > 0.0) || span >= flat_share * level) return prefixed(si_unit, level);
  const double grain = std::pow(10.0, std::ceil(std::log10(span)));
  AxisScale scale = prefixed(si_unit, span);
  scale.offset = std::round((extent.low + extent.high) / 2 / grain) * grain;
  return scale;
}

std::string axis_title(const std::string& quantity_and_symbol, const AxisScale& scale,
                       const std::string& si_unit) {
  std::string title = quantity_and_symbol;
  if (scale.offset != 0.0) {
    title += scale.offset > 0.0 ? " − " : " + ";
    title += level_text(scale) + " " + shown_units(si_unit);
  }
  return title + " [" + shown_units(scale.unit) + "]";
}

}  // namespace tribolog::wording
