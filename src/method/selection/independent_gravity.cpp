#include "method/selection/independent_gravity.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Core>

#include "statistics/block_regression.h"
#include "statistics/distributions.h"
#include "statistics/linear_systems.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::selection {

// The linear regression over everything that moves.

namespace {

struct ClassicalFit {
  ClassicalRegression regression;
  IndependentGravity gravity;
};

constexpr std::size_t most_rows = 16000;
constexpr std::size_t blocks_per_recording = 10;
// Columns beyond this condition number are collinear.
constexpr double largest_condition = 1e6;
constexpr double rest_share = 0.02;  // of the recording's fastest speed
enum Column { cosine, sine, coulomb, viscous, inertia, offset, columns };

struct Rows {
  std::vector<Eigen::Matrix<double, columns, 1>> x;
  std::vector<double> torque;
  std::vector<std::size_t> recording;
};

/// Means over groups of `group` neighbours.
std::vector<double> group_means(const std::vector<double>& signal, std::size_t group) {
  std::vector<double> means(signal.size() / group, 0.0);
  for (std::size_t k = 0; k < means.size(); ++k) {
    for (std::size_t i = k * group; i < (k + 1) * group; ++i) means[k] += signal[i];
    means[k] /= static_cast<double>(group);
  }
  return means;
}

std::vector<double> slopes(const std::vector<double>& t, const std::vector<double>& y) {
  std::vector<double> out(t.size(), 0.0);
  for (std::size_t k = 1; k + 1 < t.size(); ++k) {
    out[k] = (y[k + 1] - y[k - 1]) / (t[k + 1] - t[k - 1]);
  }
  return out;
}

void add_rows(const joint::Recording& r, std::size_t number, std::size_t group, double gear_ratio,
              double middle, Rows& rows) {
  const std::vector<double> t = group_means(r.t_s, group);
  const std::vector<double> q = group_means(r.q_rad, group);
  const std::vector<double> torque = group_means(r.torque_Nm, group);
  const std::vector<double> speed = slopes(t, q);
  const std::vector<double> acceleration = slopes(t, speed);
  double fastest = 0;
  for (const double v : speed) fastest = std::max(fastest, std::abs(v));
  for (std::size_t k = 2; k + 2 < t.size(); ++k) {
    if (std::abs(speed[k]) <= rest_share * fastest) continue;
    Eigen::Matrix<double, columns, 1> x;
    x(cosine) = std::cos(q[k] - middle);
    x(sine) = std::sin(q[k] - middle);
    x(coulomb) = speed[k] > 0 ? 1 : -1;
    x(viscous) = gear_ratio * speed[k];
    x(inertia) = gear_ratio * acceleration[k];
    x(offset) = 1;
    rows.x.push_back(x);
    rows.torque.push_back(torque[k]);
    rows.recording.push_back(number);
  }
}

/// Neighbouring samples are averaged in groups, so that a long log costs no more than a short one:
/// the terms are linear, and a mean of rows is a row. Speed and acceleration are slopes over
/// neighbouring groups. Rest is left out. Absent without both directions, or if the columns are
/// collinear.
std::optional<ClassicalFit> classical_regression(
    const std::vector<const joint::Recording*>& recordings, double gear_ratio, double middle_rad) {
  std::size_t samples = 0;
  for (const joint::Recording* r : recordings) samples += r->size();
  const std::size_t group = std::max<std::size_t>(1, samples / most_rows);
  Rows rows;
  for (std::size_t k = 0; k < recordings.size(); ++k) {
    add_rows(*recordings[k], k, group, gear_ratio, middle_rad, rows);
  }
  constexpr std::size_t fewest_rows = 100;
  if (rows.x.size() < fewest_rows) return std::nullopt;
  const auto count = static_cast<Eigen::Index>(rows.x.size());
  Eigen::MatrixXd x(count, static_cast<Eigen::Index>(columns));
  for (Eigen::Index i = 0; i < count; ++i) x.row(i) = rows.x[static_cast<std::size_t>(i)];
  const auto& sign = x.col(coulomb);
  if (sign.minCoeff() == sign.maxCoeff()) return std::nullopt;
  const statistics::BlockRegression fit =
      statistics::block_regression(x, Eigen::Map<const Eigen::VectorXd>(rows.torque.data(), count),
                                   statistics::equal_blocks(rows.recording, blocks_per_recording));
  if (!(fit.condition < largest_condition)) return std::nullopt;

  const Eigen::Vector2d bc(fit.coefficients(cosine), fit.coefficients(sine));
  const double g = bc.norm();
  const Eigen::Vector2d along = bc / g;
  const Eigen::Vector2d across(-along(1) / g, along(0) / g);
  const double freedom = std::min(fit.freedom(cosine), fit.freedom(sine));
  const Eigen::VectorXd shifts = fit.block_shifts.topRows(2).transpose() * along;
  const Eigen::VectorXd angle_shifts = fit.block_shifts.topRows(2).transpose() * across;
  constexpr Code method{"interval.classical"};
  const auto estimate = [&](Column k) {
    return statistics::symmetric_estimate(fit.coefficients(k), fit.half_width(k), method);
  };
  ClassicalFit out;
  out.gravity.method = IndependentMethod::classical;
  out.gravity.freedom = freedom;
  out.gravity.block_shifts.assign(shifts.begin(), shifts.end());
  out.gravity.gravity_Nm =
      statistics::symmetric_estimate(g, statistics::student_t_975(freedom) * shifts.norm(), method);
  ClassicalRegression& c = out.regression;
  c.gravity_Nm = out.gravity.gravity_Nm;
  c.q_peak_rad = statistics::symmetric_estimate(
      middle_rad + std::atan2(bc(1), bc(0)),
      statistics::student_t_975(freedom) * angle_shifts.norm(), method);
  const Eigen::Matrix2d inverse = statistics::inverse_normal(x).topLeftCorner<2, 2>();
  c.textbook_gravity_Nm = statistics::symmetric_estimate(
      g, 1.959963984540054 * fit.residual_sd * std::sqrt(along.dot(inverse * along)),
      {"interval.classical_textbook"});
  c.coulomb_Nm = estimate(coulomb);
  c.viscous_Nms_rad = estimate(viscous);
  c.inertia_kgm2 = estimate(inertia);
  c.offset_Nm = fit.coefficients(offset);
  c.residual_Nm = fit.residual_sd;
  c.row_noise_Nm = statistics::white_sd_beside_jumps(statistics::third_differences(rows.torque));
  return out;
}

}  // namespace

