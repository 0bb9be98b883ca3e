#include "method/selection/direction_means.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "statistics/block_regression.h"
#include "statistics/student_t.h"

namespace tribolog {
namespace {

constexpr std::size_t angle_bins = 400;
constexpr std::size_t blocks_of_bins = 40;

struct Bin {
  double torque[2]{}, angle[2]{}, count[2]{};  // falling, rising
};

std::vector<Bin> bins_of(const CogSweepResult& rough, double gear_ratio) {
  std::vector<Bin> bins(angle_bins);
  const double width = (rough.highest_rad - rough.lowest_rad) / static_cast<double>(angle_bins);
  for (std::size_t r = 0; r < rough.recordings.size(); ++r) {
    const Recording& recording = *rough.recordings[r];
    for (std::size_t i = 1; i < recording.size(); ++i) {
      if (!rough.used[r][i]) continue;
      const double q = recording.q_rad[i];
      const auto bin =
          std::min(angle_bins - 1, static_cast<std::size_t>((q - rough.lowest_rad) / width));
      // The neighbours a little apart tell the direction through the encoder's steps.
      const std::size_t before = i >= 10 ? i - 10 : 0;
      const std::size_t after = std::min(recording.size() - 1, i + 10);
      const int side = recording.q_rad[after] > recording.q_rad[before] ? 1 : 0;
      bins[bin].torque[side] += recording.torque_Nm[i] - rough.ripple.torque_Nm(gear_ratio * q);
      bins[bin].angle[side] += q;
      bins[bin].count[side] += 1;
    }
  }
  return bins;
}

}  // namespace

std::optional<GravityByOtherWay> gravity_of_sweep_directions(const CogSweepResult& rough,
                                                             double gear_ratio) {
  if (!rough.found || !rough.both_directions || !rough.constant_speed) return std::nullopt;
  std::vector<Eigen::Vector2d> columns;
  std::vector<double> mean;
  const double middle = rough.q_peak_rad.value;
  for (const Bin& bin : bins_of(rough, gear_ratio)) {
    if (bin.count[0] == 0 || bin.count[1] == 0) continue;
    Eigen::Vector2d column = Eigen::Vector2d::Zero();
    double torque = 0;
    for (const int side : {0, 1}) {
      const double q = bin.angle[side] / bin.count[side] - middle;
      column += Eigen::Vector2d(std::cos(q), std::sin(q)) / 2;
      torque += bin.torque[side] / bin.count[side] / 2;
    }
    columns.push_back(column);
    mean.push_back(torque);
  }
  if (columns.size() < blocks_of_bins) return std::nullopt;
  const auto rows = static_cast<Eigen::Index>(columns.size());
  Eigen::MatrixXd x(rows, 2);
  for (Eigen::Index i = 0; i < rows; ++i) x.row(i) = columns[static_cast<std::size_t>(i)];
  const Eigen::VectorXd y = Eigen::Map<const Eigen::VectorXd>(mean.data(), rows);
  const BlockRegression fit = block_regression(
      x, y, equal_blocks(std::vector<std::size_t>(columns.size()), blocks_of_bins));
  const double g = fit.coefficients.norm();
  const Eigen::Vector2d along = fit.coefficients / g;
  GravityByOtherWay out;
  out.method = "sweep_directions";
  out.freedom = fit.freedom.minCoeff();
  const Eigen::VectorXd shifts = fit.block_shifts.transpose() * along;
  out.block_shifts.assign(shifts.begin(), shifts.end());
  out.gravity_Nm = symmetric_estimate(g, student_t_975(out.freedom) * shifts.norm(),
                                      "mean of the sweep's directions, blocks of angles");
  return out;
}

std::optional<GravityByOtherWay> gravity_of_run_directions(const ViscousCurvesResult& curves) {
  std::vector<double> cosine;
  std::vector<double> torque;
  for (std::size_t i = 0; i < curves.runs.size(); ++i) {
    const ConstantSpeedRun& run = curves.runs[i];
    if (run.partner < 0 || run.speed_rad_s < 0) continue;
    const ConstantSpeedRun& other = curves.runs[static_cast<std::size_t>(run.partner)];
    cosine.push_back((run.mean_cos + other.mean_cos) / 2);
    torque.push_back((run.torque_Nm + other.torque_Nm) / 2);
  }
  constexpr std::size_t fewest_pairs = 3;
  if (cosine.size() < fewest_pairs || curves.from_sweep) return std::nullopt;
  const auto rows = static_cast<Eigen::Index>(cosine.size());
  std::vector<std::size_t> blocks(cosine.size());
  for (std::size_t i = 0; i < blocks.size(); ++i) blocks[i] = i;
  const Eigen::MatrixXd x = Eigen::Map<const Eigen::VectorXd>(cosine.data(), rows);
  const BlockRegression fit =
      block_regression(x, Eigen::Map<const Eigen::VectorXd>(torque.data(), rows), blocks);
  GravityByOtherWay out;
  out.method = "run_directions";
  out.freedom = fit.freedom(0);
  out.block_shifts.assign(fit.block_shifts.row(0).begin(), fit.block_shifts.row(0).end());
  out.gravity_Nm = symmetric_estimate(fit.coefficients(0), fit.half_width(0),
                                      "mean of each pair of runs, scatter of the pairs");
  return out;
}

}  // namespace tribolog
