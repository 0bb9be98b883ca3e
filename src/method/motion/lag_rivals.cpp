#include "method/motion/lag_rivals.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "statistics/block_regression.h"
#include "statistics/linear_systems.h"
#include "statistics/rival_fits.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::motion {
namespace {

/// Columns of the regression; behind them the forces, and of an elastic gear one more.
struct RivalColumn {
  enum : Eigen::Index { inertia, viscous, forces };
};

/// A column of samples at an even distance, `samples` later; between them along cubics.
Eigen::VectorXd delayed(const Eigen::Ref<const Eigen::VectorXd>& x, double samples) {
  const Eigen::Index last = x.size() - 1;
  const auto at = [&](Eigen::Index i) { return x(std::clamp<Eigen::Index>(i, 0, last)); };
  Eigen::VectorXd out(x.size());
  const double whole = std::floor(-samples);
  const double s = -samples - whole;
  // Lagrange's weights of the neighbours at -1, 0, 1 and 2.
  const double a = -s * (s - 1) * (s - 2) / 6;
  const double b = (s + 1) * (s - 1) * (s - 2) / 2;
  const double c = -(s + 1) * s * (s - 2) / 2;
  const double d = (s + 1) * s * (s - 1) / 6;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Eigen::Index k = i + static_cast<Eigen::Index>(whole);
    out(i) = a * at(k - 1) + b * at(k) + c * at(k + 1) + d * at(k + 2);
  }
  return out;
}

/// Behind a first-order filter.
Eigen::VectorXd filtered(const Eigen::Ref<const Eigen::VectorXd>& x, double samples) {
  Eigen::VectorXd out = x;
  statistics::low_pass(std::span(out.data(), static_cast<std::size_t>(out.size())), samples);
  return out;
}

class Rivalry {
 public:
  Rivalry(const Transients& transients, const std::vector<double>& knots)
      : transients_(transients) {
    for (const Travel& travel : transients.travels) {
      const joint::Recording& r = *travel.recording;
      const Eigen::Map<const Eigen::VectorXd> angle(r.q_rad.data(),
                                                    static_cast<Eigen::Index>(r.size()));
      const Eigen::Map<const Eigen::VectorXd> torque(r.torque_Nm.data(), angle.size());
      signals_.push_back({angle.array() - angle.mean(), torque, forces_at_samples(travel, knots)});
    }
    for (const TransientRow& row : transients.rows) blocks_.push_back(row.transient);
  }

  /// The rival, and what it leaves at each row.
  struct Fitted {
    LagRival rival;
    Eigen::VectorXd residuals;
    bool converged{};
    double bend_s2{};  ///< What is left of the torque along J d^4 q/dt^4, over J.
  };

  /// Start or stop of each row.
  [[nodiscard]] const std::vector<std::size_t>& blocks() const { return blocks_; }

  [[nodiscard]] Fitted without_lag() const {
    const Regression r = regression(LagShape::delay, 0, false);
    return described(LagShape::delay, statistics::block_regression(r.x, r.y, blocks_));
  }

  [[nodiscard]] Fitted elastic_gear() const {
    const Regression r = regression(LagShape::elastic_gear, 0, true);
    const statistics::BlockRegression fit = statistics::block_regression(r.x, r.y, blocks_);
    const Eigen::Index last = r.x.cols() - 1;
    const double j = fit.coefficients(RivalColumn::inertia);
    const double square_s2 = -fit.coefficients(last) / j;
    Fitted out = described(LagShape::elastic_gear, fit);
    out.converged = square_s2 > 0 && j > 0;
    if (!out.converged) return out;
    out.rival.size_s = std::sqrt(square_s2);
    out.rival.half_width_s = fit.half_width(last) / j / (2 * out.rival.size_s);
    return out;
  }

