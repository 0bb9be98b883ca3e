#include "method/hysteresis/loop_effects.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "method/hysteresis/loop_timing.h"
#include "method/hysteresis/position_mean.h"
#include "statistics/distributions.h"
#include "statistics/evidence.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::hysteresis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
namespace effect = joint::effect;

/// Loops beyond which each has no effects of its own.
constexpr std::size_t most_loops = 30;
constexpr Index hats = 7;

/// Friction and the whole torque by LuGre at a loop's rows.
struct ByLuGre {
  VectorXd friction_Nm;
  VectorXd torque_Nm;
};

ByLuGre by_lugre(const LuGreLoopModel& model, const LuGreShared::Vector& shared,
                 const LuGreLocal& local) {
  VectorXd residuals;
  LuGreLoopModel::Rows derivatives;
  model.evaluate(shared, local, shared(LuGreShared::fall) != 0, residuals, derivatives);
  ByLuGre out;
  out.torque_Nm = residuals + model.measured();
  out.friction_Nm = out.torque_Nm - local.gravity_Nm * derivatives.col(0) -
                    shared(LuGreShared::inertia) *
                        derivatives.col(LuGreLoopModel::local_count + LuGreShared::inertia);
  return out;
}

/// Motor angles about which loops stand, numbered.
std::vector<Index> positions_of(const std::vector<LuGreLoopModel>& models) {
  std::vector<double> middles;
  for (const LuGreLoopModel& model : models) middles.push_back(model.middle_rad());
  const std::vector<std::size_t> numbers = position_numbers(middles);
  return {numbers.begin(), numbers.end()};
}

VectorXd slope_over_time(const std::vector<double>& t_s, const VectorXd& x) {
  VectorXd out(x.size());
  for (Index i = 0; i < x.size(); ++i) {
    const Index a = std::max<Index>(0, i - 1);
    const Index b = std::min(x.size() - 1, i + 1);
    const double span = t_s[static_cast<std::size_t>(b)] - t_s[static_cast<std::size_t>(a)];
    out(i) = span > 0 ? (x(b) - x(a)) / span : 0;
  }
  return out;
}

/// Columns over the way since the last reversal, in deflections at which LuGre slides, with the
/// sign of the direction; nothing before the first one.
MatrixXd hats_over_way(const LuGreLoopModel& model, double deflection_rad) {
  constexpr double widest = 8;     // deflections, of the last hat's middle
  constexpr double finest = 0.35;  // of the first hats' distance
  const double span = std::log1p(widest / finest);
  const double step = span / static_cast<double>(hats - 1);
  const std::vector<double> times = model.row_times_s();
  const simulate::Motion& motion = model.motion();
  MatrixXd columns = MatrixXd::Zero(model.rows(), hats);
  bool has_turned = false;
  double turned_at_rad = 0;
  for (Index i = 1; i < model.rows(); ++i) {
    const double from_s = times[static_cast<std::size_t>(i) - 1];
    const double to_s = times[static_cast<std::size_t>(i)];
    const double before = motion.speed(from_s);
    const double after = motion.speed(to_s);
    if (before * after < 0) {
      has_turned = true;
      turned_at_rad = motion.angle(from_s + (to_s - from_s) * before / (before - after));
    }
    if (!has_turned) continue;
    const double ways = std::abs(motion.angle(to_s) - turned_at_rad) / deflection_rad;
    const double at = std::log1p(ways / finest) / step;
    const double direction = after < 0 ? -1 : 1;
    for (Index k = 0; k < hats; ++k) {
      const double off = (at - static_cast<double>(k)) / 0.8;
      columns(i, k) = direction * std::exp(-0.5 * off * off);
    }
  }
  return columns;
}

/// Of a ripple along a way of the motor, what is not taken off with the phase of the sweep, to each
/// side, standard deviation.
double left_of_ripple_Nm(const gravity::Ripple& ripple, double amplitude_rad) {
  if (ripple.lines.empty()) return 0;
  constexpr double left = 0.3;
  std::vector<double> heights;
  for (const gravity::RippleLine& line : ripple.lines) {
    const double phase = std::min(line.periods_per_turn * amplitude_rad, std::numbers::pi / 2);
    heights.push_back(line.amplitude_Nm * std::sin(phase));
  }
  return left * gravity::random_phase_half_width(heights, 0) / statistics::normal_975;
}

/// As how many rows of a loop one independent row counts.
double correlation_of(const VectorXd& residuals) {
  const Index most = std::min<Index>(400, residuals.size() / 4);
  return statistics::integrated_autocorrelation(residuals, most, 1,
                                                [](Index, Index) { return true; });
}

}  // namespace