// Gravity from the mean of both directions at equal angle.

namespace {

constexpr std::size_t angle_bins = 400;
constexpr std::size_t blocks_of_bins = 40;

struct Bin {
  double torque[2]{}, angle[2]{}, count[2]{};  // falling, rising
};

std::vector<Bin> bins_of(const motion::Sweep& sweep, const gravity::CogSweepResult& rough,
                         double gear_ratio) {
  const std::vector<std::vector<bool>> used = sweep.used();
  std::vector<Bin> bins(angle_bins);
  const double width = (rough.highest_rad - rough.lowest_rad) / static_cast<double>(angle_bins);
  for (std::size_t r = 0; r < sweep.recordings.size(); ++r) {
    const joint::Recording& recording = *sweep.recordings[r];
    for (std::size_t i = 1; i < recording.size(); ++i) {
      if (!used[r][i]) continue;
      const double q = recording.q_rad[i];
      const auto bin =
          std::min(angle_bins - 1, static_cast<std::size_t>((q - rough.lowest_rad) / width));
      // The neighbours a little apart tell the direction through the encoder's steps.
      const std::size_t before = i >= 10 ? i - 10 : 0;
      const std::size_t after = std::min(recording.size() - 1, i + 10);
      const int side = recording.q_rad[after] > recording.q_rad[before] ? 1 : 0;
      bins[bin].torque[side] += recording.torque_Nm[i] - rough.ripple.torque_Nm(gear_ratio * q);
      if (rough.of_angle) bins[bin].torque[side] -= rough.of_angle->torque_Nm(q);
      bins[bin].angle[side] += q;
      bins[bin].count[side] += 1;
    }
  }
  return bins;
}

/// From a sweep of both directions; absent otherwise.
std::optional<IndependentGravity> gravity_of_sweep_directions(const motion::Sweep& sweep,
                                                              const gravity::CogSweepResult& rough,
                                                              double gear_ratio) {
  if (!rough.found || !rough.both_directions || !rough.constant_speed) return std::nullopt;
  std::vector<Eigen::Vector4d> columns;
  std::vector<double> mean;
  const double middle = rough.q_peak_rad.value;
  for (const Bin& bin : bins_of(sweep, rough, gear_ratio)) {
    if (bin.count[0] == 0 || bin.count[1] == 0) continue;
    Eigen::Vector4d column = Eigen::Vector4d::Zero();
    double torque = 0;
    for (const int side : {0, 1}) {
      const double q = bin.angle[side] / bin.count[side] - middle;
      column += Eigen::Vector4d(std::cos(q), std::sin(q), 1, std::sin(2 * q)) / 2;
      torque += bin.torque[side] / bin.count[side] / 2;
    }
    columns.push_back(column);
    mean.push_back(torque);
  }
  if (columns.size() < blocks_of_bins) return std::nullopt;
  const auto rows = static_cast<Eigen::Index>(columns.size());
  // A twist of the gear where the sweep can tell it.
  const Eigen::Index terms = rough.twist_rad ? 4 : 3;
  Eigen::MatrixXd x(rows, terms);
  for (Eigen::Index i = 0; i < rows; ++i) {
    x.row(i) = columns[static_cast<std::size_t>(i)].head(terms);
  }
  const Eigen::VectorXd y = Eigen::Map<const Eigen::VectorXd>(mean.data(), rows);
  const statistics::BlockRegression fit = statistics::block_regression(
      x, y, statistics::equal_blocks(std::vector<std::size_t>(columns.size()), blocks_of_bins));
  const Eigen::Vector2d bc = fit.coefficients.head<2>();
  const double g = bc.norm();
  const Eigen::Vector2d along = bc / g;
  IndependentGravity out;
  out.method = IndependentMethod::sweep_directions;
  out.freedom = fit.freedom.head<2>().minCoeff();
  const Eigen::VectorXd shifts = fit.block_shifts.topRows(2).transpose() * along;
  out.block_shifts.assign(shifts.begin(), shifts.end());
  out.gravity_Nm = statistics::symmetric_estimate(
      g, statistics::student_t_975(out.freedom) * shifts.norm(), {"interval.sweep_directions"});
  return out;
}

/// From pairs of runs of opposite direction; absent with fewer than three pairs. The sweep's offset
/// is subtracted as for the loops (surrogate_masses.h): scaled by the mean of 1 and the ratio of
/// the pair's friction to the sweep's.
std::optional<IndependentGravity> gravity_of_run_directions(
    const viscous::ViscousCurvesResult& curves, const gravity::CogSweepResult& rough) {
  std::vector<double> cosine;
  std::vector<double> torque;
  const bool has_offset =
      rough.found && rough.torque_offset_Nm && rough.coulomb_Nm && rough.coulomb_Nm->value > 0;
  double share_sum = 0;
  double ambiguity_sum = 0;
  for (std::size_t i = 0; i < curves.runs.size(); ++i) {
    const viscous::ConstantSpeedRun& run = curves.runs[i];
    if (run.partner < 0 || run.speed_rad_s < 0) continue;
    const viscous::ConstantSpeedRun& other = curves.runs[static_cast<std::size_t>(run.partner)];
    cosine.push_back((run.mean_cos + other.mean_cos) / 2);
    torque.push_back((run.torque_Nm + other.torque_Nm) / 2);
    if (!has_offset) continue;
    const double ratio = std::abs(run.torque_Nm - other.torque_Nm) / 2 / rough.coulomb_Nm->value;
    const double share = (1 + ratio) / 2;
    torque.back() -= share * rough.torque_offset_Nm->value;
    share_sum += share;
    ambiguity_sum += std::abs(rough.torque_offset_Nm->value * (1 - ratio)) / 2;
  }
  constexpr std::size_t fewest_pairs = 3;
  if (cosine.size() < fewest_pairs || curves.from_sweep) return std::nullopt;
  const auto rows = static_cast<Eigen::Index>(cosine.size());
  std::vector<std::size_t> blocks(cosine.size());
  for (std::size_t i = 0; i < blocks.size(); ++i) blocks[i] = i;
  const Eigen::MatrixXd x = Eigen::Map<const Eigen::VectorXd>(cosine.data(), rows);
  const statistics::BlockRegression fit = statistics::block_regression(
      x, Eigen::Map<const Eigen::VectorXd>(torque.data(), rows), blocks);
  IndependentGravity out;
  out.method = IndependentMethod::run_directions;
  out.freedom = fit.freedom(0);
  out.block_shifts.assign(fit.block_shifts.row(0).begin(), fit.block_shifts.row(0).end());
  if (has_offset) {
    double cosines = 0;
    for (const double c : cosine) cosines += std::abs(c);
    out.further_half_width_Nm =
        std::hypot(share_sum * rough.torque_offset_Nm->half_width(), ambiguity_sum) /
        std::max(cosines, 1e-300);
  }
  out.gravity_Nm = statistics::symmetric_estimate(
      fit.coefficients(0), std::hypot(fit.half_width(0), out.further_half_width_Nm),
      {"interval.run_pairs"});
  return out;
}

}  // namespace

