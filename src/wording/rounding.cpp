#include "wording/rounding.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "joint/degrees.h"
#include "wording/torques_in.h"
#include "wording/tr.h"

namespace tribolog::wording {
namespace {

constexpr int most_significant_digits = 7;
constexpr int digits_without_interval = 5;
constexpr double lopsided_share = 0.1;

int exponent_of(double value) { return static_cast<int>(std::floor(std::log10(std::abs(value)))); }

/// An exponent in superscript: "⁻⁹".
std::string raised(int exponent) {
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = exponent < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(exponent))) out += digits[c - '0'];
  return out;
}

}  // namespace

std::string with_minus_sign(std::string digits) {
  const bool is_zero = digits.find_first_of("123456789") == std::string::npos;
  if (digits.empty() || digits.front() != '-') return digits;
  digits.erase(0, 1);
  return is_zero ? digits : "\u2212" + digits;
}

std::string with_plus_sign(const std::string& number) {
  const bool is_zero = number.find_first_of("123456789") == std::string::npos;
  return is_zero || number.starts_with("\u2212") ? number : "+" + number;
}

int decimals_for(double half_width) {
  const int decimals = 1 - exponent_of(half_width);
  // 0.0996 is 0.10 to two digits, not 0.100.
  const double unit = std::pow(10.0, -decimals);
  return std::round(half_width / unit) >= 100.0 ? decimals - 1 : decimals;
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return tr("unknown");
  if (decimals < 0) {
    const double step = std::pow(10.0, -decimals);
    return with_minus_sign(fmt::format("{:.0f}", std::round(value / step) * step));
  }
  return with_minus_sign(fmt::format("{:.{}f}", value, decimals));
}

std::string significant(double value, int digits) {
  if (!std::isfinite(value)) return tr("unknown");
  if (value == 0.0) return "0";
  const double size = std::abs(value);
  if (size >= 1e9 || size < 1e-6) {
    const std::string text = fmt::format("{:.{}e}", value, std::max(digits - 1, 0));
    const std::size_t e = text.find('e');
    const int exponent = std::stoi(text.substr(e + 1));
    return with_minus_sign(text.substr(0, e)) + "×10" + raised(exponent);
  }
  int decimals = digits - 1 - exponent_of(value);
  if (std::round(size * std::pow(10.0, decimals)) >= std::pow(10.0, digits)) --decimals;
  return fixed(value, decimals);
}

std::string without_exponent(std::string printed) {
  const std::size_t e = printed.find('e');
  if (e == std::string::npos) return printed;
  const std::string mantissa = printed.substr(0, e);
  const int exponent = std::stoi(printed.substr(e + 1));
  if (exponent >= 9 || exponent < 0) {
    return (mantissa == "1" ? "" : mantissa + "×") + "10" + raised(exponent);
  }
  const auto digits =
      std::count_if(mantissa.begin(), mantissa.end(), [](char c) { return '0' <= c && c <= '9'; });
  const int decimals = std::max(0, static_cast<int>(digits) - 1 - exponent);
  const bool has_plus = mantissa.starts_with('+');
  return fmt::format("{}{:.{}f}", has_plus ? "+" : "", std::stod(printed), decimals);
}

std::string six_digits(double value) {
  return with_minus_sign(without_exponent(fmt::format("{:.6g}", value)));
}

std::string as_stated(double value) {
  return std::isfinite(value) ? with_minus_sign(fmt::format("{:.10g}", value)) : tr("unknown");
}

bool is_below_resolution(double number, const std::string& unit) {
  constexpr double of_prefixed = 1e-3;
  constexpr double of_percent = 1e-6;
  const double size = std::abs(number);
  if (unit == "%") return size < of_percent;
  const bool is_prefixed =
      unit.starts_with("µ") || unit.starts_with("nN") || unit.starts_with("nA") || unit == "nrad";
  return is_prefixed && size < of_prefixed;
}

