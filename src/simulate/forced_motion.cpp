#include "simulate/forced_motion.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/requirements.h"
#include "base/statement.h"
#include "simulate/cvode_solver.h"

namespace tribolog::simulate {

namespace {

constexpr std::size_t angle = 0;
constexpr std::size_t speed = 1;
constexpr std::size_t first_state = 2;

}  // namespace

ForcedMotion simulate_forced_motion(const friction::DynamicFriction& friction,
                                    const ForcedMotionSetup& setup) {
  require_positive(setup.inertia_kgm2, "inertia", "kg·m²");
  require_positive(setup.duration_s, "duration", "s");
  require_positive(setup.sample_s, "sampling interval", "s");
  require_positive(setup.relative_tolerance, "relative tolerance", "");
  if (!setup.applied_Nm) throw std::invalid_argument("no torque");

  const std::vector<double> contact =
      setup.friction_state.empty() ? friction.unloaded() : setup.friction_state;
  if (contact.size() != friction.states()) throw std::invalid_argument("unequal sizes");
  std::vector<double> start{setup.angle_rad, setup.speed_rad_s};
  start.insert(start.end(), contact.begin(), contact.end());
  std::vector<double> scale(contact.size());
  friction.state_scales(scale);

  CvodeSolver::Options options;
  options.relative_tolerance = setup.relative_tolerance;
  options.absolute_tolerances = {setup.least_angle_rad, setup.least_speed_rad_s};
  for (const double one : scale) {
    options.absolute_tolerances.push_back(one * setup.relative_tolerance);
  }
  options.largest_step = setup.largest_step_s;
  options.events = 1 + friction.events();
  const double inertia = setup.inertia_kgm2;
  CvodeSolver solver(
      start,
      [&](double t, std::span<const double> y, std::span<double> rates) {
        const auto state = y.subspan(first_state);
        rates[angle] = y[speed];
        rates[speed] =
            (setup.applied_Nm(t, y[angle], y[speed]) - friction.torque_Nm(state, y[speed])) /
            inertia;
        friction.rates(state, y[speed], rates.subspan(first_state));
      },
      [&](double, std::span<const double> y, std::span<double> values) {
        values[0] = y[speed];
        friction.event_values(y.subspan(first_state), y[speed], values.subspan(1));
      },
      options);

  ForcedMotion out;
  const auto count = static_cast<std::size_t>(std::floor(setup.duration_s / setup.sample_s + 1e-9));
  for (std::size_t i = 0; i <= count; ++i) {
    const double t = static_cast<double>(i) * setup.sample_s;
    while (solver.time() < t && solver.advance_to(t) == CvodeSolver::Stop::at_event) {
      if (solver.happened(0)) solver.unknowns()[speed] = 0;
      friction.settle(solver.unknowns().subspan(first_state), solver.unknowns()[speed]);
      constexpr double first_step_share = 1e-6;
      solver.restart(first_step_share * setup.largest_step_s);
    }
    const std::span<double> y = solver.unknowns();
    out.t_s.push_back(t);
    out.angle_rad.push_back(y[angle]);
    out.speed_rad_s.push_back(y[speed]);
    out.applied_Nm.push_back(setup.applied_Nm(t, y[angle], y[speed]));
    out.friction_Nm.push_back(friction.torque_Nm(y.subspan(first_state), y[speed]));
  }
  const auto end = solver.unknowns().subspan(first_state);
  out.end_state.assign(end.begin(), end.end());
  return out;
}

joint::Recording simulate_break_away_ramp(const Scenario& s, const BreakAwayExperiment& e,
                                          double direction, std::string name) {
  require_positive(e.rate_Nm_s, "rate_Nm_s", "N·m/s");
  require_positive(e.largest_torque_Nm, "largest_torque_Nm", "N·m");
  require_positive(e.largest_travel_rad, "largest_travel", "rad");
  require_positive(e.sample_rate_Hz, "sample_rate_Hz", "Hz");
  const double n = s.gear_ratio;
  const double inertia = s.motor_inertia_kgm2 + s.arm_inertia_kgm2 / (n * n);
  require_positive(inertia, Code{"parameter.inertia_of_motor_and_arm"}, "kg·m²");
  const auto load_Nm = [&](double q) { return load_torque_Nm(s, q, joint::Role::break_away) / n; };
  const double held_Nm = load_Nm(e.centre_rad);
  const auto torque_at = [&](double t) { return held_Nm + direction * e.rate_Nm_s * t; };
  ForcedMotionSetup setup;
  setup.inertia_kgm2 = inertia;
  setup.angle_rad = n * e.centre_rad;
  // Over the little way of a ramp it is the same.
  const double of_angle_Nm = torque_of_angle_Nm(s, e.centre_rad);
  setup.applied_Nm = [&](double t, double motor_rad, double) {
    return torque_at(t) - load_Nm(motor_rad / n) - of_angle_Nm;
  };
  setup.duration_s = e.largest_torque_Nm / e.rate_Nm_s;
  setup.sample_s = 1 / e.sample_rate_Hz;
  setup.relative_tolerance = 1e-8;
  const double factor = friction_factor_of_ramp(s, e.centre_rad, direction);
  // A larger friction moves as a smaller torque and inertia do.
  setup.inertia_kgm2 /= factor;
  setup.applied_Nm = [applied = setup.applied_Nm, factor](double t, double motor_rad, double w) {
    return applied(t, motor_rad, w) / factor;
  };
  const ForcedMotion motion = simulate_forced_motion(*s.presliding, setup);

  joint::Recording r;
  r.name = std::move(name);
  r.role = joint::Role::break_away;
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    const double q = motion.angle_rad[i] / n;
    if (std::abs(q - e.centre_rad) > e.largest_travel_rad) break;
    r.t_s.push_back(motion.t_s[i]);
    r.q_rad.push_back(q);
    r.dq_rad_s.push_back(motion.speed_rad_s[i] / n);
    r.torque_Nm.push_back(torque_at(motion.t_s[i]) + s.effects.torque_offset_Nm +
                          s.effects.offset_drift_Nm - left_out_Nm(s, q, r.role));
  }
  r.rows_read = r.size();
  return r;
}

}  // namespace tribolog::simulate
