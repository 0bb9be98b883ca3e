#include "statistics/wandering_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

namespace tribolog::statistics {
namespace {

Eigen::MatrixXd correlation(const BlockMeans& blocks, double time_s) {
  const Eigen::Index count = blocks.time_s.size();
  Eigen::MatrixXd k = Eigen::MatrixXd::Identity(count, count);
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = 0; b < a; ++b) {
      const bool together = blocks.recording[static_cast<std::size_t>(a)] ==
                            blocks.recording[static_cast<std::size_t>(b)];
      const double apart_s = std::abs(blocks.time_s(a) - blocks.time_s(b));
      k(a, b) = k(b, a) = together ? std::exp(-apart_s / time_s) : 0.0;
    }
  }
  return k;
}

/// Longest time that one recording spans.
double longest_span_s(const BlockMeans& blocks) {
  double longest = 0;
  for (Eigen::Index a = 0; a < blocks.time_s.size(); ++a) {
    for (Eigen::Index b = 0; b < a; ++b) {
      if (blocks.recording[static_cast<std::size_t>(a)] ==
          blocks.recording[static_cast<std::size_t>(b)]) {
        longest = std::max(longest, std::abs(blocks.time_s(a) - blocks.time_s(b)));
      }
    }
  }
  return longest;
}

struct Likelihood {
  double value{};
  double white_variance{};
};

/// @param wander ratio of the wandering level's variance to that of the white means.
/// @param share generalised eigenvalues of the level's covariance with respect to the white one's.
Likelihood likelihood(const Eigen::VectorXd& errors, const Eigen::VectorXd& share, double wander) {
  const Eigen::ArrayXd scale = 1 + wander * share.array().max(0.0);
  const double variance = (errors.array().square() / scale).mean();
  const auto count = static_cast<double>(errors.size());
  return {-0.5 * (count * std::log(variance) + scale.log().sum()), variance};
}

}  // namespace

std::optional<WanderingNoise> wandering_noise(const BlockMeans& blocks) {
  constexpr Eigen::Index fewest_left = 6;
  constexpr double doubt_beforehand = 0.4;  // that nothing wanders
  constexpr double most_doubt = 0.2;
  constexpr std::array times{0.1, 0.5, 2.0, 8.0, 32.0};  // of the longest recording
  constexpr int ratios = 24;
  constexpr double smallest_ratio = 0.03;
  constexpr double step = 1.6;
  const Eigen::Index count = blocks.residuals.size();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(blocks.columns);
  const Eigen::Index left = count - qr.rank();
  const double span_s = longest_span_s(blocks);
  if (left < fewest_left || !(span_s > 0) || !(blocks.residuals.squaredNorm() > 0)) {
    return std::nullopt;
  }
  const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(count, count);
  const Eigen::MatrixXd beside = q.rightCols(left);  // what the columns cannot take up
  const Eigen::VectorXd white = blocks.samples.mean() * blocks.samples.cwiseInverse();
  const Eigen::MatrixXd of_white = beside.transpose() * white.asDiagonal() * beside;
  const Eigen::VectorXd means = beside.transpose() * blocks.residuals;

  // Few blocks leave variance and time open: each that they allow counts by how likely it is.
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(count, count);
  double weights = 0;
  double white_variance = 0;
  WanderingNoise out;
  for (const double share_of_span : times) {
    const Eigen::MatrixXd correlated = correlation(blocks, share_of_span * span_s);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
        beside.transpose() * correlated * beside, of_white);
    const Eigen::VectorXd errors = eigen.eigenvectors().transpose() * means;
    const Likelihood alone = likelihood(errors, eigen.eigenvalues(), 0);
    double level = 0;
    double ratio = smallest_ratio;
    for (int k = 0; k < ratios; ++k, ratio *= step) {
      const Likelihood with = likelihood(errors, eigen.eigenvalues(), ratio);
      const double weight = std::exp(with.value - alone.value);
      weights += weight;
      level += weight * ratio * with.white_variance;
      white_variance += weight * with.white_variance;
    }
    covariance += level * correlated;
    const double none = doubt_beforehand / (1 - doubt_beforehand) * ratios;
    weights += none;
    white_variance += none * alone.white_variance;
    out.doubt += none;
  }
  covariance /= weights;
  out.doubt /= weights;
  if (out.doubt > most_doubt) return std::nullopt;
  out.standard_deviation = std::sqrt(covariance.diagonal().mean());
  covariance.diagonal() += white_variance / weights * white;
  out.shifts = blocks.effects * Eigen::MatrixXd(covariance.llt().matrixL());
  return out;
}

}  // namespace tribolog::statistics