LoopEffects::LoopEffects(const LuGreProblem& problem, const LuGreClimb& climb,
                         const gravity::Ripple& ripple, KnownEffects known)
    : known_(std::move(known)), point_(climb.point) {
  put_up(problem, climb, ripple);
  if (!all_.empty()) solve(problem, climb);
  add_lag(problem, climb);
}

void LoopEffects::add(const joint::Effect& effect, double scale, Each each, Index width,
                      bool is_along) {
  if (!(scale > 0)) return;
  constexpr double open = 0.01;
  const Index times = each == Each::loop ? static_cast<Index>(position_.size())
                      : each == Each::position
                          ? *std::max_element(position_.begin(), position_.end()) + 1
                          : 1;
  all_.push_back({&effect, scale, each, is_along, coefficients_, width, width * times,
                  std::max(open, effect.least_precision())});
  coefficients_ += all_.back().count;
}

void LoopEffects::put_up(const LuGreProblem& problem, const LuGreClimb& climb,
                         const gravity::Ripple& ripple) {
  const auto share = [&](const joint::Effect& of) { return 0.01 * known_.sizes.of(of); };
  double top = 0;
  double amplitude = 0;
  for (const LuGreLoopModel& model : problem.models()) {
    top = std::max(top, model.measured().cwiseAbs().maxCoeff());
    amplitude = std::max(amplitude, model.motor_amplitude_rad());
  }
  position_ = positions_of(problem.models());
  if (problem.models().size() <= most_loops) {
    const double friction = std::hypot(share(effect::motor_turn), known_.friction_share);
    add(effect::motor_turn, friction, Each::position);
    add(effect::motor_turn, friction, Each::loop, 1, true);
    add(effect::friction_of_recording, share(effect::friction_of_recording), Each::loop);
    add(effect::smooth_over_angle,
        std::hypot(share(effect::smooth_over_angle) * top, left_of_ripple_Nm(ripple, amplitude)),
        Each::loop);
  }
  add(effect::asymmetry, share(effect::asymmetry), Each::all);
  add(effect::load, share(effect::load), Each::all);
  if (climb.rung == LuGreRung::elastic) return;  // nothing slides
  add(effect::contact_misfit,
      share(effect::contact_misfit) * std::exp(point_.shared(LuGreShared::log_static)), Each::all,
      hats);
}

MatrixXd LoopEffects::columns_of(const LuGreLoopModel& model, std::size_t loop) const {
  const std::vector<double> times = model.row_times_s();
  const ByLuGre torque = by_lugre(model, point_.shared, point_.locals[loop]);
  VectorXd angle(model.rows());
  for (Index i = 0; i < model.rows(); ++i) {
    angle(i) = model.motion().angle(times[static_cast<std::size_t>(i)]);
  }
  const double half = std::max(model.motor_amplitude_rad(), 1e-12);
  const VectorXd x = (angle.array() - model.middle_rad()) / half;
  // Along a small part of the motor's turn its friction hardly changes.
  const double of_turn = std::min(1.0, half);
  Index wide = 0;
  for (const OfEffect& one : all_) wide += one.width;
  MatrixXd columns(model.rows(), wide);
  Index at = 0;
  for (const OfEffect& one : all_) {
    if (one.effect == &effect::motor_turn || one.effect == &effect::friction_of_recording) {
      columns.col(at) = torque.friction_Nm;
      if (one.is_along) columns.col(at) = of_turn * torque.friction_Nm.cwiseProduct(x);
    } else if (one.effect == &effect::load) {
      const double gravity_Nm = std::abs(point_.locals[loop].gravity_Nm);
      columns.col(at) = gravity_Nm * model.row_speeds_rad_s().cwiseSign();
    } else if (one.effect == &effect::smooth_over_angle) {
      columns.col(at) = x;
    } else if (one.effect == &effect::asymmetry) {
      columns.col(at) = torque.friction_Nm.cwiseAbs();
    } else {
      columns.middleCols(at, hats) =
          hats_over_way(model, LuGreShared::largest_deflection_rad(point_.shared));
    }
    at += one.width;
  }
  columns.topRows(model.rows_left_out()).setZero();
  return columns;
}

std::vector<Index> LoopEffects::places_of(std::size_t loop) const {
  std::vector<Index> places;
  for (const OfEffect& one : all_) {
    const Index number = one.each == Each::loop       ? static_cast<Index>(loop)
                         : one.each == Each::position ? position_[loop]
                                                      : 0;
    for (Index k = 0; k < one.width; ++k) places.push_back(one.first + one.width * number + k);
  }
  return places;
}

/// Each loop's rows: the fit's own columns, the effects', and what the fit leaves; and the products
/// of all with one another.
struct LoopEffects::Stack {
  std::vector<MatrixXd> rows;
  std::vector<std::vector<Index>> places;  ///< Of a loop's columns in the products.
  std::vector<Index> left_out;             ///< Rows at a loop's beginning.
  MatrixXd products;
  Index fitted{};  ///< Columns of the fit.
  double count{};  ///< Rows compared.

