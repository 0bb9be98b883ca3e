#pragma once
// Linear systems and least squares by Eigen's decompositions, all instantiated in one source: each
// costs a compiler seconds wherever it is named. Sizes that do not fit are a programming error
// (Eigen's assertions).

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/QR>

namespace tribolog::statistics {

/// The X that makes columns * X closest to `right`, column by column. Columns that depend on others
/// to rounding get 0 (Householder QR with column pivoting).
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& right);

/// Solves symmetric * X = right for a positive semidefinite matrix, as of normal equations (LDL').
Eigen::MatrixXd solve_normal(const Eigen::MatrixXd& symmetric, const Eigen::MatrixXd& right);

/// v' S^-1 v: the square of how many standard deviations v is from 0, S its covariance.
double mahalanobis_square(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& v);

/// Of a square matrix that has one (LU with partial pivoting).
Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix);

/// Inverse of (columns' columns).
Eigen::MatrixXd inverse_normal(const Eigen::MatrixXd& columns);

/// X of upper' * X = right, `upper` a triangular factor whose lower part is not looked at.
Eigen::MatrixXd solve_transposed_triangle(const Eigen::MatrixXd& upper,
                                          const Eigen::MatrixXd& right);

/// Ascending eigenvalues of a symmetric matrix, and their orthonormal vectors, one in a column.
struct EigenSystem {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
EigenSystem eigen_system(const Eigen::MatrixXd& symmetric);

/// Descending singular values, and the left singular vectors in their order.
struct SingularValues {
  Eigen::VectorXd values;
  Eigen::MatrixXd left;
};
SingularValues singular_values(const Eigen::MatrixXd& columns);

/// Householder QR of columns that are known to be independent: solved again for each right side.
class OrthogonalColumns {
 public:
  OrthogonalColumns() = default;
  explicit OrthogonalColumns(const Eigen::MatrixXd& columns);

  /// Least squares.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;
  /// The upper triangle R.
  [[nodiscard]] Eigen::MatrixXd triangle() const;
  /// Q: orthonormal, as many columns as there were.
  [[nodiscard]] Eigen::MatrixXd basis() const;

 private:
  Eigen::HouseholderQR<Eigen::MatrixXd> qr_;
};

/// Cholesky factor L of a symmetric positive definite matrix, of which the lower triangle is read.
class CholeskyFactor {
 public:
  explicit CholeskyFactor(const Eigen::MatrixXd& matrix);

  /// X of matrix * X = right.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;
  /// X of L * X = right.
  [[nodiscard]] Eigen::MatrixXd solve_half(const Eigen::MatrixXd& right) const;
  /// NaN where the matrix is not positive definite.
  [[nodiscard]] double half_log_determinant() const;

 private:
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

/// Least squares by Householder QR of independent columns, which are overwritten; `triangle`
/// becomes their R. For long matrices: nothing is copied.
Eigen::MatrixXd least_squares_in_place(Eigen::Ref<Eigen::MatrixXd> columns,
                                       const Eigen::MatrixXd& right, Eigen::MatrixXd& triangle);

/// The upper triangle R of `matrix` takes its place, all below it becomes 0.
void reduce_to_triangle(Eigen::Ref<Eigen::MatrixXd> matrix);

}  // namespace tribolog::statistics
