#include "method/motion/lag_rivals.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
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

/// Behind a mean that lags by so much.
Eigen::VectorXd averaged(const Eigen::Ref<const Eigen::VectorXd>& x, double samples) {
  Eigen::VectorXd out = x;
  statistics::moving_mean(std::span(out.data(), static_cast<std::size_t>(out.size())), 2 * samples);
  return out;
}

/// After so many lags a filter holds little of what the torque was before.
constexpr std::size_t lags_to_forget = 4;

class Rivalry {
 public:
  /// @param lag_s about as large as the rivals'.
  Rivalry(const Transients& transients, const std::vector<double>& knots, double lag_s)
      : transients_(transients) {
    std::vector<Signals> signals;
    for (const Travel& travel : transients.travels) {
      const joint::Recording& r = *travel.recording;
      const Eigen::Map<const Eigen::VectorXd> angle(r.q_rad.data(),
                                                    static_cast<Eigen::Index>(r.size()));
      const Eigen::Map<const Eigen::VectorXd> torque(r.torque_Nm.data(), angle.size());
      signals.push_back({angle.array() - angle.mean(), torque, forces_at_samples(travel, knots)});
    }
    signals_ = std::make_shared<const std::vector<Signals>>(std::move(signals));
    look_behind(lag_s);
  }

  /// Takes the rows that a lag of about this size leaves.
  void look_behind(double lag_s) {
    lag_s_ = lag_s;
    take_rows_moved_for(lags_to_forget);
    if (rows_.size() < fewest_rows) take_rows_moved_for(0);  // starts are shorter than that
  }

  /// The rival, and what it leaves at each row.
  struct Fitted {
    LagRival rival;
    Eigen::VectorXd residuals;
    bool converged{};
    double bend_s2{};  ///< What is left of the torque along J d^4 q/dt^4, over J.
  };

  /// Fewer show no lag.
  static constexpr std::size_t fewest_rows = 50;
  [[nodiscard]] const std::vector<TransientRow>& rows() const { return rows_; }
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

  /// By how many samples the torque of a row is late: where the motion is made late as well, a row
  /// is looked at then, so that it is still of the moving joint.
  [[nodiscard]] std::size_t samples_late(const Travel& travel) const {
    return lag_s_ > 0 ? static_cast<std::size_t>(std::lround(lag_s_ / travel.dt_s)) : 0;
  }

  /// Those whose torque was recorded, and whose joint has moved for so many lags.
  void take_rows_moved_for(std::size_t lags) {
    rows_.clear();
    blocks_.clear();
    for (const TransientRow& row : transients_.get().rows) {
      const Travel& travel = transients_.get().travels[row.travel];
      const std::size_t late = samples_late(travel);
      if (row.index + late + travel.half >= travel.recording->size()) continue;
      if (lags > 0 && !has_moved_for(lags * late + travel.half, travel, row)) continue;
      rows_.push_back(row);
      blocks_.push_back(row.transient);
    }
  }

