#include "method/motion/torque_rounding.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tribolog::method::motion {
namespace {

/// A signal along straight lines, read at ascending times.
class Polyline {
 public:
  /// @param values outlive it.
  Polyline(const std::vector<double>& t_s, const Eigen::VectorXd& values)
      : t_(t_s), values_(values) {}

  double at(double t) {
    const Eigen::Index k = piece_of(t);
    return values_(k) + slope(k) * (std::clamp(t, t_.front(), t_.back()) - time(k));
  }
  Eigen::Index piece_of(double t) {
    while (piece_ + 2 < values_.size() && time(piece_ + 1) <= t) ++piece_;
    return piece_;
  }
  [[nodiscard]] double slope(Eigen::Index k) const {
    return (values_(k + 1) - values_(k)) / (time(k + 1) - time(k));
  }
  [[nodiscard]] double time(Eigen::Index k) const { return t_[static_cast<std::size_t>(k)]; }

 private:
  const std::vector<double>& t_;
  const Eigen::VectorXd& values_;
  Eigen::Index piece_{};
};

void average(const std::vector<double>& t_s, double half_s, Eigen::Ref<Eigen::VectorXd> signal) {
  const Eigen::VectorXd values = signal;
  Eigen::VectorXd sum(values.size());  // integral up to each sample
  sum(0) = 0;
  Polyline line(t_s, values);
  for (Eigen::Index i = 1; i < values.size(); ++i) {
    sum(i) = sum(i - 1) + (values(i) + values(i - 1)) / 2 * (line.time(i) - line.time(i - 1));
  }
  const auto up_to = [&](Polyline& reader, double t) {
    if (t <= t_s.front()) return values(0) * (t - t_s.front());
    if (t >= t_s.back()) return sum(sum.size() - 1) + values(values.size() - 1) * (t - t_s.back());
    const Eigen::Index k = reader.piece_of(t);
    const double into = t - reader.time(k);
    return sum(k) + into * (values(k) + reader.slope(k) * into / 2);
  };
  Polyline early(t_s, values);
  Polyline late(t_s, values);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double t = line.time(i);
    signal(i) = (up_to(late, t + half_s) - up_to(early, t - half_s)) / (2 * half_s);
  }
}

void filter(const std::vector<double>& t_s, double tau_s, Eigen::Ref<Eigen::VectorXd> signal) {
  const Eigen::VectorXd values = signal;
  Eigen::VectorXd filtered = values;
  const Polyline line(t_s, values);
  for (Eigen::Index i = 1; i < filtered.size(); ++i) {
    const double lag = line.slope(i - 1) * tau_s;  // of a straight line, once settled
    const double before = filtered(i - 1) - values(i - 1) + lag;
    filtered(i) = values(i) - lag + before * std::exp(-(line.time(i) - line.time(i - 1)) / tau_s);
  }
  Polyline later(t_s, filtered);
  for (Eigen::Index i = 0; i < filtered.size(); ++i) signal(i) = later.at(later.time(i) + tau_s);
}

}  // namespace

double TorqueRounding::looks_back_s() const {
  constexpr double fades_in = 6;  // time constants, of which one is taken off
  if (!any()) return 0;
  return shape == LagShape::filter ? fades_in * size_s : size_s;
}

void TorqueRounding::apply(const std::vector<double>& t_s,
                           Eigen::Ref<Eigen::VectorXd> signal) const {
  constexpr Eigen::Index fewest = 3;
  if (!any() || signal.size() < fewest) return;
  if (shape == LagShape::filter) {
    filter(t_s, size_s, signal);
  } else {
    average(t_s, size_s, signal);
  }
}

}  // namespace tribolog::method::motion
