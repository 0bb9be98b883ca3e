#include "method/hysteresis/lugre_ladder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Core>

#include "base/enum_text.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::hysteresis {
namespace {

using Shared = LuGreShared;

const std::vector<Shared::Index> elastic_only{Shared::log_stiffness, Shared::damping};
const std::vector<Shared::Index> friction_only{Shared::log_stiffness, Shared::log_static,
                                               Shared::damping};
const std::vector<Shared::Index> at_level{Shared::log_stiffness, Shared::log_static,
                                          Shared::damping, Shared::viscous, Shared::inertia};

/// Least reduction of the sum of squares, in units of the residual variance, that a rung has to
/// bring: five standard errors of one parameter, as two rungs are tried from four first guesses
/// each.
constexpr double least_gain = 25;

/// Reduction in the same units at which the fit to long recordings stops: a step of a hundredth of
/// a standard error. Further digits cost as much as those that count.
constexpr double smallest_gain = 1e-4;

/// Rows from which on it stops there.
constexpr Eigen::Index many_rows = 100'000;

/// Most evaluations from a rough solution of a friction that falls, or over so many rows: what
/// shows is a few steps away; what does not, wanders along the valley that share and fall make
/// together.
constexpr int longest_way = 25;

std::vector<Shared::Index> with(std::vector<Shared::Index> some,
                                std::initializer_list<Shared::Index> more) {
  some.insert(some.end(), more);
  std::sort(some.begin(), some.end());
  return some;
}

void surround(const LuGreProblem& problem, const std::vector<std::size_t>& blocks, LuGreClimb& at) {
  at.linear = problem.linearise(at.free, at.point, blocks);
  at.around =
      statistics::block_regression(at.linear.fit.jacobian, -at.linear.fit.residuals, blocks);
}

class Climber {
 public:
  Climber(const LuGreProblems& problems, const std::vector<std::size_t>& blocks)
      : problem_(problems.whole),
        halfway_(problems.halfway),
        thinned_(problems.thinned),
        blocks_(blocks) {
    for (const LuGreLoopModel& model : problem_.models()) {
      height_ = std::max(height_, model.height_Nm());
      amplitude_ = std::max(amplitude_, model.motor_amplitude_rad());
      peak_speed_ = std::max(peak_speed_, model.peak_speed_rad_s());
    }
  }

  LuGreClimb climb() {
    LuGreClimb level = from_level({at_level, true});
    const auto bends = [](const LuGreClimb& c) {
      return c.converged && c.stands(Shared::log_stiffness, widest_shown) &&
             c.stands(Shared::log_static, widest_shown);
    };
    if (!bends(level)) {
      LuGreClimb fewer = from_level({friction_only, true});
      if (bends(fewer) || !level.converged) level = std::move(fewer);
    }
    if (!level.converged) return elastic();
    const std::optional<Eigen::VectorXd> step = step_by_fall(level);
    if (!step) return bends(level) ? counted(level) : elastic();
    LuGreClimb whole = with_fall(level, {Shared::log_share, Shared::fall}, LuGreRung::whole);
    if (whole.stands(Shared::log_share, widest_climbed) &&
        whole.stands(Shared::fall, widest_climbed) && falls(whole) && pays(level, whole)) {
      return counted(whole);
    }
    LuGreClimb curved = with_fall(level, {Shared::fall}, LuGreRung::curvature);
    if (curved.stands(Shared::fall, widest_climbed) && falls(curved) && pays(level, curved)) {
      return counted(curved);
    }
    if (!bends(level)) return elastic();
    // Whether there is a fall stays open, and with it what it would change in the others.
    level.linear.fit.further_shifts = *step;
    return counted(level);
  }

 private:
  /// Friction that falls with speed, to a level above zero: what LuGre means by Ts > Tc.
  static bool falls(const LuGreClimb& c) {
    return c.converged && c.point.shared(Shared::fall) > 0 && c.point.shared(Shared::log_share) < 0;
  }

  /// Whether the higher rung explains more than chance among several first guesses would.
  static bool pays(const LuGreClimb& lower, const LuGreClimb& higher) {
    const double before = lower.linear.fit.residuals.squaredNorm();
    const double after = higher.linear.fit.residuals.squaredNorm();
    const auto samples = static_cast<double>(higher.linear.fit.residuals.size());
    return before - after > least_gain * after / samples;
  }

