#include "method/model/unlike_recordings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Core>

#include "statistics/linear_systems.h"
#include "statistics/order_statistics.h"

namespace tribolog::method::model {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<int> foreign_recordings(const Cells& cells) {
  std::map<int, std::vector<Index>> rows;
  for (Index i = 0; i < cells.size(); ++i) {
    rows[cells.rows[static_cast<std::size_t>(i)].recording].push_back(i);
  }
  if (rows.size() < 6) return {};
  const ArrayXd y = cells.of(&Cell::torque_Nm);
  const ArrayXd count = cells.of(&Cell::count);
  MatrixXd x = plain_columns(cells);
  x.array().rowwise() /= (x.array().square().colwise().mean().sqrt() + 1e-12);
  const double some = 0.05 * median(y.abs());
  ArrayXd weight(cells.size());
  std::map<int, double> misfit;
  std::map<int, double> size;
  for (const auto& [key, of] : rows) {
    const double samples = count(of).sum();
    weight(of) = count(of) / samples;
    size[key] = std::sqrt((count(of) * y(of).square()).sum() / samples);
  }
  const ArrayXd by_recording = weight;
  constexpr int steps = 15;
  for (int k = 0; k < steps; ++k) {
    MatrixXd gram = x.transpose() * weight.matrix().asDiagonal() * x;
    gram.diagonal().array() += 1e-6 * weight.sum();
    const VectorXd theta = statistics::solve_normal(gram, x.transpose() * (weight * y).matrix());
    const ArrayXd r = y - (x * theta).array();
    for (const auto& [key, of] : rows) {
      misfit[key] = std::sqrt((by_recording(of) * r(of).square()).sum());
      weight(of) = by_recording(of) / (misfit[key] + some);
    }
  }
  std::vector<double> all;
  for (const auto& [key, value] : misfit) all.push_back(value);
  const double usual = statistics::median(all);
  std::vector<int> foreign;
  for (const auto& [key, value] : misfit) {
    if (value > 0.7 * size[key] && value > 6 * usual) foreign.push_back(key);
  }
  return foreign;
}

std::vector<int> unlike_recordings(const JointModel& m) {
  std::map<int, std::pair<double, double>> sums;
  ArrayXd own = m.residual_Nm;
  const std::size_t e = m.find("friction_of_recording");
  if (e < m.effects.size()) {
    own += (m.effects[e].columns * m.posteriors[0].mean.segment(m.first[e], m.width(e))).array();
  }
  for (Index i = 0; i < m.cells.size(); ++i) {
    const Cell& row = m.cells.rows[static_cast<std::size_t>(i)];
    auto& [square, count] = sums[row.recording];
    square += row.count * own[i] * own[i];
    count += row.count;
  }
  if (sums.size() < 6) return {};
  std::vector<double> sizes;
  for (const auto& [key, sum] : sums) sizes.push_back(std::sqrt(sum.first / sum.second));
  const double limit = std::max(6 * statistics::median(sizes), 0.1 * m.point.friction_Nm);
  std::vector<int> unlike;
  for (const auto& [key, sum] : sums) {
    if (std::sqrt(sum.first / sum.second) > limit) unlike.push_back(key);
  }
  return unlike;
}

}  // namespace tribolog::method::model
