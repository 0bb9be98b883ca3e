#include "wording/number_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "wording/torques_in.h"
#include "wording/tr.h"

namespace tribolog::wording {
namespace {

constexpr double lopsided = 0.2;  // of the half width: more is shown as two ends
constexpr double exact = 1e-6;

/// Decimals that show `step` with so many significant digits.
int decimals_for(double step, int digits) {
  // Through the printed form, so that 0.99996 to three digits is 1.00 and not 1.000.
  const std::string printed = fmt::format("{:.{}e}", std::abs(step), digits - 1);
  const int exponent = std::stoi(printed.substr(printed.find('e') + 1));
  return std::clamp(digits - 1 - exponent, 0, 12);
}

bool printable_in_full(double value) {
  return value == 0.0 || (std::abs(value) < 1e9 && std::abs(value) >= 1e-9);
}

/// Whether an interval says how the value is to be rounded. One of a millionth is a computer's.
bool worth_showing(double half, double value) {
  return half > exact * std::abs(value) && printable_in_full(half) && half != 0.0 &&
         printable_in_full(value);
}

std::string joined(const std::string& number, const std::string& unit) {
  if (unit.empty() || unit == "°") return number + unit;
  return number + " " + shown_units(unit);
}

}  // namespace

std::string to_place(double value, double largest, int digits) {
  if (!std::isfinite(value)) return tr("unknown");
  if (!printable_in_full(largest) || largest == 0.0) return significant(value, digits);
  return fixed(value, decimals_for(largest, digits));
}

std::string with_unit(double value_in_si, const AxisScale& scale, int digits) {
  const double shown = scale(value_in_si);
  return joined(is_below_resolution(shown, scale.unit) ? "0" : significant(shown, digits),
                scale.unit);
}

std::string size_words(double size_in_si, double floor, const std::string& si_unit) {
  const auto scale_of = [&](double size) {
    return si_unit == "%" ? AxisScale{1.0, "%"} : prefixed(si_unit, size);
  };
  if (std::abs(size_in_si) < floor) {
    return tr("below {limit}", {{"limit", with_unit(floor, scale_of(floor), 1)}});
  }
  return with_unit(size_in_si, scale_of(size_in_si), 2);
}

std::string with_interval(const statistics::Estimate& estimate, const AxisScale& scale) {
  const double value = scale(estimate.value);
  const double below = value - scale(estimate.low);
  const double above = scale(estimate.high) - value;
  const double half = (below + above) / 2;
  if (!std::isfinite(value)) return tr("unknown");
  if (is_below_resolution(std::isfinite(half) ? std::abs(value) + half : value, scale.unit)) {
    return joined("0", scale.unit);
  }
  if (!worth_showing(half, value)) return joined(significant(value, 5), scale.unit);
  const int decimals = decimals_for(half, 2);
  const std::string number = joined(fixed(value, decimals), scale.unit);
  if (std::abs(above - below) > lopsided * half) {
    return tr("{estimate} ({low} to {high})", {{"estimate", number},
                                               {"low", fixed(value - below, decimals)},
                                               {"high", fixed(value + above, decimals)}});
  }
  if (scale.unit == "°") return number + " ± " + fixed(half, decimals) + "°";
  return joined(fixed(value, decimals) + " ± " + fixed(half, decimals), scale.unit);
}

std::string rounded(const statistics::Estimate& estimate, const AxisScale& scale) {
  const double value = scale(estimate.value);
  const double half = std::abs(estimate.half_width() * scale.factor);
  if (!worth_showing(half, value)) return joined(significant(value, 5), scale.unit);
  return joined(fixed(value, decimals_for(half, 1)), scale.unit);
}

std::string date_of(const std::string& utc) {
  return utc.substr(0, std::string_view("2026-01-31").size());
}

std::string counted(std::size_t count, const std::string& singular) {
  return fmt::format("{} {}{}", count, singular, count == 1 ? "" : "s");
}

std::string listed(const std::vector<std::string>& words) {
  if (words.empty()) return {};
  const std::string all_but_last =
      fmt::format("{}", fmt::join(words.begin(), words.end() - 1, ", "));
  return words.size() == 1
             ? words.back()
             : tr("{first} and {last}", {{"first", all_but_last}, {"last", words.back()}});
}

}  // namespace tribolog::wording