  /// What a torque that is late holds of the contact before it slides is no friction of a speed.
  static bool has_moved_for(std::size_t samples, const Travel& travel, const TransientRow& row) {
    constexpr double least_share = 0.05;
    if (row.index < samples) return false;
    const double before = travel.speed[row.index - samples];
    return before * row.speed > 0 && std::abs(before) > least_share * std::abs(row.speed);
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
    const Eigen::Index columns = signals_->front().forces.cols();
    Regression out;
    out.x.resize(static_cast<Eigen::Index>(rows_.size()),
                 RivalColumn::forces + columns + (bends ? 1 : 0));
    out.y.resize(out.x.rows());
    Signals shifted;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const TransientRow& row = rows_[i];
      if (i == 0 || row.travel != rows_[i - 1].travel) {
        shifted = late_by(row.travel, shape, size_s);
      }
      const Travel& travel = transients_.get().travels[row.travel];
      const Eigen::MatrixXd& weights = travel.smoothed.weights();
      const std::size_t at =
          row.index + (makes_motion_late(shape, size_s) ? samples_late(travel) : 0);
      const auto first = static_cast<Eigen::Index>(at - travel.half);
      const Eigen::VectorXd motion =
          weights * (shifted.angle.segment(first, weights.cols()).array() -
                     shifted.angle(static_cast<Eigen::Index>(at)))
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

  static bool makes_motion_late(LagShape shape, double size_s) {
    return shape != LagShape::elastic_gear && size_s > 0;
  }

  [[nodiscard]] Signals late_by(std::size_t travel, LagShape shape, double size_s) const {
    Signals out = (*signals_)[travel];
    if (shape == LagShape::elastic_gear || size_s == 0) return out;
    const double samples = std::abs(size_s) / transients_.get().travels[travel].dt_s;
    const auto make_late = [&](auto&& column) {
      const Eigen::VectorXd late = shape == LagShape::delay    ? delayed(column, samples)
                                   : shape == LagShape::filter ? filtered(column, samples)
                                                               : averaged(column, samples);
      column = late;
    };
    if (makes_motion_late(shape, size_s)) {
      make_late(out.angle);
      for (Eigen::Index k = 0; k < out.forces.cols(); ++k) make_late(out.forces.col(k));
    } else {
      make_late(out.torque);
    }
    return out;
  }

  std::reference_wrapper<const Transients> transients_;
  double lag_s_{};
  std::vector<TransientRow> rows_;
  std::shared_ptr<const std::vector<Signals>> signals_;  // the same behind any lag
  std::vector<std::size_t> blocks_;
};

/// Over starts alone, or over stops alone; where there are none, nothing speaks against it.
bool leaves_less_in(const std::vector<TransientRow>& rows, bool starts, const Rivalry::Fitted& a,
                    const Rivalry::Fitted& b) {
  double gain = 0;
  bool any = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TransientRow& row = rows[i];
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
    case LagShape::moving_mean:
      return "moving_mean";
    case LagShape::elastic_gear:
      return "elastic_gear";
  }
  return "";
}

namespace {

/// Fitted rivals, and which of them tells itself from the others.
class Contest {
 public:
  Contest(const Transients& transients, const std::vector<double>& knots, double lag_s)
      : lag_s_(lag_s), rivalry_(transients, knots, lag_s) {
    if (rivalry_.rows().size() < Rivalry::fewest_rows) return;
    fit();
    // What a late torque holds of the time before the joint slid is left out: how much that is, the
    // rivals tell better than the lag that they start from.
    constexpr double much_longer = 1.1;
    constexpr int most_times = 3;
    for (int k = 0; k < most_times; ++k) {
      const Rivalry::Fitted* closest = closest_late();
      if (closest == nullptr || !(closest->rival.size_s > much_longer * std::abs(lag_s_))) break;
      Contest longer(*this);
      longer.lag_s_ = closest->rival.size_s;
      longer.rivalry_.look_behind(longer.lag_s_);
      if (longer.rivalry_.rows().size() < Rivalry::fewest_rows) break;
      longer.fit();
      const Rivalry::Fitted* then = longer.closest_late();
      if (then == nullptr || then->rival.residual_Nm > closest->rival.residual_Nm) break;
      *this = std::move(longer);
    }
    for (const Travel& travel : transients.travels) {
      interval_s_ = std::max(interval_s_, travel.dt_s);
    }
  }

  [[nodiscard]] const std::vector<Rivalry::Fitted>& all() const { return all_; }

  [[nodiscard]] bool wins(const Rivalry::Fitted& one) const {
    return is_told_by_shape(one) && leaves_less(one, none_) &&
           std::all_of(all_.begin(), all_.end(), [&](const Rivalry::Fitted& other) {
             return &other == &one || beats(one, other);
           });
  }
  [[nodiscard]] bool is_beaten(const Rivalry::Fitted& one) const {
    return std::any_of(all_.begin(), all_.end(), [&](const Rivalry::Fitted& other) {
      return &other != &one && other.converged && beats(other, one);
    });
  }

 private:
  /// Of those that make one channel late, the one that leaves least; nullptr: none is found.
  [[nodiscard]] const Rivalry::Fitted* closest_late() const {
    const Rivalry::Fitted* closest = nullptr;
    for (const Rivalry::Fitted& one : all_) {
      if (!one.converged || one.rival.shape == LagShape::elastic_gear) continue;
      if (closest == nullptr || one.rival.residual_Nm < closest->rival.residual_Nm) closest = &one;
    }
    return closest;
  }

  void fit() {
    none_ = rivalry_.without_lag();
    all_ = {rivalry_.late(LagShape::delay, lag_s_, none_),
            rivalry_.late(LagShape::filter, lag_s_, none_), rivalry_.elastic_gear()};
    // A late angle is matched by a torque made late: a mean would take noise off that, and win.
    if (lag_s_ > 0) all_.push_back(rivalry_.late(LagShape::moving_mean, lag_s_, none_));
  }

