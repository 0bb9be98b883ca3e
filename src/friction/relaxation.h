#pragma once
// Friction that relaxes towards a speed-dependent value which also depends on itself.
//
//   dy/dt = rate(w) (target(w, y) - y)
//
// This is the bristle equation with a non-linear term in the target. Where that term is flat, as in
// steady sliding, a step may be as long as the sampling interval, however stiff the equation.

#include <algorithm>
#include <cmath>
#include <optional>

#include "friction/exponential_step.h"
#include "friction/friction_model.h"

namespace tribolog::friction {

/// Exponential, 4th order: the target is the parabola through its values at a step's start, middle
/// and end, which are found by iteration; a step over which it bends too sharply is halved.
/// @tparam Equation has a type `Node` of what depends on speed alone, including the `rate`; `Node
/// at(double speed) const` and `double target(const Node&, double y) const`.
template <class Equation>
class Relaxation {
  using Node = typename Equation::Node;

 public:
  /// @param size magnitude of y, > 0: the scale of the error limits.
  Relaxation(const Equation& equation, double size)
      : equation_(equation), roughest_(roughest_step * size), settled_(settled_share * size) {}

  /// y at the end of the step.
  [[nodiscard]] double advance(const SpeedStep& step, double y) const {
    return advance(step, y, equation_.at(step.start_rad_s), equation_.at(step.end_rad_s));
  }
  /// The same with the nodes of the step's start and end, where they are known.
  [[nodiscard]] double advance(const SpeedStep& step, double y, const Node& start,
                               const Node& last) const {
    return advance(step, y, start, last, deepest_halving);
  }

  struct Solution {
    double middle;    ///< y in the middle of the step's time,
    double end;       ///< and at its end.
    bool is_settled;  ///< The iteration has converged.
  };
  /// y in the middle and at the end of two equal steps taken as one, which is cheaper and as
  /// accurate where samples are closer than the motion requires. Absent where they are not.
  [[nodiscard]] std::optional<Solution> advance_pair(double duration_s, double y, const Node& start,
                                                     const Node& middle, const Node& last) const {
    if (duration_s * middle.rate > longest_pair) return std::nullopt;
    const auto solved = solve(duration_s, y, start, middle, last, roughest_pair * roughest_);
    return solved && solved->is_settled ? solved : std::nullopt;
  }

 private:
  // Both chosen by measurement, the fastest at their error: with the catalogue's contacts at 1 kHz
  // they leave up to 5e-6 of y in the sharpest steps, those of an unloaded contact that is set
  // sliding at full speed, and 1e-8 at reversals.
  static constexpr double roughest_step = 1e-3;
  static constexpr double settled_share = 1e-10;
  // Of a pair: its length, and its roughness as a share of a step's, so that its error stays below
  // that of reversals.
  static constexpr double longest_pair = 0.25;
  static constexpr double roughest_pair = 0.02;
  static constexpr int deepest_halving = 40;
  static constexpr int most_iterations = 8;

  /// The parabola's last term. The terms beyond it grow with the step's length: y, and with it the
  /// target, decay over a length of one, which three points hardly resolve in a long step.
  static double roughness(const StepShape<double>& shape) {
    return std::abs(shape.c2) * (1 + shape.length * shape.length * shape.length);
  }

  /// The end and the middle of a step by one parabola of the target. Of the length alone, and so
  /// the same for every parabola: the moments.
  struct Moments {
    double half;  ///< Length from the start to the middle.
    StepMoments<double> to_end, to_middle;

    Moments(double length, double half_length)
        : half(half_length), to_end(moments_of(length)), to_middle(moments_of(half_length)) {}
    [[nodiscard]] double end(const StepShape<double>& s, double y) const {
      return to_end.decay * y + step_source(s, to_end);
    }
    [[nodiscard]] double middle(const StepShape<double>& s, double y) const {
      const double x = s.length > 0 ? half / s.length : 0.5;
      return to_middle.decay * y + step_source({half, s.c0, s.c1 * x, s.c2 * x * x}, to_middle);
    }
  };

  [[nodiscard]] double advance(const SpeedStep& step, double y, const Node& start, const Node& last,
                               int halvings) const {
    const Node middle = equation_.at(step.middle_rad_s);
    const double roughest = halvings > 0 ? roughest_ : INFINITY;
    const auto solved = solve(step.duration_s, y, start, middle, last, roughest);
    if (solved && (solved->is_settled || halvings == 0)) return solved->end;
    const double between = advance(step.part(0, 0.5), y, start, middle, halvings - 1);
    return advance(step.part(0.5, 1), between, middle, last, halvings - 1);
  }

  /// A step by one parabola; absent if that bends too sharply.
  [[nodiscard]] std::optional<Solution> solve(double duration_s, double y, const Node& start,
                                              const Node& middle, const Node& last,
                                              double roughest) const {
    const double start_target = equation_.target(start, y);
    const double length = duration_s / 6 * (start.rate + 4 * middle.rate + last.rate);
    const double to_middle = duration_s / 24 * (5 * start.rate + 8 * middle.rate - last.rate);
    const double half = std::clamp(to_middle, 0.0, length);
    // First guess: on along the tangent, not beyond the target.
    const double fall = start_target - y;
    double middle_target = equation_.target(middle, y + std::min(half, 1.0) * fall);
    double end_target = equation_.target(last, y + std::min(length, 1.0) * fall);
    // What is still missing of the target reaches y by the step's length.
    const double settled = settled_ / std::min(length, 1.0);
    std::optional<Moments> moments;
    Solution out{y, y, false};
    for (int i = 0; i < most_iterations; ++i) {
      const StepShape<double> shape = relaxation_shape<double>(
          start.rate, middle.rate, last.rate, start_target, middle_target, end_target, duration_s);
      if (roughness(shape) > roughest) return std::nullopt;
      if (!moments) moments.emplace(length, half);
      out.end = moments->end(shape, y);
      out.middle = moments->middle(shape, y);
      const double old_middle = middle_target;
      const double old_end = end_target;
      middle_target = equation_.target(middle, out.middle);
      end_target = equation_.target(last, out.end);
      const double change = std::abs(middle_target - old_middle) + std::abs(end_target - old_end);
      out.is_settled = change <= settled;
      if (out.is_settled) break;
    }
    return out;
  }

  const Equation& equation_;
  double roughest_;
  double settled_;
};

}  // namespace tribolog::friction
