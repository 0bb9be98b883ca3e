#include "method/gravity/run_gravity_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "method/gravity/sweep_regression.h"
#include "statistics/order_statistics.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::gravity {
namespace {

double torque_Nm(const std::optional<TorqueOfAngle>& of_angle, double q_rad) {
  return of_angle ? of_angle->torque_Nm(q_rad) : 0.0;
}

void add_rows(const GravityRun& run, std::size_t number, const GravityCells& cells,
              double gear_ratio, const Ripple& ripple, const std::optional<TorqueOfAngle>& of_angle,
              std::vector<GravityRow>& rows) {
  std::vector<GravityRow> sums(GravityCells::count, GravityRow{number, 0, 0, 0, 0});
  std::vector<double> counts(GravityCells::count, 0.0);
  const double middle = cells.middle_rad();
  for (std::size_t i = run.plateau.first; i < run.plateau.last; ++i) {
    const double q = run.recording->q_rad[i];
    const std::size_t cell = cells.of(q);
    // 1 - cos q as 2 sin^2(q/2): no cancellation over a short way.
    const double half = std::sin((q - middle) / 2);
    sums[cell].cosine += -2 * half * half;
    sums[cell].sine += std::sin(q - middle);
    sums[cell].torque_Nm +=
        run.recording->torque_Nm[i] - ripple.torque_Nm(gear_ratio * q) - torque_Nm(of_angle, q);
    counts[cell] += 1;
  }
  GravityRow mean{number, 0, 0, 0, 0};
  double used = 0;
  const std::size_t first = rows.size();
  for (std::size_t cell = 0; cell < GravityCells::count; ++cell) {
    if (counts[cell] == 0) continue;
    const GravityRow& s = sums[cell];
    rows.push_back(
        {number, cell, s.cosine / counts[cell], s.sine / counts[cell], s.torque_Nm / counts[cell]});
    mean.cosine += rows.back().cosine;
    mean.sine += rows.back().sine;
    mean.torque_Nm += rows.back().torque_Nm;
    used += 1;
  }
  for (std::size_t i = first; i < rows.size(); ++i) {
    rows[i].cosine -= mean.cosine / used;
    rows[i].sine -= mean.sine / used;
    rows[i].torque_Nm -= mean.torque_Nm / used;
  }
}

double white_variance_of(const GravityRun& run) {
  std::vector<double> third;
  for (std::size_t i = run.plateau.first + 3; i < run.plateau.last; ++i) {
    third.push_back(statistics::third_difference(&run.recording->torque_Nm[i - 3]));
  }
  return statistics::white_variance(third);
}

}  // namespace

std::size_t GravityCells::of(double q_rad) const {
  const double width = (highest_rad - lowest_rad) / static_cast<double>(count);
  return std::min(count - 1, static_cast<std::size_t>((q_rad - lowest_rad) / width));
}

std::vector<GravityRun> gravity_runs_of(const std::vector<const joint::Recording*>& recordings) {
  std::vector<GravityRun> runs;
  for (const joint::Recording* r : recordings) {
    for (const motion::Plateau& p : motion::find_plateaus(*r).plateaus) {
      const auto begin = r->q_rad.begin();
      const auto [low, high] = std::minmax_element(begin + static_cast<std::ptrdiff_t>(p.first),
                                                   begin + static_cast<std::ptrdiff_t>(p.last));
      runs.push_back({r, p, *low, *high});
    }
  }
  return runs;
}

std::vector<GravityRow> gravity_rows(const std::vector<GravityRun>& runs, const GravityCells& cells,
                                     double gear_ratio, const Ripple& ripple,
                                     const std::optional<TorqueOfAngle>& of_angle) {
  std::vector<GravityRow> rows;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    add_rows(runs[k], k, cells, gear_ratio, ripple, of_angle, rows);
  }
  return rows;
}

Ripple ripple_of_runs(const std::vector<GravityRun>& runs, const GravityCells& cells,
                      double gear_ratio, double b_Nm, double c_Nm,
                      const std::optional<TorqueOfAngle>& of_angle) {
  std::vector<double> angle;
  std::vector<double> residual;
  std::vector<double> white;
  double squares = 0;
  for (const GravityRun& run : runs) {
    const std::size_t first = residual.size();
    double mean = 0;
    for (std::size_t i = run.plateau.first; i < run.plateau.last; ++i) {
      const double from_zero = run.recording->q_rad[i];
      const double q = from_zero - cells.middle_rad();
      angle.push_back(gear_ratio * from_zero);
      residual.push_back(run.recording->torque_Nm[i] - b_Nm * std::cos(q) - c_Nm * std::sin(q) -
                         torque_Nm(of_angle, from_zero));
      mean += residual.back();
    }
    mean /= static_cast<double>(run.plateau.size());
    for (std::size_t i = first; i < residual.size(); ++i) {
      residual[i] -= mean;
      squares += residual[i] * residual[i];
    }
    white.push_back(white_variance_of(run));
  }
  // A fast run passes ripple so quickly that it looks like noise: not the mean.
  const double noise = statistics::median(white);
  const double sd = std::sqrt(squares / static_cast<double>(residual.size()));
  // Half a period in a block of the angle: slower lines are like gravity.
  constexpr double fewest_periods = GravityCells::blocks / 2.0;
  constexpr double least_per_turn = 0.9;
  const double turns = gear_ratio * (cells.highest_rad - cells.lowest_rad) / (2 * std::numbers::pi);
  RippleSearch search;
  search.least_periods_per_turn = std::max(least_per_turn, fewest_periods / turns);
  return find_ripple(angle, residual, torque_ripple_Nm(sd, noise), noise, search);
}

}  // namespace tribolog::method::gravity