RoundedEstimate round_by_interval(const statistics::Estimate& estimate, const Scale& scale) {
  RoundedEstimate text;
  if (!std::isfinite(estimate.value)) {
    text.estimate = tr("not identified");
    return text;
  }
  const double value = estimate.value * scale.factor;
  const double half = estimate.half_width() * std::abs(scale.factor);
  if (is_below_resolution(std::isfinite(half) ? std::abs(value) + half : value, scale.unit)) {
    text.estimate = "0";
    return text;
  }
  if (!std::isfinite(half) || half <= 0.0) {
    text.estimate = significant(value, digits_without_interval);
    return text;
  }
  int decimals = decimals_for(half);
  const int finest = value == 0.0 ? decimals : most_significant_digits - 1 - exponent_of(value);
  const bool capped = decimals > finest;
  decimals = std::min(decimals, std::max(finest, 0));

  text.estimate = fixed(value, decimals);
  const double one = estimate.low * scale.factor;
  const double other = estimate.high * scale.factor;
  text.low = fixed(std::min(one, other), decimals);
  text.high = fixed(std::max(one, other), decimals);
  const double below = value - std::min(one, other);
  const double above = std::max(one, other) - value;
  if (std::abs(above - below) > lopsided_share * half) return text;
  const double last_place = std::pow(10.0, -decimals);
  if (capped && half < last_place) {
    text.half_width = "< " + fixed(last_place, decimals);
    text.low.clear();
    text.high.clear();
  } else {
    text.half_width = fixed(half, decimals);
  }
  return text;
}

std::string RoundedEstimate::plus_minus() const {
  return half_width.empty() ? estimate : estimate + " ± " + half_width;
}

std::string RoundedEstimate::range() const { return low.empty() ? "" : low + " … " + high; }

std::string with_unit(const std::string& number, const std::string& unit) {
  if (unit.empty()) return number;
  return unit == "°" ? number + unit : number + "\u00a0" + shown_units(unit);
}

std::string in_words(const statistics::Estimate& estimate, const Scale& scale) {
  const RoundedEstimate text = round_by_interval(estimate, scale);
  if (!text.half_width.empty()) {
    const bool degrees = scale.unit == "°";
    return degrees ? text.estimate + "° ± " + text.half_width + "°"
                   : with_unit(text.plus_minus(), scale.unit);
  }
  if (text.low.empty()) return with_unit(text.estimate, scale.unit);
  return with_unit(text.estimate, scale.unit) + " (" + text.range() + ")";
}

std::string count(std::size_t value) {
  std::string digits = std::to_string(value);
  for (std::ptrdiff_t at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3) {
    digits.insert(static_cast<std::size_t>(at), "\u202f");
  }
  return digits;
}

// Units.

namespace {

// The prefix changes a decade below 1 so that "0.88 N·m" stays "0.88 N·m".
Scale prefixed(double size, double base_from, const std::string& unit) {
  const double absolute = std::abs(size);
  if (!std::isfinite(absolute) || absolute == 0.0 || absolute >= base_from) return {1.0, unit};
  if (absolute >= base_from * 1e-3) return {1e3, "m" + unit};
  return {1e6, "µ" + unit};
}

Scale with_large_prefix(double size, const std::string& unit) {
  const double absolute = std::abs(size);
  if (absolute >= 1e7) return {1e-6, "M" + unit};
  return absolute >= 1e4 ? Scale{1e-3, "k" + unit} : Scale{1.0, unit};
}

}  // namespace

Scale torque_scale(double size_Nm) { return quantity_scale("N·m", size_Nm); }
Scale radian_scale(double size_rad) { return prefixed(size_rad, 0.01, "rad"); }
Scale viscous_scale(double size_Nms_rad) { return quantity_scale("N·m·s/rad", size_Nms_rad); }
Scale stiffness_scale(double size_Nm_rad) { return quantity_scale("N·m/rad", size_Nm_rad); }
Scale inertia_scale(double size_kgm2) { return quantity_scale("kg·m²", size_kgm2); }

Scale degree_scale() { return {joint::degrees_per_rad, "°"}; }
Scale plain_scale(std::string unit) { return {1.0, shown_units(std::move(unit))}; }

Scale quantity_scale(const std::string& unit, double size) {
  constexpr double base_from = 0.1;
  const std::string shown = shown_units(unit);
  if (shown == "rad") return degree_scale();
  if (shown == "N·m/rad" || shown == "A/rad") return with_large_prefix(size, shown);
  for (const char* const with_small_prefix : {"N·m", "N·m·s/rad", "A", "A·s/rad", "A·s²/rad"}) {
    if (shown == with_small_prefix) return prefixed(size, base_from, shown);
  }
  const double absolute = std::abs(size);
  if (shown != "kg·m²" || !(absolute > 0 && absolute < base_from)) return {1.0, shown};
  constexpr double grams_per_kilogram = 1e3;
  Scale scale = prefixed(size * grams_per_kilogram, base_from, "g·m²");
  scale.factor *= grams_per_kilogram;
  return scale;
}

}  // namespace tribolog::wording
