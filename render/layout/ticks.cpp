#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <utility>

#include "render/layout/axis.h"

namespace tribolog::render::layout {
namespace {

constexpr const char* minus = "\u2212";
constexpr int largest_plain = 5;  // digits before the point
constexpr int most_decimals = 4;  // digits behind it

int digits_of(long long value) {
  return static_cast<int>(std::to_string(std::llabs(value)).size());
}

}  // namespace

std::string decimal_text(long long multiple, int exponent) {
  if (multiple == 0) return "0";
  std::string digits = std::to_string(std::llabs(multiple));
  if (exponent >= 0) {
    digits.append(static_cast<std::size_t>(exponent), '0');
  } else {
    const auto decimals = static_cast<std::size_t>(-exponent);
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    digits.insert(digits.size() - decimals, 1, '.');
  }
  std::string signed_text;
  if (multiple < 0) signed_text += minus;
  return signed_text += digits;
}

std::string integer_text(int value) { return decimal_text(value, 0); }

std::string magnitude_text(double value) {
  char buffer[64];
  const auto plain = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed);
  if (plain.ec == std::errc() && plain.ptr - buffer <= 7 && value >= 1e-3) {
    return {buffer, plain.ptr};
  }
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific);
  const std::string text(buffer, end.ptr);
  const std::size_t split = text.find('e');
  const int power = std::atoi(text.c_str() + split + 1);
  return text.substr(0, split) + "·10^{" + integer_text(power) + "}";
}

std::string logarithmic_text(int digit, int exponent) {
  if (exponent >= -3 && exponent <= 4) return decimal_text(digit, exponent);
  const std::string power = "10^{" + integer_text(exponent) + "}";
  if (digit == 1) return power;
  return integer_text(digit) + "·" + power;
}

double power_of_ten_multiple(int digit, int exponent) {
  return std::strtod((std::to_string(digit) + "e" + std::to_string(exponent)).c_str(), nullptr);
}

CommonPower common_power(const std::vector<long long>& multiples, int exponent) {
  long long largest = 0;
  for (const long long one : multiples) largest = std::max(largest, std::llabs(one));
  if (largest == 0) return {};
  const int leading = digits_of(largest) - 1 + exponent;  // decimal exponent of the largest label
  if (leading < largest_plain && -exponent <= most_decimals) return {};
  return {leading >= 0 ? leading / 3 * 3 : -((-leading + 2) / 3 * 3)};
}

namespace {

constexpr double rounding_slack = 1e-9;  // of a step: a tick at the very end of the range counts

struct Step {
  int digit{1};  ///< 1, 2 or 5
  int exponent{};
  [[nodiscard]] double size() const { return digit * std::pow(10.0, exponent); }
  [[nodiscard]] Step larger() const {
    if (digit == 1) return {2, exponent};
    if (digit == 2) return {5, exponent};
    return {1, exponent + 1};
  }
};

double ticks_within(const AxisRange& range, double step) {
  return std::floor(range.high / step + rounding_slack) -
         std::ceil(range.low / step - rounding_slack) + 1.0;
}

/// `least`: neighbouring ticks are at least as far apart.
Step choose_step(const AxisRange& range, int most, double least) {
  const double span = range.high - range.low;
  Step step{1, static_cast<int>(std::floor(std::log10(span / most))) - 1};
  while (ticks_within(range, step.size()) > most || step.size() < least) {
    step = step.larger();
  }
  return step;
}

/// What numbers can tell apart, twice.
double resolution_of(const AxisRange& range) {
  const double magnitude = std::max(std::abs(range.low), std::abs(range.high));
  return 2.0 * (std::nextafter(magnitude, std::numeric_limits<double>::max()) - magnitude);
}

/// A range far from zero is labelled by its distance from a round number near by.
double choose_offset(const AxisRange& range) {
  constexpr double narrow = 1e-4;  // of the magnitude: labels would need six digits
  const double magnitude = std::max(std::abs(range.low), std::abs(range.high));
  const double span = range.high - range.low;
  if (span > narrow * magnitude) return 0.0;
  const double exponent = std::ceil(std::log10(span));
  const double power = std::pow(10.0, std::abs(exponent));  // exact, unlike its inverse
  return exponent < 0 ? std::round(range.low * power) / power
                      : std::round(range.low / power) * power;
}

}  // namespace