  [[nodiscard]] VectorXd right() const { return products.col(size()).head(size()); }
  [[nodiscard]] double squares() const { return products(size(), size()); }
  [[nodiscard]] Index size() const { return products.rows() - 1; }
  [[nodiscard]] VectorXd residuals(std::size_t loop, const VectorXd& found) const {
    const MatrixXd& all = rows[loop];
    const std::vector<Index> columns(places[loop].begin(), places[loop].end() - 1);
    const VectorXd left = all.rightCols(1) - all.leftCols(all.cols() - 1) * found(columns);
    return left.tail(left.size() - left_out[loop]);
  }
};

LoopEffects::Stack LoopEffects::stacked(const LuGreProblem& problem,
                                        const LuGreClimb& climb) const {
  const statistics::LinearisedFit& fit = climb.linear.fit;
  const auto shared = static_cast<Index>(climb.free.shared.size());
  const Index local = climb.free.starts ? 2 : 1;
  Stack out;
  out.fitted = fit.jacobian.cols();
  const Index all_columns = out.fitted + coefficients_ + 1;
  out.products = MatrixXd::Zero(all_columns, all_columns);
  Index top = 0;
  for (std::size_t r = 0; r < problem.models().size(); ++r) {
    const LuGreLoopModel& model = problem.models()[r];
    const MatrixXd columns = columns_of(model, r);
    const Index first = LuGreProblem::gravity_column(climb.free, r);
    MatrixXd all(model.rows(), shared + local + columns.cols() + 1);
    all << fit.jacobian.block(top, 0, model.rows(), shared),
        fit.jacobian.block(top, first, model.rows(), local), columns,
        -fit.residuals.segment(top, model.rows());
    std::vector<Index> places;
    for (Index k = 0; k < shared; ++k) places.push_back(k);
    for (Index k = 0; k < local; ++k) places.push_back(first + k);
    for (const Index k : places_of(r)) places.push_back(out.fitted + k);
    places.push_back(all_columns - 1);
    out.products(places, places) += all.transpose() * all;
    out.count += static_cast<double>(model.rows() - model.rows_left_out());
    out.left_out.push_back(model.rows_left_out());
    top += model.rows();
    out.rows.push_back(std::move(all));
    out.places.push_back(std::move(places));
  }
  return out;
}

void LoopEffects::improve_sizes(const VectorXd& mean, const VectorXd& variance) {
  for (OfEffect& one : all_) {
    one.precision = statistics::next_precision(
        mean.segment(one.first, one.count), variance.segment(one.first, one.count),
        VectorXd::Constant(one.count, one.scale), one.precision, one.effect->dof,
        one.effect->least_precision());
  }
}

void LoopEffects::solve(const LuGreProblem& problem, const LuGreClimb& climb) {
  const Stack stack = stacked(problem, climb);
  const Index p = stack.fitted;
  const Index n = stack.size();
  // Columns of length 1: their torques differ by orders of magnitude.
  const VectorXd scale = stack.products.diagonal().head(n).unaryExpr(
      [](double square) { return square > 0 ? 1 / std::sqrt(square) : 1.0; });
  const MatrixXd scaled =
      scale.asDiagonal() * stack.products.topLeftCorner(n, n) * scale.asDiagonal();
  const VectorXd right = scale.asDiagonal() * stack.right();
  double variance = stack.squares() / stack.count;
  double correlated = 1;  // rows that say as much as one
  constexpr int rounds = 12;
  for (int round = 0; round < rounds; ++round) {
    MatrixXd precision = scaled / (variance * correlated);
    precision.diagonal().array() += 1e-12 * precision.diagonal().maxCoeff();
    for (const OfEffect& one : all_) {
      precision.diagonal().segment(p + one.first, one.count).array() +=
          one.precision / (one.scale * one.scale) *
          scale.segment(p + one.first, one.count).array().square();
    }
    const MatrixXd covariance =
        statistics::solve_normal(precision, MatrixXd::Identity(n, n));  // of scaled coefficients
    const VectorXd found = covariance * right / (variance * correlated);
    const double left = stack.squares() - 2 * found.dot(right) + found.dot(scaled * found);
    variance = std::max(left, 1e-12 * stack.squares()) / stack.count;
    const auto of_effects = scale.tail(coefficients_).asDiagonal();
    mean_ = of_effects * found.tail(coefficients_);
    covariance_ =
        of_effects * covariance.bottomRightCorner(coefficients_, coefficients_) * of_effects;
    improve_sizes(mean_, covariance_.diagonal());
    if (round != rounds / 2) continue;
    const VectorXd plain = scale.asDiagonal() * found;
    double total = 0;
    for (std::size_t r = 0; r < stack.rows.size(); ++r) {
      const VectorXd residuals = stack.residuals(r, plain);
      total += correlation_of(residuals) * static_cast<double>(residuals.size()) / stack.count;
    }
    correlated = total;
  }
  by_effects_ = -(scale.head(p).asDiagonal() *
                  statistics::solve_normal(
                      scaled.topLeftCorner(p, p),
                      scale.head(p).asDiagonal() * stack.products.block(0, p, p, coefficients_)));
  const statistics::EigenSystem eigen = statistics::eigen_system(covariance_);
  shifts_ = by_effects_ * eigen.vectors * eigen.values.cwiseMax(0.0).cwiseSqrt().asDiagonal();
  if (asks_contact()) note_misfits(stack);
}

