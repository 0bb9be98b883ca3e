#include "method/hysteresis/lugre_problem.h"

#include <algorithm>

#include <Eigen/Core>

#include "statistics/linear_systems.h"

namespace tribolog::method::hysteresis {

std::shared_ptr<const simulate::Motion> LuGreInput::motor_motion(double gear_ratio) const {
  if (traced != nullptr) return traced->motor_motion(gear_ratio);
  return std::make_shared<simulate::HarmonicMotion>(motion->motor_motion(gear_ratio));
}

LuGreLoopModel LuGreInput::model(double gear_ratio, double q_peak_rad, LuGreGrain grain) const {
  grain.compared_from_s = settled_from_s;
  return {*recording, motor_motion(gear_ratio), gear_ratio, q_peak_rad, grain};
}

double LuGreInput::frequency_Hz() const {
  return traced != nullptr ? traced->frequency_Hz : motion->frequency_Hz;
}

double LuGreInput::centre_rad() const {
  return traced != nullptr ? traced->centre_rad : motion->centre_rad;
}

std::vector<std::size_t> LuGreInput::half_loops() const {
  std::vector<std::size_t> out;
  const auto& t = recording->t_s;
  for (const double time : t) {
    const double since = time - t.front();
    if (traced == nullptr) {
      out.push_back(static_cast<std::size_t>(since * 2 * motion->frequency_Hz));
    } else {
      const auto& turns = traced->turns_s;
      out.push_back(static_cast<std::size_t>(std::upper_bound(turns.begin(), turns.end(), since) -
                                             turns.begin()));
    }
  }
  return out;
}

namespace {

using Shared = LuGreShared;
using Triangle = Eigen::MatrixXd;

/// Maps the fit's parameters to its vector, and back.
class Layout {
 public:
  Layout(const LuGreFreedom& free, std::size_t recordings)
      : free_(free),
        shared_(static_cast<Eigen::Index>(free.shared.size())),
        local_(free.starts ? 2 : 1),
        recordings_(static_cast<Eigen::Index>(recordings)) {}

  [[nodiscard]] Eigen::Index size() const { return shared_ + local_ * recordings_; }
  [[nodiscard]] Eigen::Index shared() const { return shared_; }
  [[nodiscard]] Eigen::Index local() const { return local_; }
  [[nodiscard]] Eigen::Index first_of(std::size_t recording) const {
    return shared_ + local_ * static_cast<Eigen::Index>(recording);
  }
  /// The model's columns that are free: this recording's own, then the shared.
  [[nodiscard]] std::vector<Eigen::Index> columns() const {
    std::vector<Eigen::Index> used{0};
    if (free_.starts) used.push_back(1);
    for (const Shared::Index k : free_.shared) used.push_back(LuGreLoopModel::local_count + k);
    return used;
  }
  [[nodiscard]] bool bends(const LuGrePoint& at) const {
    return free_.has(Shared::fall) || at.shared(Shared::fall) != 0;
  }
  [[nodiscard]] Eigen::VectorXd vector_of(const LuGrePoint& point) const {
    Eigen::VectorXd p(size());
    for (Eigen::Index k = 0; k < shared_; ++k) p(k) = point.shared(free_.shared[at(k)]);
    for (std::size_t r = 0; r < point.locals.size(); ++r) {
      p(first_of(r)) = point.locals[r].gravity_Nm;
      if (free_.starts) p(first_of(r) + 1) = point.locals[r].start_rad;
    }
    return p;
  }
  /// @param held supplies the values that are not free.
  [[nodiscard]] LuGrePoint point_of(const Eigen::VectorXd& p, LuGrePoint held) const {
    for (Eigen::Index k = 0; k < shared_; ++k) held.shared(free_.shared[at(k)]) = p(k);
    for (std::size_t r = 0; r < held.locals.size(); ++r) {
      held.locals[r].gravity_Nm = p(first_of(r));
      if (free_.starts) held.locals[r].start_rad = p(first_of(r) + 1);
    }
    return held;
  }

