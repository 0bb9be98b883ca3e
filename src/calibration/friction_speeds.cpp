#include "calibration/friction_speeds.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

namespace tribolog::calibration {

FrictionAtSpeed at_joint(FrictionAtSpeed at_motor, double gear_ratio) {
  const double n = std::abs(gear_ratio);
  at_motor.speed_rad_s /= n;
  at_motor.torque_Nm = statistics::scaled(at_motor.torque_Nm, n);
  for (auto* one : {&at_motor.forward_Nm, &at_motor.backward_Nm}) {
    if (*one) *one = statistics::scaled(**one, n);
  }
  return at_motor;
}

std::vector<std::size_t> evenly_in_log(const std::vector<double>& speeds_rad_s, std::size_t count) {
  std::vector<std::size_t> chosen;
  if (speeds_rad_s.empty() || count == 0) return chosen;
  const double first = std::log(speeds_rad_s.front());
  const double range = std::log(speeds_rad_s.back()) - first;
  const double steps = static_cast<double>(std::max<std::size_t>(count - 1, 1));
  for (std::size_t k = 0; k < count; ++k) {
    const double sought = first + range * static_cast<double>(k) / steps;
    const auto nearest =
        std::min_element(speeds_rad_s.begin(), speeds_rad_s.end(), [&](double a, double b) {
          return std::abs(std::log(a) - sought) < std::abs(std::log(b) - sought);
        });
    const auto at = static_cast<std::size_t>(nearest - speeds_rad_s.begin());
    if (chosen.empty() || at > chosen.back()) chosen.push_back(at);
  }
  return chosen;
}

std::vector<FrictionAtSpeed> evenly_in_log(const std::vector<FrictionAtSpeed>& all,
                                           std::size_t count) {
  std::vector<double> speeds_rad_s;
  for (const FrictionAtSpeed& f : all) speeds_rad_s.push_back(f.speed_rad_s);
  std::vector<FrictionAtSpeed> chosen;
  for (const std::size_t k : evenly_in_log(speeds_rad_s, count)) chosen.push_back(all[k]);
  return chosen;
}

namespace {

constexpr std::string_view friction_prefix = "friction_at_";

/// At a speed between two.
FrictionAtSpeed between(const FrictionAtSpeed& a, const FrictionAtSpeed& b, double speed_rad_s) {
  const double share =
      std::log(speed_rad_s / a.speed_rad_s) / std::log(b.speed_rad_s / a.speed_rad_s);
  const auto mean = [&](statistics::Estimate first, const statistics::Estimate& second) {
    for (double statistics::Estimate::* const member :
         {&statistics::Estimate::value, &statistics::Estimate::low, &statistics::Estimate::high}) {
      first.*member += share * (second.*member - first.*member);
    }
    return first;
  };
  FrictionAtSpeed f = a.verdict < b.verdict ? b : a;
  f.speed_rad_s = speed_rad_s;
  f.torque_Nm = mean(a.torque_Nm, b.torque_Nm);
  f.forward_Nm.reset();
  f.backward_Nm.reset();
  if (a.forward_Nm && b.forward_Nm) f.forward_Nm = mean(*a.forward_Nm, *b.forward_Nm);
  if (a.backward_Nm && b.backward_Nm) f.backward_Nm = mean(*a.backward_Nm, *b.backward_Nm);
  return f;
}

}  // namespace

std::vector<FrictionAtSpeed> at_standard_speeds(const std::vector<FrictionAtSpeed>& all) {
  std::vector<FrictionAtSpeed> made;
  if (all.empty()) return made;
  constexpr double rounding = 1e-3;  // a run commanded at 300 rad/s may be a little slower
  const double first = all.front().speed_rad_s * (1 - rounding);
  const double last = all.back().speed_rad_s * (1 + rounding);
  if (!(first > 0)) return made;
  for (int decade = static_cast<int>(std::floor(std::log10(first)));; ++decade) {
    for (const double digit : {1.0, 3.0}) {
      // As the nearest number to what it is called.
      const double speed =
          decade < 0 ? digit / std::pow(10.0, -decade) : digit * std::pow(10.0, decade);
      if (speed < first) continue;
      if (speed > last) return made;
      const auto next = std::find_if(
          all.begin(), all.end(), [&](const FrictionAtSpeed& f) { return f.speed_rad_s >= speed; });
      if (next == all.begin() || next == all.end()) {
        made.push_back(next == all.end() ? all.back() : all.front());
        made.back().speed_rad_s = speed;
      } else {
        made.push_back(between(*(next - 1), *next, speed));
      }
    }
  }
}

namespace {

bool is_at(const FrictionAtSpeed& f, double speed_rad_s) {
  constexpr double rounding = 1e-9;
  return std::abs(f.speed_rad_s - speed_rad_s) <= rounding * speed_rad_s;
}

}  // namespace

void mark_stated_speeds(const std::vector<double>& speeds_rad_s,
                        std::vector<FrictionAtSpeed>& all) {
  for (FrictionAtSpeed& f : all) {
    f.is_stated = std::any_of(speeds_rad_s.begin(), speeds_rad_s.end(),
                              [&](double speed) { return is_at(f, speed); });
  }
}

std::vector<FrictionAtSpeed> with_stated_speeds(std::vector<FrictionAtSpeed> all,
                                                const std::vector<double>& speeds_rad_s) {
  for (const double speed : speeds_rad_s) {
    const auto next = std::find_if(all.begin(), all.end(), [&](const FrictionAtSpeed& f) {
      return f.speed_rad_s >= speed || is_at(f, speed);
    });
    if (next == all.end() || is_at(*next, speed) || next == all.begin()) continue;
    all.insert(next, between(*(next - 1), *next, speed));
  }
  mark_stated_speeds(speeds_rad_s, all);
  return all;
}

std::vector<FrictionAtSpeed> of_a_table(const std::vector<FrictionAtSpeed>& all,
                                        std::size_t count) {
  std::vector<FrictionAtSpeed> stated;
  std::copy_if(all.begin(), all.end(), std::back_inserter(stated),
               [](const FrictionAtSpeed& f) { return f.is_stated; });
  return stated.empty() ? evenly_in_log(all, count) : stated;
}

std::string friction_name(double speed_rad_s) {
  return fmt::format("{}{:g}", friction_prefix, speed_rad_s);
}

std::optional<double> speed_of_friction(const std::string& name) {
  if (!name.starts_with(friction_prefix)) return std::nullopt;
  double speed = 0;
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + friction_prefix.size(), end, speed);
  const bool is_speed = read.ec == std::errc() && read.ptr == end && speed > 0;
  return is_speed ? std::optional(speed) : std::nullopt;
}

std::vector<SpeedRange> usable_ranges(const std::vector<FrictionAtSpeed>& all, std::size_t most) {
  struct Stretch {
    std::ptrdiff_t from{};
    std::ptrdiff_t end{};
  };
  const auto is_usable = [](const FrictionAtSpeed& f) { return f.verdict == Verdict::usable; };
  std::vector<Stretch> stretches;
  for (auto from = std::find_if(all.begin(), all.end(), is_usable); from != all.end();) {
    const auto end = std::find_if_not(from, all.end(), is_usable);
    stretches.push_back({from - all.begin(), end - all.begin()});
    from = std::find_if(end, all.end(), is_usable);
  }
  std::stable_sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) {
    return a.end - a.from > b.end - b.from;
  });
  stretches.resize(std::min(stretches.size(), most));
  std::sort(stretches.begin(), stretches.end(),
            [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
  std::vector<SpeedRange> ranges;
  for (const Stretch& one : stretches) {
    ranges.push_back({all[static_cast<std::size_t>(one.from)].speed_rad_s,
                      all[static_cast<std::size_t>(one.end - 1)].speed_rad_s});
  }
  return ranges;
}

}  // namespace tribolog::calibration