TickSet linear_ticks(const AxisRange& range, int most, double least_step) {
  TickSet out;
  const double offset = choose_offset(range);
  const AxisRange shifted{range.low - offset, range.high - offset};
  const Step step =
      choose_step(shifted, std::max(most, 2), std::max(resolution_of(range), least_step));
  const double size = step.size();
  const auto first = static_cast<long long>(std::ceil(shifted.low / size - rounding_slack));
  const auto last = static_cast<long long>(std::floor(shifted.high / size + rounding_slack));
  std::vector<long long> multiples;
  for (long long k = first; k <= last; ++k) multiples.push_back(k * step.digit);
  const CommonPower power = common_power(multiples, step.exponent);
  for (const long long multiple : multiples) {
    const double relative = step.exponent >= 0
                                ? static_cast<double>(multiple) * std::pow(10.0, step.exponent)
                                : static_cast<double>(multiple) / std::pow(10.0, -step.exponent);
    out.major.push_back({std::clamp(offset + relative, range.low, range.high),
                         decimal_text(multiple, step.exponent - power.exponent)});
  }
  if (power.exponent != 0) out.scale_note = "×10^{" + integer_text(power.exponent) + "}";
  if (offset != 0.0) {
    if (!out.scale_note.empty()) out.scale_note += "  ";
    out.scale_note += (offset > 0 ? "+ " : "− ") + magnitude_text(std::abs(offset));
  }
  return out;
}

TickSet logarithmic_ticks(const AxisRange& range, int most) {
  const int first = static_cast<int>(std::floor(std::log10(range.low) - rounding_slack));
  const int last = static_cast<int>(std::ceil(std::log10(range.high) + rounding_slack));
  const auto inside = [&](double value) {
    return value >= range.low * (1 - rounding_slack) && value <= range.high * (1 + rounding_slack);
  };
  TickSet out;
  const double decades = std::log10(range.high / range.low);
  const bool with_halves = decades <= 2.0 && most >= 4;
  const int stride = std::max(1, static_cast<int>(std::ceil(decades / std::max(most - 1, 1))));
  for (int exponent = first; exponent <= last; ++exponent) {
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = power_of_ten_multiple(digit, exponent);
      if (!inside(value)) continue;
      const bool labelled =
          (digit == 1 && exponent % stride == 0) || (with_halves && (digit == 2 || digit == 5));
      if (labelled) {
        out.major.push_back({value, logarithmic_text(digit, exponent)});
      } else {
        out.minor.push_back(value);
      }
    }
  }
  if (out.major.size() < 2) return linear_ticks(range, most);
  return out;
}

TickSet symmetric_ticks(const AxisRange& range, double linear_within, int most) {
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  constexpr double nearly = 0.1;  // of a decade
  const int first = static_cast<int>(std::ceil(std::log10(linear_within) - nearly));
  const int last = static_cast<int>(std::floor(std::log10(largest) + rounding_slack));
  const int sides = range.low < 0 && range.high > 0 ? 2 : 1;
  const int decades = last - first + 1;
  int stride = 1;
  while (stride < decades && sides * ((decades + stride - 1) / stride) + 1 > most) ++stride;
  TickSet out;
  const auto is_inside = [&](double value) { return value >= range.low && value <= range.high; };
  if (is_inside(0)) out.major.push_back({0, "0"});
  for (int exponent = last; exponent >= first; --exponent) {
    for (const int sign : {-1, 1}) {
      for (int digit = 1; digit <= 9; ++digit) {
        const double value = sign * power_of_ten_multiple(digit, exponent);
        if (!is_inside(value)) continue;
        const bool is_labelled = digit == 1 && (last - exponent) % stride == 0;
        if (is_labelled) {
          std::string label = logarithmic_text(digit, exponent);
          if (sign < 0) label.insert(0, minus);
          out.major.push_back({value, std::move(label)});
        } else {
          out.minor.push_back(value);
        }
      }
    }
  }
  if (out.major.size() < 3) return linear_ticks(range, most);
  std::sort(out.major.begin(), out.major.end(),
            [](const Tick& a, const Tick& b) { return a.value < b.value; });
  return out;
}

// Calendar dates.

