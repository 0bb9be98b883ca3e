#include "statistics/linear_systems.h"

#include <Eigen/Dense>

namespace tribolog::statistics {

Eigen::MatrixXd least_squares(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& right) {
  return Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(columns).solve(right);
}

Eigen::MatrixXd solve_normal(const Eigen::MatrixXd& symmetric, const Eigen::MatrixXd& right) {
  return Eigen::LDLT<Eigen::MatrixXd>(symmetric).solve(right);
}

double mahalanobis_square(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& v) {
  return v.dot(solve_normal(covariance, v).col(0));
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix) { return matrix.inverse(); }

Eigen::MatrixXd inverse_normal(const Eigen::MatrixXd& columns) {
  return inverse(columns.transpose() * columns);
}

Eigen::MatrixXd solve_transposed_triangle(const Eigen::MatrixXd& upper,
                                          const Eigen::MatrixXd& right) {
  return upper.triangularView<Eigen::Upper>().transpose().solve(right);
}

EigenSystem eigen_system(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

SingularValues singular_values(const Eigen::MatrixXd& columns) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(columns, Eigen::ComputeThinU);
  return {svd.singularValues(), svd.matrixU()};
}

OrthogonalColumns::OrthogonalColumns(const Eigen::MatrixXd& columns) : qr_(columns) {}

Eigen::MatrixXd OrthogonalColumns::solve(const Eigen::MatrixXd& right) const {
  return qr_.solve(right);
}

Eigen::MatrixXd OrthogonalColumns::triangle() const {
  return qr_.matrixQR().topRows(qr_.cols()).triangularView<Eigen::Upper>();
}

Eigen::MatrixXd OrthogonalColumns::basis() const {
  return qr_.householderQ() * Eigen::MatrixXd::Identity(qr_.rows(), qr_.cols());
}

CholeskyFactor::CholeskyFactor(const Eigen::MatrixXd& matrix) : factor_(matrix) {}

Eigen::MatrixXd CholeskyFactor::solve(const Eigen::MatrixXd& right) const {
  return factor_.solve(right);
}

Eigen::MatrixXd CholeskyFactor::solve_half(const Eigen::MatrixXd& right) const {
  return factor_.matrixL().solve(right);
}

double CholeskyFactor::half_log_determinant() const {
  return factor_.matrixLLT().diagonal().array().log().sum();
}

Eigen::MatrixXd least_squares_in_place(Eigen::Ref<Eigen::MatrixXd> columns,
                                       const Eigen::MatrixXd& right, Eigen::MatrixXd& triangle) {
  const Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> qr(columns);
  triangle = columns.topRows(columns.cols()).triangularView<Eigen::Upper>();
  return qr.solve(right);
}

void reduce_to_triangle(Eigen::Ref<Eigen::MatrixXd> matrix) {
  const Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> qr(matrix);
  for (Eigen::Index k = 0; k < matrix.cols(); ++k) {
    matrix.col(k).tail(matrix.rows() - k - 1).setZero();
  }
}

}  // namespace tribolog::statistics
