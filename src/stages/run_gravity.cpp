#include "stages/run_gravity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "stages/block_regression.h"
#include "stages/plateaus.h"
#include "stages/student_t.h"

namespace tribolog {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double least_travel_share = 0.25;
constexpr double least_travel_rad = 3 / degrees;
constexpr std::size_t cells = 240;  // over all angles; a run's mean in each is one row
constexpr std::size_t angle_blocks = 24;
constexpr std::size_t fewest_blocks = 6;
// As for the sweep: a chance of far below 0.1 % without gravity.
constexpr double least_evidence = 27;
// Wider than this share of itself an amplitude is no candidate for the mass.
constexpr double widest_share = 0.2;
constexpr double hardly = 0.05;  // share of a way

struct Run {
  const Recording* recording;
  Plateau plateau;
  double low_rad, high_rad;
};

/// Mean of a run within a cell of the angle, less the mean of the run.
struct Row {
  std::size_t run, cell;
  double cosine, sine, torque_Nm;
};

std::vector<Run> plateaus_of(const std::vector<const Recording*>& recordings) {
  std::vector<Run> runs;
  for (const Recording* r : recordings) {
    for (const Plateau& p : find_plateaus(*r).plateaus) {
      const auto begin = r->q_rad.begin();
      const auto [low, high] = std::minmax_element(begin + static_cast<std::ptrdiff_t>(p.first),
                                                   begin + static_cast<std::ptrdiff_t>(p.last));
      runs.push_back({r, p, *low, *high});
    }
  }
  return runs;
}

/// The rows of one run. Taking the run's means off all columns is the same as an offset of its own.
void add_rows(const Run& run, std::size_t number, double lowest, double width, double middle,
              std::vector<Row>& rows) {
  std::vector<Row> sums(cells, Row{number, 0, 0, 0, 0});
  std::vector<double> counts(cells, 0.0);
  for (std::size_t i = run.plateau.first; i < run.plateau.last; ++i) {
    const double q = run.recording->q_rad[i];
    const auto cell = std::min(cells - 1, static_cast<std::size_t>((q - lowest) / width));
    // 1 - cos q as 2 sin^2(q/2): no cancellation over a short way.
    const double half = std::sin((q - middle) / 2);
    sums[cell].cosine += -2 * half * half;
    sums[cell].sine += std::sin(q - middle);
    sums[cell].torque_Nm += run.recording->torque_Nm[i];
    counts[cell] += 1;
  }
  Row mean{number, 0, 0, 0, 0};
  double used = 0;
  const std::size_t first = rows.size();
  for (std::size_t cell = 0; cell < cells; ++cell) {
    if (counts[cell] == 0) continue;
    const Row& s = sums[cell];
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

/// Least squares with blocks in the order of the rows; `block` gives a row's block.
template <class Block>
BlockRegression fit(std::vector<Row> rows, Block block) {
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const Row& a, const Row& b) { return block(a) < block(b); });
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd x(n, 2);
  Eigen::VectorXd y(n);
  std::vector<std::size_t> blocks;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool is_new = i > 0 && block(rows[i]) != block(rows[i - 1]);
    blocks.push_back(i == 0 ? 0 : blocks.back() + (is_new ? 1 : 0));
    x.row(static_cast<Eigen::Index>(i)) << rows[i].cosine, rows[i].sine;
    y(static_cast<Eigen::Index>(i)) = rows[i].torque_Nm;
  }
  return block_regression(x, y, blocks);
}

/// Half width of a quantity with gradient `g`: the larger of the two ways to form blocks.
double half_width(const Eigen::Vector2d& g, const BlockRegression& a, const BlockRegression& b) {
  return std::max(a.half_width_along(g), b.half_width_along(g));
}

bool lifts_always(const std::vector<Run>& runs, double q_peak) {
  double lifted = 0;
  double all = 0;
  for (const Run& run : runs) {
    const double direction = run.plateau.speed_rad_s > 0 ? 1.0 : -1.0;
    for (std::size_t i = run.plateau.first; i < run.plateau.last; ++i) {
      lifted += direction * std::cos(run.recording->q_rad[i] - q_peak) > 0 ? 1 : 0;
      all += 1;
    }
  }
  return lifted >= (1 - hardly) * all || lifted <= hardly * all;
}

}  // namespace

