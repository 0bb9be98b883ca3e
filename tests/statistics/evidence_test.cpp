// Sizes of effects by the evidence, and how many residuals say as much as one.

#include "statistics/evidence.h"

#include <cmath>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"

namespace tribolog::evidence_test {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Fixed point of the precision for coefficients that data show to within `error`.
double precision_of(const VectorXd& shown, double error, double scale, double freedom,
                    double least = 1e-4) {
  double precision = 1;
  for (int k = 0; k < 200; ++k) {
    const double information = 1 / (error * error);
    const double prior = precision / (scale * scale);
    const double variance = 1 / (information + prior);
    precision = statistics::next_precision(
        shown * information * variance, VectorXd::Constant(shown.size(), variance),
        VectorXd::Constant(shown.size(), scale), precision, freedom, least);
  }
  return precision;
}

TEST(Evidence, WhatDataDoNotShowStaysTypical) {
  EXPECT_NEAR(precision_of(VectorXd::Zero(4), 1e6, 0.5, 2), 1, 1e-3);
}

TEST(Evidence, ManyCoefficientsTellTheirSize) {
  statistics::RandomStream random(3, 1);
  VectorXd shown(20000);
  for (double& one : shown) one = 0.5 * 4 * random.normal();
  EXPECT_NEAR(1 / std::sqrt(precision_of(shown, 1e-3, 0.5, 2)), 4, 0.2);
  // Errors of the coefficients are not taken for their size.
  for (double& one : shown) one += 3 * random.normal();
  EXPECT_NEAR(1 / std::sqrt(precision_of(shown, 3, 0.5, 2)), 4, 0.4);
}

TEST(Evidence, TheCapHolds) {
  EXPECT_EQ(precision_of(VectorXd::Constant(3, 1e3), 1e-3, 0.5, 2, 0.01), 0.01);
}

TEST(Evidence, AutocorrelationOfAFirstOrderProcess) {
  statistics::RandomStream random(8, 1);
  for (const double share : {0.0, 0.5, 0.8}) {
    VectorXd residuals(40000);
    double last = 0;
    for (double& one : residuals) {
      last = share * last + random.normal();
      one = last;
    }
    const double found = statistics::integrated_autocorrelation(residuals, 200, 1,
                                                                [](Index, Index) { return true; });
    const double exact = (1 + share) / (1 - share);
    EXPECT_NEAR(found, exact, 0.08 * exact) << share;
  }
}

TEST(Evidence, OnlyResidualsThatBelongTogetherCount) {
  // Pairs of equal values, each pair a stroke of its own.
  statistics::RandomStream random(9, 1);
  VectorXd residuals(4000);
  for (Index i = 0; i < residuals.size(); i += 2) {
    residuals(i) = residuals(i + 1) = random.normal();
  }
  const auto in_pair = [](Index i, Index lag) { return i / 2 == (i - lag) / 2; };
  EXPECT_NEAR(statistics::integrated_autocorrelation(residuals, 100, 1, in_pair), 3, 0.2);
  EXPECT_EQ(statistics::integrated_autocorrelation(residuals, 100, 3000, in_pair), 1);
}

}  // namespace
}  // namespace tribolog::evidence_test
