#include "render/layout/date_ticks.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>

namespace tribolog::render::layout {
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
