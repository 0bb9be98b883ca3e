#include "simulate/periodic_orbit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <Eigen/LU>

#include "base/requirements.h"
#include "base/statement.h"

namespace tribolog::simulate {
namespace {

// Far above the solver's noise, far below what bends the map.
constexpr double difference_share = 1e-4;

/// No step is longer than this share of a period: the solver steps over nothing that is brief.
constexpr double longest_step_share = 1e-2;

/// Speed and friction state, each in units of its usual size.
using State = Eigen::VectorXd;

struct Period {
  State start;
  State end;
  ForcedMotion motion;

  [[nodiscard]] double gap() const { return (end - start).lpNorm<Eigen::Infinity>(); }
};

double largest_size(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

class PeriodMap {
 public:
  PeriodMap(const friction::DynamicFriction& friction, const PeriodicOrbitSetup& setup)
      : friction_(friction), scale_(1 + static_cast<Eigen::Index>(friction.states())) {
    forced_.inertia_kgm2 = setup.inertia_kgm2;
    forced_.applied_Nm = [applied = setup.applied_Nm](double t, double, double) {
      return applied(t);
    };
    forced_.duration_s = setup.period_s;
    forced_.sample_s = setup.period_s / static_cast<double>(setup.samples);
    forced_.relative_tolerance = setup.relative_tolerance;
    forced_.largest_step_s = longest_step_share * setup.period_s;
    std::vector<double> scales(friction.states());
    friction.state_scales(scales);
    std::copy(scales.begin(), scales.end(), scale_.begin() + 1);
    settle();
  }

  [[nodiscard]] const State& settled() const { return settled_; }

  [[nodiscard]] std::vector<double> friction_state(const State& y) const {
    const State si = y.cwiseProduct(scale_);
    return {si.begin() + 1, si.end()};
  }

  [[nodiscard]] Period from(const State& y) const {
    ForcedMotionSetup setup = forced_;
    setup.speed_rad_s = y[0] * scale_[0];
    setup.friction_state = friction_state(y);
    Period out{y, State(y.size()), simulate_forced_motion(friction_, setup)};
    out.end[0] = out.motion.speed_rad_s.back();
    std::copy(out.motion.end_state.begin(), out.motion.end_state.end(), out.end.begin() + 1);
    out.end = out.end.cwiseQuotient(scale_);
    return out;
  }

  /// Newton's correction; none where the equations have no solution.
  [[nodiscard]] std::optional<State> corrected(const Period& now) const {
    const Eigen::Index n = now.start.size();
    Eigen::MatrixXd residual_by_start(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      State beside = now.start;
      beside[i] += difference_share;
      const Period other = from(beside);
      residual_by_start.col(i) =
          ((other.end - other.start) - (now.end - now.start)) / difference_share;
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> equations(residual_by_start);
    if (!equations.isInvertible()) return std::nullopt;
    return now.start - equations.solve(now.end - now.start);
  }

 private:
  /// The first period from rest: it shows how large speeds are, and where to look for the orbit.
  void settle() {
    const ForcedMotion first = simulate_forced_motion(friction_, forced_);
    const double fastest = largest_size(first.speed_rad_s);
    scale_[0] = fastest > 0 ? fastest : 1.0;
    settled_ = State(scale_.size());
    settled_[0] = first.speed_rad_s.back();
    std::copy(first.end_state.begin(), first.end_state.end(), settled_.begin() + 1);
    settled_ = settled_.cwiseQuotient(scale_);
  }

  const friction::DynamicFriction& friction_;
  ForcedMotionSetup forced_;
  State scale_;
  State settled_;
};

void centre(std::vector<double>& angle_rad) {
  const auto [low, high] = std::minmax_element(angle_rad.begin(), angle_rad.end());
  const double middle = (*low + *high) / 2;
  for (double& angle : angle_rad) angle -= middle;
}

}  // namespace

PeriodicOrbit periodic_orbit(const friction::DynamicFriction& friction,
                             const PeriodicOrbitSetup& setup) {
  require_positive(setup.period_s, "period", "s");
  require_positive(static_cast<double>(setup.samples), Code{"parameter.number_of_samples"}, "");
  require_positive(setup.closed_to, Code{"parameter.largest_closed_gap"}, "");
  if (!setup.applied_Nm) throw std::invalid_argument("no torque");

  const PeriodMap map(friction, setup);
  Period now = map.from(map.settled());
  PeriodicOrbit out;
  for (; now.gap() > setup.closed_to && out.corrections < setup.most_corrections;
       ++out.corrections) {
    const std::optional<State> start = map.corrected(now);
    Period next = map.from(start.value_or(now.end));
    if (start && !(next.gap() < now.gap())) next = map.from(now.end);
    now = std::move(next);
  }
  out.gap = now.gap();
  out.converged = out.gap <= setup.closed_to;
  out.start_state = map.friction_state(now.start);
  out.cycle = std::move(now.motion);
  out.drift_rad = out.cycle.angle_rad.back() - out.cycle.angle_rad.front();
  centre(out.cycle.angle_rad);
  return out;
}

}  // namespace tribolog::simulate