  /// At a start the bristle bends over first, which looks like a filter; at a stop it does not.
  [[nodiscard]] bool leaves_less(const Rivalry::Fitted& a, const Rivalry::Fitted& b) const {
    constexpr double least_gain = 0.02;  // no model is closer to starts and stops
    return statistics::leaves_less(a.residuals, b.residuals, rivalry_.blocks(), least_gain) &&
           leaves_less_in(rivalry_.rows(), true, a, b) &&
           leaves_less_in(rivalry_.rows(), false, a, b);
  }
  /// A mean takes noise off the angle as well, and may leave less than a delay for that alone: of
  /// these two, what is left along the difference tells.
  [[nodiscard]] bool beats(const Rivalry::Fitted& a, const Rivalry::Fitted& b) const {
    if (leaves_less(a, b)) return true;
    return a.rival.shape == LagShape::delay && b.rival.shape == LagShape::moving_mean &&
           leaves_little_of(of_delay_and_mean, a) && !leaves_little_of(of_delay_and_mean, b);
  }

  // A delay and a filter of size d differ by d^2/2 J d^4 q/dt^4, a delay and a mean by a third of
  // that. What else bends starts and stops, such as the bristle, does so in all of them alike: it
  // must be less than what tells them.
  static constexpr double of_delay_and_filter = 1.0 / 2;
  static constexpr double of_delay_and_mean = 1.0 / 6;
  static bool leaves_little_of(double difference, const Rivalry::Fitted& one) {
    constexpr double most = 0.3;
    const double size_s = one.rival.size_s;
    return one.converged && std::abs(one.bend_s2) < most * difference * size_s * size_s;
  }

  /// Over few samples, what sampling and smoothing do to a start looks like a filter, or like a
  /// gear that gives way.
  [[nodiscard]] bool is_told_by_shape(const Rivalry::Fitted& one) const {
    constexpr double fewest_samples = 3;
    const bool is_short =
        std::abs(one.rival.size_s) < fewest_samples * interval_s_ && !stands_out(one);
    switch (one.rival.shape) {
      case LagShape::elastic_gear:
        return !is_short;
      case LagShape::moving_mean:
        return !is_short && leaves_little_of(of_delay_and_mean, one);
      case LagShape::filter:
        return !is_short && leaves_little_of(of_delay_and_filter, one);
      case LagShape::delay:
        return leaves_little_of(of_delay_and_filter, one);
    }
    return false;
  }

  /// Leaves so much less than all others that no small effect can have brought it there.
  [[nodiscard]] bool stands_out(const Rivalry::Fitted& one) const {
    constexpr double share = 0.5;
    return std::all_of(all_.begin(), all_.end(), [&](const Rivalry::Fitted& other) {
      return &other == &one || one.rival.residual_Nm < share * other.rival.residual_Nm;
    });
  }

  double lag_s_;
  double interval_s_{};
  Rivalry rivalry_;
  Rivalry::Fitted none_;
  std::vector<Rivalry::Fitted> all_;
};

/// @param lag_s of what no rival stands for.
double rounds_as_filter_s(const LagRival& rival, double lag_s) {
  switch (rival.shape) {
    case LagShape::delay:
      return 0;
    case LagShape::moving_mean:
      return std::abs(rival.size_s) / std::sqrt(3.0);
    case LagShape::filter:
      return std::abs(rival.size_s);
    case LagShape::elastic_gear:
      break;
  }
  return std::abs(lag_s);
}

}  // namespace

LagCompetition let_rivals_compete(const Transients& transients, const std::vector<double>& knots,
                                  double lag_s) {
  const Contest contest(transients, knots, lag_s);
  LagCompetition out;
  bool any_is_left = false;
  for (const Rivalry::Fitted& one : contest.all()) {
    if (!one.converged) continue;
    out.rivals.push_back(one.rival);
    if (contest.wins(one)) out.winner = one.rival.shape;
    if (contest.is_beaten(one)) continue;
    any_is_left = true;
    out.rounds_as_filter_s = std::max(out.rounds_as_filter_s, rounds_as_filter_s(one.rival, lag_s));
  }
  if (!any_is_left) out.rounds_as_filter_s = std::abs(lag_s);
  for (const LagRival& rival : out.rivals) {
    if (out.winner == rival.shape) out.rounds_as_filter_s = rounds_as_filter_s(rival, lag_s);
  }
  return out;
}

}  // namespace tribolog::method::motion