 private:
  static std::size_t at(Eigen::Index k) { return static_cast<std::size_t>(k); }
  const LuGreFreedom& free_;
  Eigen::Index shared_, local_, recordings_;
};

/// Triangular factor of the chosen columns and the residuals, chunk by chunk within the cache.
Triangle compressed(const LuGreLoopModel::Rows& rows, const Eigen::VectorXd& residuals,
                    const std::vector<Eigen::Index>& columns) {
  constexpr Eigen::Index chunk = 384;
  const auto n = static_cast<Eigen::Index>(columns.size());
  Eigen::MatrixXd stack = Eigen::MatrixXd::Zero(n + 1 + chunk, n + 1);
  for (Eigen::Index first = 0; first < rows.rows(); first += chunk) {
    const Eigen::Index count = std::min(chunk, rows.rows() - first);
    for (Eigen::Index k = 0; k < n; ++k) {
      stack.col(k).segment(n + 1, count) =
          rows.col(columns[static_cast<std::size_t>(k)]).segment(first, count);
    }
    stack.col(n).segment(n + 1, count) = residuals.segment(first, count);
    statistics::reduce_to_triangle(stack.topRows(n + 1 + count));
  }
  return stack.topRows(n + 1);
}

/// Reduced rows that replace those of all recordings: J and r with the same J'J, J'r and |r|.
struct Reduced {
  Eigen::VectorXd at;
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;
};

void reduce(const std::vector<LuGreLoopModel>& models, const Layout& layout,
            const LuGrePoint& point, Reduced& out) {
  const std::vector<Eigen::Index> columns = layout.columns();
  const auto height = static_cast<Eigen::Index>(columns.size()) + 1;
  const Eigen::Index rows = height * static_cast<Eigen::Index>(models.size());
  out.residuals.resize(rows);
  out.jacobian.setZero(rows, layout.size());
  Eigen::VectorXd residuals;
  LuGreLoopModel::Rows derivatives;
  for (std::size_t r = 0; r < models.size(); ++r) {
    models[r].evaluate(point.shared, point.locals[r], layout.bends(point), residuals, derivatives);
    const Triangle triangle = compressed(derivatives, residuals, columns);
    const Eigen::Index top = height * static_cast<Eigen::Index>(r);
    out.jacobian.block(top, layout.first_of(r), height, layout.local()) =
        triangle.leftCols(layout.local());
    out.jacobian.block(top, 0, height, layout.shared()) =
        triangle.middleCols(layout.local(), layout.shared());
    out.residuals.segment(top, height) = triangle.rightCols(1);
  }
}

}  // namespace

bool LuGreFreedom::has(Shared::Index parameter) const {
  return std::find(shared.begin(), shared.end(), parameter) != shared.end();
}

Eigen::Index LuGreProblem::gravity_column(const LuGreFreedom& free, std::size_t recording) {
  return Layout(free, 0).first_of(recording);
}

Eigen::Index LuGreProblem::rows() const {
  Eigen::Index n = 0;
  for (const LuGreLoopModel& model : models_) n += model.rows();
  return n;
}

LuGreProblem::Solution LuGreProblem::solve(const LuGreFreedom& free, const LuGrePoint& start,
                                           const statistics::LeastSquaresLimits& limits) const {
  const Layout layout(free, models_.size());
  Reduced reduced;
  // The solver asks for derivatives where it has just asked for residuals: they come together.
  const statistics::LeastSquaresProblem problem{
      static_cast<Eigen::Index>(layout.columns().size() + 1) *
          static_cast<Eigen::Index>(models_.size()),
      [&](const Eigen::VectorXd& p, Eigen::VectorXd& r, Eigen::MatrixXd* j) {
        if (reduced.at.size() != p.size() || reduced.at != p) {
          reduce(models_, layout, layout.point_of(p, start), reduced);
          reduced.at = p;
        }
        r = reduced.residuals;
        if (j != nullptr) *j = reduced.jacobian;
      }};
  const statistics::LeastSquaresSolution found =
      statistics::solve_least_squares(problem, layout.vector_of(start), limits);
  return {layout.point_of(found.parameters, start), 2 * found.cost, found.evaluations,
          found.converged};
}

LuGreProblem::Linearisation LuGreProblem::linearise(
    const LuGreFreedom& free, const LuGrePoint& at,
    const std::vector<std::size_t>& block_of_row) const {
  const Layout layout(free, models_.size());
  const std::vector<Eigen::Index> columns = layout.columns();
  Linearisation out;
  out.fit.parameters = layout.vector_of(at);
  out.fit.block_of_row = block_of_row;
  out.fit.residuals.resize(rows());
  out.fit.jacobian.setZero(rows(), layout.size());
  Eigen::VectorXd residuals;
  LuGreLoopModel::Rows derivatives;
  Eigen::Index top = 0;
  for (std::size_t r = 0; r < models_.size(); ++r) {
    models_[r].evaluate(at.shared, at.locals[r], layout.bends(at), residuals, derivatives);
    const Eigen::Index count = residuals.size();
    out.fit.residuals.segment(top, count) = residuals;
    for (Eigen::Index k = 0; k < static_cast<Eigen::Index>(columns.size()); ++k) {
      const Eigen::Index column = k < layout.local() ? layout.first_of(r) + k : k - layout.local();
      out.fit.jacobian.col(column).segment(top, count) =
          derivatives.col(columns[static_cast<std::size_t>(k)]);
    }
    top += count;
  }
  Reduced reduced;
  reduce(models_, layout, at, reduced);
  out.r_factor = statistics::OrthogonalColumns(reduced.jacobian).triangle();
  return out;
}

}  // namespace tribolog::method::hysteresis
