#include "support/cvode_friction.h"

#include <algorithm>
#include <stdexcept>

#include "simulate/motion.h"

namespace tribolog::test {
namespace {

/// A model as CVODE sees it: the continuous members are its unknowns, the rest is kept here.
class FrictionProblem {
 public:
  FrictionProblem(const friction::DynamicFriction& friction, const simulate::Motion& motion,
                  const CvodeFrictionOptions& options)
      : friction_(friction),
        motion_(motion),
        first_step_s_(options.first_step_s),
        stops_left_(options.most_stops),
        moving_(continuous_members(friction)),
        state_(friction.unloaded()),
        rates_(state_.size()),
        solver_({state_.begin(), state_.begin() + static_cast<std::ptrdiff_t>(moving_)}, rates(),
                events(), solver_options(options)) {}

  /// Goes on to `t`; the solver's own steps may go on to `limit`.
  void advance_to(double t, double limit) {
    while (solver_.time() < t &&
           solver_.advance_to(t, limit) == simulate::CvodeSolver::Stop::at_event) {
      settle();
    }
  }
  /// The discrete members follow the others, and the solver starts anew.
  void settle() {
    if (--stops_left_ < 0) throw std::runtime_error("CVODE stops at events without end");
    take(solver_.unknowns());
    friction_.settle(state_, motion_.speed(solver_.time()));
    std::copy_n(state_.begin(), moving_, solver_.unknowns().begin());
    solver_.restart(first_step_s_);
  }
  [[nodiscard]] double torque_Nm() {
    take(solver_.unknowns());
    return friction_.torque_Nm(state_, motion_.speed(solver_.time()));
  }

 private:
  void take(std::span<const double> y) { std::copy(y.begin(), y.end(), state_.begin()); }

  simulate::CvodeSolver::Rates rates() {
    return [this](double t, std::span<const double> y, std::span<double> rates) {
      take(y);
      friction_.rates(state_, motion_.speed(t), rates_);
      std::copy_n(rates_.begin(), moving_, rates.begin());
    };
  }
  simulate::CvodeSolver::Events events() {
    return [this](double t, std::span<const double> y, std::span<double> values) {
      take(y);
      friction_.event_values(state_, motion_.speed(t), values);
    };
  }
  [[nodiscard]] simulate::CvodeSolver::Options solver_options(
      const CvodeFrictionOptions& options) const {
    simulate::CvodeSolver::Options out;
    out.method = options.method;
    out.relative_tolerance = options.relative_tolerance;
    out.absolute_tolerances.resize(friction_.states());
    friction_.state_scales(out.absolute_tolerances);
    out.absolute_tolerances.resize(moving_);
    for (double& one : out.absolute_tolerances) one *= options.relative_tolerance;
    out.largest_step = options.largest_step_s;
    out.events = friction_.events();
    return out;
  }

  const friction::DynamicFriction& friction_;
  const simulate::Motion& motion_;
  double first_step_s_;
  int stops_left_;
  std::size_t moving_;
  std::vector<double> state_;
  std::vector<double> rates_;
  simulate::CvodeSolver solver_;
};

}  // namespace

std::size_t continuous_members(const friction::DynamicFriction& friction) {
  std::vector<double> rates(friction.states());
  friction.rates(friction.unloaded(), 1.0, rates);
  const auto still = std::find(rates.begin(), rates.end(), 0.0);
  return static_cast<std::size_t>(still - rates.begin());
}

void friction_by_cvode(const friction::DynamicFriction& friction, const simulate::Motion& motion,
                       double dt_s, const CvodeFrictionOptions& options,
                       std::span<double> torque_Nm) {
  FrictionProblem problem(friction, motion, options);
  constexpr double never_s = 1e30;
  std::vector<double> reversals = options.reversals_s;
  reversals.push_back(never_s);
  auto next = reversals.begin();
  for (std::size_t i = 0; i < torque_Nm.size(); ++i) {
    const double t = static_cast<double>(i) * dt_s;
    for (; *next < t; ++next) {
      problem.advance_to(*next, *next);
      problem.settle();
    }
    problem.advance_to(t, *next);
    torque_Nm[i] = problem.torque_Nm();
  }
}

std::vector<double> reversals_of(const simulate::Motion& motion, double end_s, double scan_s) {
  std::vector<double> out;
  for (double a = 0; a < end_s; a += scan_s) {
    const double before = motion.speed(a);
    if (before * motion.speed(a + scan_s) < 0) {
      out.push_back(simulate::reversal_time(motion, a, a + scan_s, before < 0));
    }
  }
  return out;
}

}  // namespace tribolog::test
