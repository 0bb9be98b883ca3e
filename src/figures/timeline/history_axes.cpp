#include "figures/timeline/history_axes.h"

#include <chrono>
#include <cstdio>
#include <limits>

#include <fmt/format.h>

#include "calibration/friction_speeds.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::figures::timeline {

double day_of(const std::string& utc) {
  namespace chrono = std::chrono;
  int year = 0;
  unsigned month = 0, day = 0, hour = 0, minute = 0, second = 0;
  if (std::sscanf(utc.c_str(), "%4d-%2u-%2uT%2u:%2u:%2uZ", &year, &month, &day, &hour, &minute,
                  &second) != 6) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const chrono::year_month_day date = chrono::year(year) / chrono::month(month) / chrono::day(day);
  if (!date.ok()) return std::numeric_limits<double>::quiet_NaN();
  const chrono::sys_days days = date;
  constexpr double seconds_per_day = 86400;
  return static_cast<double>(days.time_since_epoch().count()) +
         (hour * 3600.0 + minute * 60.0 + second) / seconds_per_day;
}

wording::AxisScale quantity_axis(const std::string& unit, double largest) {
  if (unit == "rad") return wording::degrees();
  for (const char* const small :
       {"N·m", "N·m·s/rad", "N·m/rad", "A", "A·s/rad", "A/rad", "A·s²/rad"}) {
    if (unit == small) return wording::prefixed(unit, largest);
  }
  const wording::Scale scale = wording::quantity_scale(unit, largest);
  return {scale.factor, scale.unit};
}

std::string quantity_words(const std::string& name, const std::string& words) {
  if (const auto speed_rad_s = calibration::speed_of_friction(name)) {
    return wording::tr("Friction at {speed}",
                       {{"speed", wording::with_unit(fmt::format("{:g}", *speed_rad_s), "rad/s")}});
  }
  return wording::words_for("quantity", name, words);
}

}  // namespace tribolog::figures::timeline
