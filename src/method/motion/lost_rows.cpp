#include "method/motion/lost_rows.h"

#include <cmath>

#include "statistics/order_statistics.h"

namespace tribolog::method::motion {
namespace {

constexpr double most_lost = 5;  // in a row

/// How many rows are missing after this one.
std::size_t lost_after(const joint::Recording& r, std::size_t i, double dt_s) {
  const double lost = std::round((r.t_s[i + 1] - r.t_s[i]) / dt_s) - 1;
  return lost >= 1 && lost <= most_lost ? static_cast<std::size_t>(lost) : 0;
}

/// The cubic through the four samples about the interval that begins with i.
double cubic_at(double t, const std::vector<double>& times, const std::vector<double>& values,
                std::size_t i) {
  double sum = 0;
  for (std::size_t k = i - 1; k <= i + 2; ++k) {
    double weight = 1;
    for (std::size_t j = i - 1; j <= i + 2; ++j) {
      if (j != k) weight *= (t - times[j]) / (times[k] - times[j]);
    }
    sum += weight * values[k];
  }
  return sum;
}

}  // namespace

bool has_lost_rows(const joint::Recording& recording) {
  // Of a clock that scatters a long interval tells nothing.
  constexpr double even = 0.25;
  constexpr double least_share = 0.95;
  const double dt_s = statistics::even_interval(recording.t_s);
  if (!(dt_s > 0)) return false;
  std::size_t lost = 0;
  std::size_t whole = 0;
  for (std::size_t i = 0; i + 1 < recording.size(); ++i) {
    const double intervals = (recording.t_s[i + 1] - recording.t_s[i]) / dt_s;
    if (std::abs(intervals - std::round(intervals)) < even) ++whole;
    lost += lost_after(recording, i, dt_s);
  }
  return lost > 0 &&
         static_cast<double>(whole) > least_share * static_cast<double>(recording.size() - 1);
}

joint::Recording with_lost_rows(const joint::Recording& recording) {
  const double dt_s = statistics::even_interval(recording.t_s);
  const std::size_t size = recording.size();
  if (!(dt_s > 0) || recording.torque_Nm.size() != size) return recording;
  joint::Recording out;
  out.name = recording.name;
  out.role = recording.role;
  for (std::size_t i = 0; i < size; ++i) {
    out.t_s.push_back(recording.t_s[i]);
    out.q_rad.push_back(recording.q_rad[i]);
    out.torque_Nm.push_back(recording.torque_Nm[i]);
    if (i == 0 || i + 2 >= size) continue;
    const std::size_t lost = lost_after(recording, i, dt_s);
    for (std::size_t k = 1; k <= lost; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(lost + 1);
      const double t = std::lerp(recording.t_s[i], recording.t_s[i + 1], share);
      out.t_s.push_back(t);
      out.q_rad.push_back(cubic_at(t, recording.t_s, recording.q_rad, i));
      out.torque_Nm.push_back(std::lerp(recording.torque_Nm[i], recording.torque_Nm[i + 1], share));
    }
  }
  return out;
}

}  // namespace tribolog::method::motion
