#include "method/viscous/torque_balance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "statistics/block_regression.h"

namespace tribolog::method::viscous {

TorqueBalance balance_directions(const ViscousCurvesResult& curves,
                                 const gravity::CogSweepResult& rough) {
  TorqueBalance out;
  if (!rough.found) return out;
  out.offset_Nm = rough.torque_offset_Nm;
  if (!rough.torque_offset_Nm || !rough.coulomb_Nm || curves.from_sweep) return out;
  std::vector<double> friction{rough.coulomb_Nm->value};
  std::vector<double> mean{rough.torque_offset_Nm->value};
  double cosines = 0;
  for (const ConstantSpeedRun& run : curves.runs) {
    if (run.speed_rad_s < 0 || run.partner < 0 || !std::isfinite(run.direction_mean_Nm)) continue;
    friction.push_back(std::abs(run.direction_difference_Nm));
    mean.push_back(run.direction_mean_Nm - rough.gravity_Nm.value * run.direction_mean_cos);
    cosines += std::abs(run.direction_mean_cos);
  }
  out.pairs = friction.size() - 1;
  constexpr std::size_t fewest_pairs = 5;
  constexpr double least_change = 1.3;  // of friction with speed
  const auto [low, high] = std::minmax_element(friction.begin(), friction.end());
  if (out.pairs < fewest_pairs || !(*high > least_change * *low)) return out;
  const auto rows = static_cast<Eigen::Index>(friction.size());
  Eigen::MatrixXd x(rows, 2);
  x.col(0).setOnes();
  x.col(1) = Eigen::Map<const Eigen::VectorXd>(friction.data(), rows);
  std::vector<std::size_t> blocks;
  for (std::size_t i = 0; i < friction.size(); ++i) blocks.push_back(i);
  const statistics::BlockRegression fit =
      statistics::block_regression(x, Eigen::Map<const Eigen::VectorXd>(mean.data(), rows), blocks);
  // An error of the gravity torque is an offset of all pairs.
  const double of_gravity =
      rough.gravity_Nm.half_width() * cosines / static_cast<double>(out.pairs);
  constexpr Code method{"interval.scatter_of_pairs"};
  out.offset_Nm = statistics::symmetric_estimate(fit.coefficients(0),
                                                 std::hypot(fit.half_width(0), of_gravity), method);
  out.asymmetry = statistics::symmetric_estimate(fit.coefficients(1), fit.half_width(1), method);
  return out;
}

}  // namespace tribolog::method::viscous