std::string to_string(IndependentMethod method) {
  switch (method) {
    case IndependentMethod::sweep_directions:
      return "sweep_directions";
    case IndependentMethod::run_directions:
      return "run_directions";
    case IndependentMethod::classical:
      break;
  }
  return "classical";
}

const IndependentGravity* IndependentGravities::find(IndependentMethod method) const {
  const auto it = std::find_if(gravity.begin(), gravity.end(),
                               [&](const IndependentGravity& g) { return g.method == method; });
  return it == gravity.end() ? nullptr : &*it;
}

IndependentGravities independent_gravity(const motion::Sweep& sweep,
                                         const std::vector<const joint::Recording*>& runs,
                                         const gravity::CogSweepResult& rough,
                                         const viscous::ViscousCurvesResult& curves,
                                         const std::optional<statistics::Estimate>& q_peak_rad,
                                         double gear_ratio) {
  IndependentGravities out;
  if (auto one = gravity_of_sweep_directions(sweep, rough, gear_ratio))
    out.gravity.push_back(std::move(*one));
  // Runs and plain regression do not tell it from gravity.
  if (q_peak_rad && !rough.of_angle) {
    if (auto one = gravity_of_run_directions(curves, rough)) out.gravity.push_back(std::move(*one));
    std::vector<const joint::Recording*> moving = sweep.recordings;
    moving.insert(moving.end(), runs.begin(), runs.end());
    if (auto fit = classical_regression(moving, gear_ratio, q_peak_rad->value)) {
      out.gravity.push_back(std::move(fit->gravity));
      out.classical = std::move(fit->regression);
    }
  }
  return out;
}

}  // namespace tribolog::method::selection