  [[nodiscard]] LuGrePoint first_guess(double bends_per_stroke) const {
    LuGrePoint guess;
    const double level = height_ / 2;
    const double stiffness = bends_per_stroke * level / amplitude_;
    guess.shared(Shared::log_stiffness) = std::log(stiffness);
    guess.shared(Shared::log_static) = std::log(level);
    guess.shared(Shared::log_share) = std::log(held_share);
    guess.shared(Shared::damping) = 0.01 * stiffness * amplitude_ / peak_speed_;
    for (const LuGreLoopModel& model : problem_.models()) {
      guess.locals.push_back({model.mean_torque_Nm(), 0});
    }
    return guess;
  }

  /// The best of several first guesses, roughly. Initial deflections stay fixed: while all else is
  /// wrong they would run away to compensate.
  LuGreProblem::Solution best_thinned(const LuGreFreedom& free,
                                      const std::vector<LuGrePoint>& guesses) {
    const statistics::LeastSquaresLimits rough{1e-6, 1e-4, 60};
    LuGreProblem::Solution best;
    best.squares = std::numeric_limits<double>::infinity();
    for (const LuGrePoint& guess : guesses) {
      LuGreProblem::Solution s = thinned_.solve({free.shared, false}, guess, rough);
      evaluations_ += s.evaluations;
      // A rough solution is enough: one that ran out of evaluations may still be the best to
      // continue from.
      if (s.squares < best.squares) best = std::move(s);
    }
    best.converged = std::isfinite(best.squares);
    return best;
  }

  /// Fits all samples from a guess, and linearises about the solution.
  LuGreClimb polished(LuGreRung rung, const LuGreFreedom& free, const LuGrePoint& guess) {
    LuGreClimb out;
    out.rung = rung;
    out.free = free;
    out.height_Nm = height_;
    LuGrePoint start = guess;
    statistics::LeastSquaresLimits limits;
    if (halfway_ != nullptr) {
      statistics::LeastSquaresLimits rough = limits;
      rough.cost_change = smallest_gain / static_cast<double>(problem_.rows());
      if (free.has(Shared::fall)) rough.evaluations = longest_way;
      const LuGreProblem::Solution nearby = halfway_->solve(free, guess, rough);
      evaluations_ += nearby.evaluations;
      if (!nearby.converged) return out;  // all samples would not lead anywhere either
      start = nearby.point;
      const bool has_many = problem_.rows() > many_rows;
      if (has_many) limits.cost_change = rough.cost_change;
      if (has_many || free.has(Shared::fall)) limits.evaluations = longest_way;
    }
    const LuGreProblem::Solution s = problem_.solve(free, start, limits);
    evaluations_ += s.evaluations;
    out.point = s.point;
    out.converged = s.converged;
    if (s.converged) surround(problem_, blocks_, out);
    return out;
  }

  LuGreClimb from_level(const LuGreFreedom& free) {
    std::vector<LuGrePoint> guesses;
    // From nearly elastic to sliding loops.
    for (const double bends : {2.0, 6.0, 20.0, 100.0, 600.0}) guesses.push_back(first_guess(bends));
    const LuGreProblem::Solution s = best_thinned(free, guesses);
    if (!s.converged) return {};
    return polished(LuGreRung::level, free, s.point);
  }

  /// One step of the fit that would let friction fall, in the columns of the level; absent where
  /// the residuals of the level hold no trace of a fall, by the interval of that step.
  std::optional<Eigen::VectorXd> step_by_fall(const LuGreClimb& level) {
    LuGreClimb probe;
    probe.free = {with(level.free.shared, {Shared::fall}), true};
    probe.point = level.point;
    probe.height_Nm = height_;
    probe.linear = problem_.linearise(probe.free, probe.point, blocks_);
    const statistics::LinearisedFit& fit = probe.linear.fit;
    probe.around = statistics::block_regression(fit.jacobian, -fit.residuals, blocks_);
    const Eigen::VectorXd& step = probe.around.coefficients;
    const Eigen::Index k = probe.column(Shared::fall);
    const LuGreStanding s = probe.standing(k, step(k));
    if (!(s.relative < widest_climbed && s.effect_Nm > smallest_effect * height_)) {
      return std::nullopt;
    }
    Eigen::VectorXd others(step.size() - 1);
    others << step.head(k), step.tail(step.size() - 1 - k);
    return others;
  }

