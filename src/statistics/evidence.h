#pragma once
// What a conjugate solve with effects of unknown size needs beside linear algebra: the next size of
// an effect by the evidence, and how many residuals say as much as one.

#include <Eigen/Core>

namespace tribolog::statistics {

/// Coefficients scale x lambda x N(0,1) of one effect, lambda^2 ~ inverse gamma(freedom/2,
/// freedom/2): the next 1/lambda^2 on the way to the fixed point of the evidence (MacKay 1992).
/// @param mean, variance posterior of the coefficients. @param scale of each.
/// @param precision the present 1/lambda^2. @param least that it may have.
double next_precision(const Eigen::VectorXd& mean, const Eigen::VectorXd& variance,
                      const Eigen::VectorXd& scale, double precision, double freedom, double least);

/// As how many residuals one independent one counts: one and twice the sum of their
/// autocorrelations, up to the first that is next to nothing.
/// @param most lag that is looked at.
/// @param is_beside whether residual i and the one `lag` before it belong together; where fewer
/// than `fewest` do, the sum ends.
template <typename IsBeside>
double integrated_autocorrelation(const Eigen::VectorXd& residuals, Eigen::Index most,
                                  Eigen::Index fewest, IsBeside is_beside) {
  constexpr double next_to_nothing = 0.03;
  const Eigen::Index n = residuals.size();
  const double power = residuals.squaredNorm() / static_cast<double>(n);
  double total = 1;
  for (Eigen::Index lag = 1; lag <= most && lag < n && power > 0; ++lag) {
    double sum = 0;
    Eigen::Index count = 0;
    for (Eigen::Index i = lag; i < n; ++i) {
      if (!is_beside(i, lag)) continue;
      sum += residuals(i) * residuals(i - lag);
      ++count;
    }
    if (count < fewest) break;
    const double share = sum / static_cast<double>(count) / power;
    if (share < next_to_nothing) break;
    total += 2 * share;
  }
  return total;
}

}  // namespace tribolog::statistics
