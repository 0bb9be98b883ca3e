#pragma once
// The motion that a periodic torque ends in: the orbit that repeats after one period.
//
// From rest a loop of friction closes only after some periods, how many depends on the damping. The
// start from which it closes at once is a root of
//
//   P(y) - y = 0,   y = speed and friction state,
//
// where P carries y over one period of the torque. It is found by shooting: Newton's method with
// derivatives of P from finite differences and, where a correction leads away from the root, by
// going on for one more period, which a damped motion always forgives. The angle is not part of y:
// nothing depends on it. It may therefore grow by the same amount in each period, which is given as
// the drift; where the second half of the motion mirrors the first there is none.
// A motion that does not settle, or a model whose state jumps (elements that slip or stick have no
// derivative), may end without convergence; the result says so.

#include <functional>
#include <vector>

#include "friction/friction_model.h"
#include "simulate/forced_motion.h"

namespace tribolog::simulate {

struct PeriodicOrbitSetup {
  double inertia_kgm2{1.0};                      ///< > 0
  std::function<double(double t_s)> applied_Nm;  ///< Repeats after the period.
  double period_s{};                             ///< > 0
  std::size_t samples{2000};                     ///< Intervals in a period, at least 1.
  double relative_tolerance{1e-9};               ///< Of the solver, > 0.
  double closed_to{1e-8};                        ///< Largest gap that counts as closed, > 0.
  int most_corrections{20};
};

struct PeriodicOrbit {
  /// One period from t = 0; the extremes of the angle lie at equal distances from zero.
  ForcedMotion cycle;
  std::vector<double> start_state;  ///< Of the friction model, at t = 0.
  /// What differs after the period: of the speed as a share of its largest value in the first
  /// period from rest, of the friction state as a share of its members' usual size. The largest of
  /// them.
  double gap{};
  double drift_rad{};  ///< Angle after the period less that before it.
  int corrections{};   ///< Starts that were tried after the first.
  bool converged{};    ///< gap <= closed_to
};

/// @throw Refusal for a value that is not allowed, or equations that the solver gives up.
PeriodicOrbit periodic_orbit(const friction::DynamicFriction& friction,
                             const PeriodicOrbitSetup& setup);

}  // namespace tribolog::simulate