  LuGreClimb with_fall(const LuGreClimb& level, std::initializer_list<Shared::Index> more,
                       LuGreRung rung) {
    const LuGreFreedom free{with(level.free.shared, more), true};
    std::vector<LuGrePoint> guesses;
    // Stribeck velocities from well within the loops' speeds to beyond them.
    for (const double share_of_peak : {0.15, 0.4, 1.0, 3.0}) {
      LuGrePoint guess = level.point;
      guess.shared(Shared::fall) = std::pow(share_of_peak * peak_speed_, -2);
      guesses.push_back(guess);
    }
    const LuGreProblem::Solution s = best_thinned(free, guesses);
    if (!s.converged) return {};
    return polished(rung, free, s.point);
  }

  LuGreClimb elastic() {
    LuGrePoint guess = first_guess(1);
    guess.shared(Shared::log_static) = std::log(elastic_heights * height_);
    const LuGreFreedom free{elastic_only, false};
    return counted(polished(LuGreRung::elastic, free, guess));
  }

  [[nodiscard]] LuGreClimb counted(LuGreClimb climb) const {
    climb.evaluations = evaluations_;
    return climb;
  }

  const LuGreProblem& problem_;
  const LuGreProblem* halfway_;
  const LuGreProblem& thinned_;
  const std::vector<std::size_t>& blocks_;
  double height_{0}, amplitude_{0}, peak_speed_{0};
  int evaluations_{0};
};

}  // namespace

std::string to_string(LuGreRung rung) { return own_name(rung); }

Eigen::Index LuGreClimb::column(Shared::Index parameter) const {
  const auto it = std::find(free.shared.begin(), free.shared.end(), parameter);
  return it == free.shared.end() ? -1 : it - free.shared.begin();
}

LuGreStanding LuGreClimb::standing(Eigen::Index k, double size) const {
  const Eigen::MatrixXd& r = linear.r_factor;
  const auto samples = static_cast<double>(linear.fit.residuals.size());
  // Norm of column k less what the other columns explain of it: 1 / |row k of R^-1|.
  const Eigen::VectorXd row =
      statistics::solve_transposed_triangle(r, Eigen::VectorXd::Unit(r.cols(), k));
  LuGreStanding out;
  out.half_width = around.half_width(k);
  out.relative = out.half_width / std::abs(size);
  out.effect_Nm = std::abs(size) / (row.norm() * std::sqrt(samples));
  return out;
}

LuGreStanding LuGreClimb::standing(Shared::Index parameter) const {
  const bool logarithm = parameter == Shared::log_stiffness || parameter == Shared::log_static ||
                         parameter == Shared::log_share;
  return standing(column(parameter), logarithm ? 1.0 : point.shared(parameter));
}

bool LuGreClimb::stands(Shared::Index parameter, double widest) const {
  if (!converged || column(parameter) < 0) return false;
  const LuGreStanding s = standing(parameter);
  return s.relative < widest && s.effect_Nm > smallest_effect * height_Nm;
}

LuGreClimb solved_again(LuGreClimb nearby, const LuGreProblem& problem,
                        const std::vector<std::size_t>& block_of_row) {
  statistics::LeastSquaresLimits limits;
  limits.cost_change = smallest_gain / static_cast<double>(problem.rows());
  limits.evaluations = longest_way;
  const LuGreProblem::Solution s = problem.solve(nearby.free, nearby.point, limits);
  nearby.evaluations += s.evaluations;
  nearby.point = s.point;
  Eigen::MatrixXd shifts = std::move(nearby.linear.fit.further_shifts);
  surround(problem, block_of_row, nearby);
  nearby.linear.fit.further_shifts = std::move(shifts);
  return nearby;
}

LuGreClimb climb_lugre_ladder(const LuGreProblems& problems,
                              const std::vector<std::size_t>& block_of_row) {
  return Climber(problems, block_of_row).climb();
}

}  // namespace tribolog::method::hysteresis