RunGravityResult identify_run_gravity(const std::vector<const Recording*>& recordings) {
  RunGravityResult out;
  if (recordings.empty()) {
    out.reason = "no run at constant speed was recorded";
    return out;
  }
  std::vector<Run> runs = plateaus_of(recordings);
  const std::size_t all_runs = runs.size();
  double widest = 0;
  for (const Run& run : runs) widest = std::max(widest, run.high_rad - run.low_rad);
  const double least = std::max(least_travel_rad, least_travel_share * widest);
  runs.erase(std::remove_if(runs.begin(), runs.end(),
                            [&](const Run& run) { return run.high_rad - run.low_rad < least; }),
             runs.end());
  out.runs_used = runs.size();
  out.runs_left_out = all_runs - runs.size();
  if (runs.empty()) {
    out.reason = fmt::format(
        "no run at constant speed travels far enough for gravity: the widest {:.2g}°, at least "
        "{:.2g}° are needed",
        widest * degrees, least_travel_rad * degrees);
    return out;
  }
  out.lowest_rad = runs.front().low_rad;
  out.highest_rad = runs.front().high_rad;
  for (const Run& run : runs) {
    out.lowest_rad = std::min(out.lowest_rad, run.low_rad);
    out.highest_rad = std::max(out.highest_rad, run.high_rad);
    out.samples_used += run.plateau.size();
  }
  const double middle = (out.lowest_rad + out.highest_rad) / 2;
  const double width = (out.highest_rad - out.lowest_rad) / static_cast<double>(cells);
  std::vector<Row> rows;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    add_rows(runs[k], k, out.lowest_rad, width, middle, rows);
  }
  const auto angle_block = [](const Row& r) { return r.cell * angle_blocks / cells; };
  const auto run_block = [](const Row& r) { return r.run; };
  const BlockRegression by_angle = fit(rows, angle_block);
  // Too few runs say nothing about how runs differ.
  const BlockRegression by_run = runs.size() >= fewest_blocks ? fit(rows, run_block) : by_angle;
  const double b = by_angle.coefficients(0);
  const double c = by_angle.coefficients(1);
  const double g = std::hypot(b, c);
  out.residual_Nm = by_angle.residual_sd;
  const char* method = "runs at constant speed, blocks of the angle and of the runs";
  out.gravity_Nm = symmetric_estimate(
      g, half_width(Eigen::Vector2d(b, c) / std::max(g, 1e-300), by_angle, by_run), method);
  const Eigen::Vector2d angle_gradient = Eigen::Vector2d(-c, b) / std::max(g * g, 1e-300);
  double q_peak = middle + std::atan2(c, b);
  q_peak -= 2 * std::numbers::pi * std::round((q_peak - middle) / (2 * std::numbers::pi));
  out.q_peak_rad = symmetric_estimate(q_peak, half_width(angle_gradient, by_angle, by_run), method);
  const Eigen::Vector2d bc(b, c);
  const auto evidence = [&](const BlockRegression& r) {
    return bc.dot(Eigen::Matrix2d(r.covariance).ldlt().solve(bc));
  };
  const double least_shown = std::min(evidence(by_angle), evidence(by_run));
  if (least_shown < least_evidence || !(out.gravity_Nm.low > 0) ||
      !(out.gravity_Nm.half_width() <= widest_share * g)) {
    out.reason = fmt::format(
        "the runs at constant speed do not show gravity well enough: amplitude {:.3g} N·m with a "
        "95 % interval from {:.3g} to {:.3g} N·m; longer ways, or a slow sweep, would",
        g, out.gravity_Nm.low, out.gravity_Nm.high);
    return out;
  }
  out.always_lifts = lifts_always(runs, q_peak);
  out.found = true;
  return out;
}

}  // namespace tribolog
