#include "method/selection/classical_regression.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "statistics/block_regression.h"
#include "statistics/student_t.h"
#include "statistics/white_noise.h"

namespace tribolog {
namespace {

constexpr std::size_t most_rows = 16000;
constexpr std::size_t blocks_per_recording = 10;
// Columns more alike than this cannot be told apart.
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

void add_rows(const Recording& r, std::size_t number, std::size_t group, double gear_ratio,
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

}  // namespace

std::optional<ClassicalFit> classical_regression(const std::vector<const Recording*>& recordings,
                                                 double gear_ratio, double middle_rad) {
  std::size_t samples = 0;
  for (const Recording* r : recordings) samples += r->size();
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
  const BlockRegression fit =
      block_regression(x, Eigen::Map<const Eigen::VectorXd>(rows.torque.data(), count),
                       equal_blocks(rows.recording, blocks_per_recording));
  if (!(fit.condition < largest_condition)) return std::nullopt;

  const Eigen::Vector2d bc(fit.coefficients(cosine), fit.coefficients(sine));
  const double g = bc.norm();
  const Eigen::Vector2d along = bc / g;
  const Eigen::Vector2d across(-along(1) / g, along(0) / g);
  const double freedom = std::min(fit.freedom(cosine), fit.freedom(sine));
  const Eigen::VectorXd shifts = fit.block_shifts.topRows(2).transpose() * along;
  const Eigen::VectorXd angle_shifts = fit.block_shifts.topRows(2).transpose() * across;
  const char* method = "linear least squares over everything that moves, blocks";
  const auto estimate = [&](Column k) {
    return symmetric_estimate(fit.coefficients(k), fit.half_width(k), method);
  };
  ClassicalFit out;
  out.gravity.method = "classical";
  out.gravity.freedom = freedom;
  out.gravity.block_shifts.assign(shifts.begin(), shifts.end());
  out.gravity.gravity_Nm = symmetric_estimate(g, student_t_975(freedom) * shifts.norm(), method);
  ClassicalRegression& c = out.regression;
  c.gravity_Nm = out.gravity.gravity_Nm;
  c.q_peak_rad = symmetric_estimate(middle_rad + std::atan2(bc(1), bc(0)),
                                    student_t_975(freedom) * angle_shifts.norm(), method);
  const Eigen::Matrix2d inverse = (x.transpose() * x).inverse().topLeftCorner<2, 2>();
  c.textbook_gravity_Nm = symmetric_estimate(
      g, 1.959963984540054 * fit.residual_sd * std::sqrt(along.dot(inverse * along)),
      "linear least squares, errors taken as independent");
  c.coulomb_Nm = estimate(coulomb);
  c.viscous_Nms_rad = estimate(viscous);
  c.inertia_kgm2 = estimate(inertia);
  c.offset_Nm = fit.coefficients(offset);
  c.residual_Nm = fit.residual_sd;
  c.row_noise_Nm = white_sd_beside_jumps(third_differences(rows.torque));
  return out;
}

}  // namespace tribolog