  /// @param none what is left without a lag: all there is where none is to start from.
  [[nodiscard]] Fitted late(LagShape shape, double size_s, const Fitted& none) const {
    constexpr int most_steps = 15;
    constexpr double last_step_s = 1e-6;
    if (size_s == 0) return none;
    Fitted out;
    for (int k = 0; k < most_steps; ++k) {
      const statistics::BlockRegression fit = about(shape, size_s);
      const Eigen::Index last = fit.coefficients.size() - 1;
      const double step = fit.coefficients(last);
      out = described(shape, fit);
      if (!std::isfinite(step)) return out;
      // A filter far from its solution is no straight line: no step to the other sign.
      size_s = std::clamp(size_s + step, std::min(size_s / 2, size_s * 2),
                          std::max(size_s / 2, size_s * 2));
      if (std::abs(step) > last_step_s) continue;
      out.rival.size_s = size_s;
      out.rival.half_width_s = fit.half_width(last);
      out.converged = out.rival.inertia_kgm2 > 0;
      out.bend_s2 = bend_left_by(shape, size_s);
      return out;
    }
    return out;
  }

 private:
  struct Signals {
    Eigen::VectorXd angle, torque;
    Eigen::MatrixXd forces;
  };
  struct Regression {
    Eigen::MatrixXd x;
    Eigen::VectorXd y;
  };

  [[nodiscard]] Fitted described(LagShape shape, const statistics::BlockRegression& fit) const {
    Fitted out;
    out.rival.shape = shape;
    out.rival.inertia_kgm2 = fit.coefficients(RivalColumn::inertia);
    out.rival.inertia_half_width = fit.half_width(RivalColumn::inertia);
    out.rival.residual_Nm =
        std::sqrt(fit.residuals.squaredNorm() / static_cast<double>(fit.residuals.size()));
    out.residuals = fit.residuals;
    return out;
  }

  [[nodiscard]] double bend_left_by(LagShape shape, double size_s) const {
    const Regression r = regression(shape, size_s, true);
    const statistics::BlockRegression fit = statistics::block_regression(r.x, r.y, blocks_);
    return fit.coefficients(r.x.cols() - 1) / fit.coefficients(RivalColumn::inertia);
  }

  /// Linearised about a size: the last coefficient is the next step.
  [[nodiscard]] statistics::BlockRegression about(LagShape shape, double size_s) const {
    Regression here = regression(shape, size_s, false);
    const double nearby = 0.01 * std::abs(size_s);
    const Regression less = regression(shape, size_s - nearby, false);
    const Regression more = regression(shape, size_s + nearby, false);
    const Eigen::VectorXd norms =
        here.x.colwise().norm().transpose().unaryExpr([](double n) { return n > 0 ? n : 1.0; });
    const statistics::OrthogonalColumns solved(here.x * norms.cwiseInverse().asDiagonal());
    const Eigen::VectorXd coefficients = solved.solve(here.y).col(0).cwiseQuotient(norms);
    here.x.conservativeResize(Eigen::NoChange, here.x.cols() + 1);
    here.x.rightCols<1>() = ((more.x - less.x) * coefficients - (more.y - less.y)) / (2 * nearby);
    return statistics::block_regression(here.x, here.y, blocks_);
  }

  /// Of torque on motion, the one or the other late by `size_s`.
  /// @param bends whether the last column is the acceleration's second derivative.
  [[nodiscard]] Regression regression(LagShape shape, double size_s, bool bends) const {
    const Eigen::Index columns = signals_.front().forces.cols();
    Regression out;
    out.x.resize(static_cast<Eigen::Index>(transients_.rows.size()),
                 RivalColumn::forces + columns + (bends ? 1 : 0));
    out.y.resize(out.x.rows());
    Signals shifted;
    for (std::size_t i = 0; i < transients_.rows.size(); ++i) {
      const TransientRow& row = transients_.rows[i];
      if (i == 0 || row.travel != transients_.rows[i - 1].travel) {
        shifted = late_by(row.travel, shape, size_s);
      }
      const Travel& travel = transients_.travels[row.travel];
      const Eigen::MatrixXd& weights = travel.smoothed.weights();
      const auto first = static_cast<Eigen::Index>(row.index - travel.half);
      const Eigen::VectorXd motion =
          weights * (shifted.angle.segment(first, weights.cols()).array() -
                     shifted.angle(static_cast<Eigen::Index>(row.index)))
                        .matrix();
      const auto k = static_cast<Eigen::Index>(i);
      out.x(k, RivalColumn::inertia) = motion(2);
      out.x(k, RivalColumn::viscous) = motion(1);
      out.x.row(k).segment(RivalColumn::forces, columns) =
          weights.row(0) * shifted.forces.middleRows(first, weights.cols());
      if (bends) out.x(k, RivalColumn::forces + columns) = motion(4);
      out.y(k) = weights.row(0).dot(shifted.torque.segment(first, weights.cols()));
    }
    return out;
  }

