#include "method/hysteresis/loop_timing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tribolog::method::hysteresis {
namespace {

/// Values at the times `t_s` + `later_s`, along straight lines; beyond the ends the last value.
template <class Values>
std::vector<double> read_later(const std::vector<double>& t_s, const Values& values,
                               double later_s) {
  std::vector<double> out(t_s.size());
  std::size_t above = 1;
  const auto at = [&](std::size_t k) { return values[static_cast<std::ptrdiff_t>(k)]; };
  for (std::size_t i = 0; i < t_s.size(); ++i) {
    const double t = t_s[i] + later_s;
    while (above + 1 < t_s.size() && t_s[above] < t) ++above;
    const double share = (t - t_s[above - 1]) / (t_s[above] - t_s[above - 1]);
    out[i] = std::lerp(at(above - 1), at(above), std::clamp(share, 0.0, 1.0));
  }
  return out;
}

}  // namespace

LoopTiming timing_of_loops(const std::optional<statistics::Estimate>& lag_s) {
  if (!lag_s) return {};
  const bool is_beyond_doubt = lag_s->low > 0 || lag_s->high < 0;
  return {is_beyond_doubt ? lag_s->value : 0, lag_s->half_width()};
}

joint::Recording aligned(const joint::Recording& recording, double lag_s) {
  joint::Recording out = recording;
  if (lag_s == 0 || recording.torque_Nm.empty() || recording.size() < 2) return out;
  out.torque_Nm = read_later(recording.t_s, recording.torque_Nm.data(), lag_s);
  const auto first = std::find_if(out.t_s.begin(), out.t_s.end(),
                                  [&](double t) { return t + lag_s >= recording.t_s.front(); });
  const auto last = std::find_if(first, out.t_s.end(),
                                 [&](double t) { return t + lag_s > recording.t_s.back(); });
  const auto from = first - out.t_s.begin();
  const auto count = last - first;
  for (std::vector<double>* signal : {&out.t_s, &out.q_rad, &out.dq_rad_s, &out.torque_Nm,
                                      &out.z_rad, &out.dz_rad_s, &out.temperature_C}) {
    if (signal->empty()) continue;
    signal->erase(signal->begin() + from + count, signal->end());
    signal->erase(signal->begin(), signal->begin() + from);
  }
  return out;
}

Eigen::VectorXd rounded_by_filter(const std::vector<double>& t_s, const Eigen::VectorXd& torque_Nm,
                                  double tau_s) {
  Eigen::VectorXd filtered = torque_Nm;
  if (filtered.size() < 3) return filtered;
  for (Eigen::Index i = 1; i < filtered.size(); ++i) {
    const double step_s = t_s[static_cast<std::size_t>(i)] - t_s[static_cast<std::size_t>(i) - 1];
    const double slope = (torque_Nm(i) - torque_Nm(i - 1)) / step_s;
    const double lag = slope * tau_s;  // of a straight line, once settled
    const double before = filtered(i - 1) - torque_Nm(i - 1) + lag;
    filtered(i) = torque_Nm(i) - lag + before * std::exp(-step_s / tau_s);
  }
  const std::vector<double> later = read_later(t_s, filtered, tau_s);
  return Eigen::Map<const Eigen::VectorXd>(later.data(), filtered.size());
}

}  // namespace tribolog::method::hysteresis
