#include "statistics/evidence.h"

#include <algorithm>

namespace tribolog::statistics {

double next_precision(const Eigen::VectorXd& mean, const Eigen::VectorXd& variance,
                      const Eigen::VectorXd& scale, double precision, double freedom,
                      double least) {
  const double unknown = (variance.array() / scale.array().square()).sum();
  const double size = mean.cwiseQuotient(scale).squaredNorm();
  const double known = std::max(0.0, static_cast<double>(scale.size()) - precision * unknown);
  return std::max((freedom + known) / (freedom + size), least);
}

}  // namespace tribolog::statistics