  [[nodiscard]] Signals late_by(std::size_t travel, LagShape shape, double size_s) const {
    Signals out = signals_[travel];
    if (shape == LagShape::elastic_gear || size_s == 0) return out;
    const double samples = std::abs(size_s) / transients_.travels[travel].dt_s;
    const auto make_late = [&](auto&& column) {
      const Eigen::VectorXd late =
          shape == LagShape::delay ? delayed(column, samples) : filtered(column, samples);
      column = late;
    };
    if (size_s > 0) {
      make_late(out.angle);
      for (Eigen::Index k = 0; k < out.forces.cols(); ++k) make_late(out.forces.col(k));
    } else {
      make_late(out.torque);
    }
    return out;
  }

  const Transients& transients_;
  std::vector<Signals> signals_;
  std::vector<std::size_t> blocks_;
};

/// Over starts alone, or over stops alone; where there are none, nothing speaks against it.
bool leaves_less_in(const Transients& transients, bool starts, const Rivalry::Fitted& a,
                    const Rivalry::Fitted& b) {
  double gain = 0;
  bool any = false;
  for (std::size_t i = 0; i < transients.rows.size(); ++i) {
    const TransientRow& row = transients.rows[i];
    if ((row.speed * row.acceleration > 0) != starts) continue;
    const auto k = static_cast<Eigen::Index>(i);
    gain += b.residuals(k) * b.residuals(k) - a.residuals(k) * a.residuals(k);
    any = true;
  }
  return !any || gain > 0;
}

}  // namespace

std::string to_string(LagShape shape) {
  switch (shape) {
    case LagShape::delay:
      return "delay";
    case LagShape::filter:
      return "filter";
    case LagShape::elastic_gear:
      return "elastic_gear";
  }
  return "";
}

LagCompetition let_rivals_compete(const Transients& transients, const std::vector<double>& knots,
                                  double lag_s) {
  const Rivalry rivalry(transients, knots);
  const Rivalry::Fitted none = rivalry.without_lag();
  const std::vector<Rivalry::Fitted> all{rivalry.late(LagShape::delay, lag_s, none),
                                         rivalry.late(LagShape::filter, lag_s, none),
                                         rivalry.elastic_gear()};
  constexpr double least_gain = 0.02;  // no model is closer to starts and stops
  // At a start the bristle bends over first, which looks like a filter; at a stop it does not.
  const auto beats = [&](const Rivalry::Fitted& a, const Rivalry::Fitted& b) {
    return statistics::leaves_less(a.residuals, b.residuals, rivalry.blocks(), least_gain) &&
           leaves_less_in(transients, true, a, b) && leaves_less_in(transients, false, a, b);
  };
  // A delay and a filter of size d differ by d^2/2 J d^4 q/dt^4. What else bends starts and stops,
  // such as the bristle, does so in all of them alike: it must be less than what tells the two.
  constexpr double most_of_difference = 0.3;
  // Over few samples, what sampling and smoothing do to a start looks like a filter, or like a gear
  // that gives way.
  constexpr double fewest_samples = 3;
  double interval_s = 0;
  for (const Travel& travel : transients.travels) interval_s = std::max(interval_s, travel.dt_s);
  const auto is_told_by_shape = [&](const Rivalry::Fitted& one) {
    const LagRival& rival = one.rival;
    const bool is_short = std::abs(rival.size_s) < fewest_samples * interval_s;
    if (rival.shape == LagShape::elastic_gear) return !is_short;
    if (rival.shape == LagShape::filter && is_short) return false;
    return std::abs(one.bend_s2) < most_of_difference * rival.size_s * rival.size_s / 2;
  };
  LagCompetition out;
  for (const Rivalry::Fitted& one : all) {
    if (!one.converged) continue;
    out.rivals.push_back(one.rival);
    const bool wins = is_told_by_shape(one) && beats(one, none) &&
                      std::all_of(all.begin(), all.end(), [&](const Rivalry::Fitted& other) {
                        return &other == &one || beats(one, other);
                      });
    if (wins) out.winner = one.rival.shape;
  }
  return out;
}

}  // namespace tribolog::method::motion