void LoopEffects::note_misfits(const Stack& stack) {
  for (std::size_t r = 0; r < stack.rows.size(); ++r) {
    const MatrixXd& all = stack.rows[r];
    const VectorXd contact = all.middleCols(all.cols() - 1 - hats, hats) * mean_.tail(hats);
    misfit_Nm_.push_back(contact.norm() / std::sqrt(static_cast<double>(contact.size())));
  }
}

void LoopEffects::add_lag(const LuGreProblem& problem, const LuGreClimb& climb) {
  const LoopTiming& timing = known_.timing;
  // A filter's lag is the less the faster the torque changes.
  constexpr double of_a_filter = 0.5;
  const double lag_s =
      std::hypot(timing.half_width_s, of_a_filter * timing.lag_s) / statistics::normal_975;
  if (!(lag_s > 0)) return;
  MatrixXd late = MatrixXd::Zero(problem.rows(), 2);
  Index top = 0;
  for (std::size_t r = 0; r < problem.models().size(); ++r) {
    const LuGreLoopModel& model = problem.models()[r];
    const std::vector<double> times = model.row_times_s();
    const VectorXd torque = by_lugre(model, point_.shared, point_.locals[r]).torque_Nm;
    late.col(0).segment(top, model.rows()) = lag_s * slope_over_time(times, torque);
    if (timing.lag_s > 0) {
      late.col(1).segment(top, model.rows()) =
          (rounded_by_filter(times, torque, timing.lag_s) - torque) / statistics::normal_975;
    }
    top += model.rows();
  }
  by_lag_ = statistics::least_squares(climb.linear.fit.jacobian, late);
  shifts_.conservativeResize(by_lag_.rows(), shifts_.cols() + by_lag_.cols());
  shifts_.rightCols(by_lag_.cols()) = by_lag_;
}

LuGreProblem LoopEffects::taken_off(const LuGreProblem& problem, bool with_contact) const {
  std::vector<LuGreLoopModel> models = problem.models();
  for (std::size_t r = 0; r < models.size() && !all_.empty(); ++r) {
    VectorXd coefficients = mean_(places_of(r));
    if (!with_contact && asks_contact()) coefficients.tail(hats).setZero();
    models[r].take_off(columns_of(models[r], r) * coefficients);
  }
  return LuGreProblem(std::move(models));
}

bool LoopEffects::asks_contact() const {
  return !all_.empty() && all_.back().effect == &effect::contact_misfit;
}

VectorXd LoopEffects::contact_Nm(const LuGreProblem& problem) const {
  VectorXd all = VectorXd::Zero(problem.rows());
  Index top = 0;
  for (std::size_t r = 0; r < problem.models().size() && asks_contact(); ++r) {
    const LuGreLoopModel& model = problem.models()[r];
    const Index compared = model.rows() - model.rows_left_out();
    all.segment(top + model.rows_left_out(), compared) =
        hats_over_way(model, LuGreShared::largest_deflection_rad(point_.shared))
            .bottomRows(compared) *
        mean_.tail(hats);
    top += model.rows();
  }
  return all;
}

std::vector<EffectShare> LoopEffects::shares(const VectorXd& gradient, double variance) const {
  std::vector<EffectShare> all;
  if (!(variance > 0)) return all;
  for (const OfEffect& one : all_) {
    const VectorXd to = by_effects_.middleCols(one.first, one.count).transpose() * gradient;
    const double part = to.dot(covariance_.block(one.first, one.first, one.count, one.count) * to);
    all.push_back({one.effect->key, part / variance});
  }
  if (by_lag_.cols() > 0) {
    all.push_back({effect::lag.key, (by_lag_.transpose() * gradient).squaredNorm() / variance});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const EffectShare& a, const EffectShare& b) { return a.share > b.share; });
  return all;
}

}  // namespace tribolog::method::hysteresis
