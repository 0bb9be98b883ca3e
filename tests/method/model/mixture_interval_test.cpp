// The interval of a quantity is that of a mixture of Student's t over laws of friction, told from a
// posterior that is written down here.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "method/model/model_quantities.h"
#include "statistics/distributions.h"

namespace tribolog::mixture_interval_test {
namespace {

using method::model::Cell;
using method::model::JointModel;
using method::model::LawPosterior;
using method::model::ModelQuantity;
using method::model::ModelResult;

constexpr double freedom = 20;

/// A constant friction torque, one law for each of `means`.
JointModel model_of(const std::vector<double>& means, const std::vector<double>& weights,
                    double sd) {
  JointModel m;
  for (int k = 0; k < 20; ++k) {
    Cell cell;
    cell.speed_rad_s = 1 + k;
    cell.direction = k % 2 == 0 ? 1 : -1;
    cell.count = 1;
    cell.recording = k;
    m.cells.rows.push_back(cell);
  }
  m.point.fastest_rad_s = 20;
  m.point.friction_Nm = 1;
  m.laws.fastest_rad_s = 20;
  m.laws.columns.resize(1);
  m.first = {0};
  m.weight = Eigen::ArrayXd::Ones(20);
  m.residual_Nm = Eigen::ArrayXd::Zero(20);
  for (std::size_t k = 0; k < means.size(); ++k) {
    LawPosterior p;
    p.weight = weights[k];
    p.law.index = {0};
    const Eigen::Matrix2Xd coulomb = Eigen::Vector2d(1, 0);
    p.law.meanings = {coulomb, coulomb, coulomb};
    p.law.scale = Eigen::VectorXd::Ones(1);
    p.mean = Eigen::VectorXd::Constant(1, means[k]);
    p.covariance = Eigen::MatrixXd::Constant(1, 1, sd * sd);
    m.posteriors.push_back(p);
  }
  return m;
}

ModelQuantity coulomb_of(const JointModel& m) {
  const ModelResult result = describe_joint_model(m, {});
  const ModelQuantity* q = result.find(joint::Quantity::coulomb_torque);
  return q == nullptr ? ModelQuantity{} : *q;
}

TEST(MixtureInterval, OfOneLawIsStudents) {
  for (const double sd : {1e-6, 0.1, 30.0}) {
    const ModelQuantity q = coulomb_of(model_of({2}, {1}, sd));
    const double half = statistics::student_t_975(freedom) * sd;
    EXPECT_NEAR(q.estimate, 2, 1e-12);
    EXPECT_NEAR(q.high - 2, half, 1e-6 * half);
    EXPECT_NEAR(2 - q.low, half, 1e-6 * half);
  }
}

TEST(MixtureInterval, OfLawsFarApartReachesFromOneToTheOther) {
  constexpr double sd = 0.01;
  // 2.5 % of all are 5 % of the lower half, and the 95 % quantile of 20 degrees of freedom is this.
  constexpr double t_95 = 1.724718;
  const ModelQuantity q = coulomb_of(model_of({1, 3}, {0.5, 0.5}, sd));
  EXPECT_NEAR(q.estimate, 2, 1e-12);
  EXPECT_NEAR(q.low, 1 - t_95 * sd, 1e-5 * sd);
  EXPECT_NEAR(q.high, 3 + t_95 * sd, 1e-5 * sd);
  ASSERT_FALSE(q.shares.empty());
  EXPECT_EQ(q.shares[0].effect, "choice_of_law");
  EXPECT_GT(q.shares[0].share, 0.99);
}

TEST(MixtureInterval, OfAnUnlikelyLawIsHardlyWider) {
  constexpr double sd = 0.01;
  const double half = statistics::student_t_975(freedom) * sd;
  const ModelQuantity q = coulomb_of(model_of({1, 3}, {0.99, 0.01}, sd));
  EXPECT_LT(q.high, 1 + 1.5 * half);
  EXPECT_GT(q.high, 1 + half);
  // One law in twenty is more than the 2.5 % that the interval leaves out.
  EXPECT_GT(coulomb_of(model_of({1, 3}, {0.95, 0.05}, sd)).high, 2.9);
}

TEST(MixtureInterval, OfFrictionAtASpeedIsTheSame) {
  const ModelResult result = describe_joint_model(model_of({2}, {1}, 0.1), {0.2, 5, 100});
  std::vector<double> speeds;
  for (const ModelQuantity& q : result.quantities) {
    if (q.quantity) continue;
    speeds.push_back(q.speed_rad_s);
    EXPECT_NEAR(q.high - q.low, 2 * statistics::student_t_975(freedom) * 0.1, 1e-6);
  }
  EXPECT_EQ(speeds, std::vector<double>{5}) << "others were not measured";
}

}  // namespace
}  // namespace tribolog::mixture_interval_test