namespace {

namespace chrono = std::chrono;

constexpr double hours_per_day = 24;
constexpr double shortest_days = 2 / hours_per_day;
constexpr double first_day = -719162;  // 0001-01-01
constexpr double last_day = 2932896;   // 9999-12-31

chrono::year_month_day date_of(double day) {
  return chrono::sys_days(chrono::days(static_cast<long>(std::floor(day))));
}

double day_of(int year, unsigned month) {
  const chrono::sys_days day = chrono::year(year) / chrono::month(month) / chrono::day(1);
  return static_cast<double>(day.time_since_epoch().count());
}

std::string text(const char* format, double day, int hour = 0) {
  const chrono::year_month_day date = date_of(day);
  char out[64];
  std::snprintf(out, sizeof out, format, static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), hour);
  return out;
}

void add(double day, const AxisRange& range, const std::string& label, TickSet& ticks) {
  if (day >= range.low && day <= range.high) ticks.major.push_back({day, label});
}

TickSet by_hours(const AxisRange& range, int step) {
  TickSet ticks;
  for (double day = std::floor(range.low); day <= range.high; ++day) {
    for (int hour = 0; hour < hours_per_day; hour += step) {
      add(day + hour / hours_per_day, range, text("%04d-%02u-%02u %02d:00", day, hour), ticks);
    }
  }
  return ticks;
}

TickSet by_days(const AxisRange& range, int step) {
  TickSet ticks;
  // From the month's first on, so that days are the same wherever the range begins.
  for (double day = std::floor(range.low); day <= range.high; ++day) {
    const auto of_month = static_cast<unsigned>(date_of(day).day()) - 1;
    const auto left = 31 - static_cast<int>(of_month);
    const bool is_tick = of_month % static_cast<unsigned>(step) == 0;
    if (is_tick && (of_month == 0 || left > step / 2)) {
      add(day, range, text("%04d-%02u-%02u", day), ticks);
    }
  }
  return ticks;
}

/// Steps from 12 on are years.
TickSet by_months(const AxisRange& range, int step) {
  TickSet ticks;
  const chrono::year_month_day first = date_of(range.low);
  const int begin = 12 * static_cast<int>(first.year()) +
                    static_cast<int>(static_cast<unsigned>(first.month())) - 1;
  for (int month = begin - begin % step;; month += step) {
    const double day = day_of(month / 12, static_cast<unsigned>(month % 12) + 1);
    if (day > range.high) return ticks;
    add(day, range, text(step < 12 ? "%04d-%02u" : "%04d", day), ticks);
  }
}

}  // namespace

TickSet date_ticks(const AxisRange& range, int most) {
  const double span = range.high - range.low;
  if (!(range.low >= first_day && range.high <= last_day && span >= shortest_days)) {
    return linear_ticks(range, most);
  }
  struct Step {
    TickSet (*make)(const AxisRange&, int);
    int count;
    double days;  ///< About.
  };
  constexpr double month = 30.4;
  static const std::array<Step, 22> steps{{
      {by_hours, 1, 1 / 24.0},
      {by_hours, 3, 3 / 24.0},
      {by_hours, 6, 6 / 24.0},
      {by_hours, 12, 0.5},
      {by_days, 1, 1},
      {by_days, 2, 2},
      {by_days, 5, 5},
      {by_days, 10, 10},
      {by_days, 15, 15},
      {by_months, 1, month},
      {by_months, 2, 2 * month},
      {by_months, 3, 3 * month},
      {by_months, 6, 6 * month},
      {by_months, 12, 12 * month},
      {by_months, 24, 24 * month},
      {by_months, 60, 60 * month},
      {by_months, 120, 120 * month},
      {by_months, 240, 240 * month},
      {by_months, 600, 600 * month},
      {by_months, 1200, 1200 * month},
      {by_months, 6000, 6000 * month},
      {by_months, 24000, 24000 * month},
  }};
  TickSet fewest;
  for (const Step& step : steps) {
    if (span / step.days > 2.0 * most + 2) continue;
    TickSet ticks = step.make(range, step.count);
    if (static_cast<int>(ticks.major.size()) <= most) {
      // A coarser step may have lost all of them; then the finer ones are thinned out.
      if (!ticks.major.empty()) return ticks;
      if (!fewest.major.empty()) fewest.major.resize(1);
      return fewest;
    }
    fewest = std::move(ticks);
  }
  return fewest;
}

}  // namespace tribolog::render::layout
