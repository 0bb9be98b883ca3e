// Armstrong's seven-parameter model of lubricated contacts (Armstrong-Hélouvry, Dupont, Canudas de
// Wit 1994).
//
//   sticking: T = kt x,                                        x: deflection of the junctions
//   sliding:  T = (Tc + Tv |w| + Ts(t2) / (1 + (wl/ws)^2)) sgn(w)
//   Ts(t2) = Ts,a + (Ts,inf - Ts,a) t2 / (t2 + gamma)
//
// t2: dwell time before sliding; Ts,a: Stribeck torque at the end of the previous sliding. Sticking
// ends where |kt x| reaches Tc + Ts(t2): the longer the dwell, the higher the break-away torque. wl
// lags behind |w| with the frictional lag tL; as in HessSoomFriction a first-order lag replaces the
// pure delay. The seven: kt, Tc, Tv, Ts,inf, ws, tL, gamma.

#include <cmath>

#include "base/requirements.h"
#include "base/statement.h"
#include "friction/exponential_step.h"
#include "friction/friction_model.h"
#include "friction/model_entry.h"
#include "friction/sign_change.h"

namespace tribolog::friction {
namespace {

/// State: x [rad], wl [rad/s], dwell time t2 [s], Stribeck torque Ts [N·m] of the present sliding
/// (of the last one while sticking), and 0 while sticking or the direction (-1, 1) of sliding.
class ArmstrongFriction final : public DynamicFriction {
 public:
  struct Parameters {
    double stiffness_Nm_rad{};         ///< kt > 0
    double coulomb_Nm{};               ///< Tc > 0
    double viscous_Nms_rad{};          ///< Tv >= 0
    double rested_stribeck_Nm{};       ///< Ts,inf >= 0, after a long rest
    double stribeck_speed_rad_s{1.0};  ///< ws > 0
    double lag_s{};                    ///< tL > 0
    double rise_time_s{};              ///< gamma > 0
    ParameterSlots by_name();
  };

  /// @throw Refusal stating the value and the rule.
  explicit ArmstrongFriction(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] std::string name() const override { return "armstrong"; }
  [[nodiscard]] NamedParameters named_parameters() const override { return named(p_); }
  /// Break-away torque [N·m] after a dwell `rest_s` that followed sliding, at whose end the
  /// Stribeck torque was `last_stribeck_Nm`.
  [[nodiscard]] double break_away_Nm(double rest_s, double last_stribeck_Nm = 0.0) const;

  [[nodiscard]] std::size_t states() const override { return 5; }
  void state_scales(std::span<double> scales) const override;
  [[nodiscard]] std::size_t events() const override { return 1; }
  void event_values(std::span<const double> state, double speed_rad_s,
                    std::span<double> values) const override;
  void rates(std::span<const double> state, double speed_rad_s,
             std::span<double> rates) const override;
  void settle(std::span<double> state, double speed_rad_s) const override;
  [[nodiscard]] double torque_Nm(std::span<const double> state, double speed_rad_s) const override;
  /// After a long rest; after a shorter one the Stribeck torque is smaller.
  [[nodiscard]] double steady_torque_Nm(double speed_rad_s) const override;
  /// Exact except for the instant of break-away, which is found by false position.
  void advance(std::span<double> state, const SpeedStep& step) const override;

 private:
  [[nodiscard]] double sliding_Nm(std::span<const double> state, double speed_rad_s) const;
  void lag(std::span<double> state, const SpeedStep& step) const;
  void begin_sliding(std::span<double> state, double direction) const;
  void begin_sticking(std::span<double> state) const;

  Parameters p_;
};

enum Member : std::size_t { deflection, lagged_speed, stuck_time, stribeck, sliding };

ParameterSlots ArmstrongFriction::Parameters::by_name() {
  return {{"stiffness_Nm_rad", &stiffness_Nm_rad},
          {"coulomb_Nm", &coulomb_Nm},
          {"viscous_Nms_rad", &viscous_Nms_rad},
          {"rested_stribeck_Nm", &rested_stribeck_Nm},
          {"stribeck_speed_rad_s", &stribeck_speed_rad_s},
          {"lag_s", &lag_s},
          {"rise_time_s", &rise_time_s}};
}

ArmstrongFriction::ArmstrongFriction(const Parameters& parameters) : p_(parameters) {
  require_positive(p_.stiffness_Nm_rad, "stiffness", "N·m/rad");
  require_positive(p_.coulomb_Nm, "Coulomb torque", "N·m");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
  require_not_negative(p_.rested_stribeck_Nm, Code{"parameter.rested_stribeck"}, "N·m");
  require_positive(p_.stribeck_speed_rad_s, "Stribeck velocity", "rad/s");
  require_positive(p_.lag_s, "frictional lag", "s");
  require_positive(p_.rise_time_s, Code{"parameter.rise_time"}, "s");
}

double ArmstrongFriction::break_away_Nm(double rest_s, double last_stribeck_Nm) const {
  const double risen =
      (p_.rested_stribeck_Nm - last_stribeck_Nm) * rest_s / (rest_s + p_.rise_time_s);
  return p_.coulomb_Nm + last_stribeck_Nm + risen;
}

void ArmstrongFriction::rates(std::span<const double> state, double speed_rad_s,
                              std::span<double> rates) const {
  const bool sticks = state[sliding] == 0.0;
  rates[deflection] = sticks ? speed_rad_s : 0.0;
  rates[lagged_speed] = (std::abs(speed_rad_s) - state[lagged_speed]) / p_.lag_s;
  rates[stuck_time] = sticks ? 1.0 : 0.0;
  rates[stribeck] = 0;
  rates[sliding] = 0;
}

double ArmstrongFriction::sliding_Nm(std::span<const double> state, double speed_rad_s) const {
  const double x = state[lagged_speed] / p_.stribeck_speed_rad_s;
  return p_.coulomb_Nm + p_.viscous_Nms_rad * std::abs(speed_rad_s) + state[stribeck] / (1 + x * x);
}

void ArmstrongFriction::begin_sliding(std::span<double> state, double direction) const {
  state[stribeck] = break_away_Nm(state[stuck_time], state[stribeck]) - p_.coulomb_Nm;
  state[sliding] = direction;
  state[stuck_time] = 0;
}

/// The junctions keep the torque that they carry, and the Stribeck torque its present value.
void ArmstrongFriction::begin_sticking(std::span<double> state) const {
  const double x = state[lagged_speed] / p_.stribeck_speed_rad_s;
  state[deflection] = state[sliding] * sliding_Nm(state, 0) / p_.stiffness_Nm_rad;
  state[stribeck] /= 1 + x * x;
  state[sliding] = 0;
  state[stuck_time] = 0;
}

void ArmstrongFriction::settle(std::span<double> state, double speed_rad_s) const {
  if (state[sliding] != 0.0 && state[sliding] * speed_rad_s <= 0) begin_sticking(state);
  if (state[sliding] != 0.0 || speed_rad_s == 0.0) return;
  const double direction = direction_of(speed_rad_s);
  const double torque = direction * p_.stiffness_Nm_rad * state[deflection];
  constexpr double at_limit = 1 - 1e-9;  // a solver stops next to the moment, not on it
  const double limit = at_limit * break_away_Nm(state[stuck_time], state[stribeck]);
  if (torque >= limit) begin_sliding(state, direction);
}

double ArmstrongFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  if (state[sliding] == 0.0) return p_.stiffness_Nm_rad * state[deflection];
  return state[sliding] * sliding_Nm(state, speed_rad_s);
}

double ArmstrongFriction::steady_torque_Nm(double speed_rad_s) const {
  if (speed_rad_s == 0.0) return 0;
  const double direction = direction_of(speed_rad_s);
  const double state[] = {0, std::abs(speed_rad_s), 0, p_.rested_stribeck_Nm, direction};
  return torque_Nm(state, speed_rad_s);
}

void ArmstrongFriction::lag(std::span<double> state, const SpeedStep& step) const {
  const double rate = 1 / p_.lag_s;
  state[lagged_speed] =
      relaxed(relaxation_shape<double>(rate, rate, rate, std::abs(step.start_rad_s),
                                       std::abs(step.middle_rad_s), std::abs(step.end_rad_s),
                                       step.duration_s),
              state[lagged_speed]);
}

void ArmstrongFriction::advance(std::span<double> state, const SpeedStep& step) const {
  const double direction = step.direction();
  if (state[sliding] != 0.0 && state[sliding] != direction) begin_sticking(state);
  if (state[sliding] != 0.0) {
    lag(state, step);
    return;
  }
  const auto excess = [&](double share) {
    const double x = state[deflection] + step.part(0, share).path_rad();
    const double rest = state[stuck_time] + share * step.duration_s;
    return direction * p_.stiffness_Nm_rad * x - break_away_Nm(rest, state[stribeck]);
  };
  const bool breaks_away = direction != 0.0 && excess(1) >= 0;
  double until = 1;
  if (breaks_away) until = excess(0) < 0 ? sign_change(excess, 0.0, 1.0, share_resolution) : 0.0;
  const SpeedStep stuck = step.part(0, until);
  state[deflection] += stuck.path_rad();
  state[stuck_time] += stuck.duration_s;
  lag(state, stuck);
  if (!breaks_away) return;
  begin_sliding(state, direction);
  lag(state, step.part(until, 1));
}

void ArmstrongFriction::state_scales(std::span<double> scales) const {
  scales[deflection] = p_.coulomb_Nm / p_.stiffness_Nm_rad;
  scales[lagged_speed] = p_.stribeck_speed_rad_s;
  scales[stuck_time] = p_.rise_time_s;
  scales[stribeck] = p_.coulomb_Nm;
  scales[sliding] = 1;
}

void ArmstrongFriction::event_values(std::span<const double> state, double /*speed_rad_s*/,
                                     std::span<double> values) const {
  const bool sticks = state[sliding] == 0.0;
  const double torque = p_.stiffness_Nm_rad * std::abs(state[deflection]);
  values[0] = sticks ? torque - break_away_Nm(state[stuck_time], state[stribeck]) : 1.0;
}

ArmstrongFriction::Parameters armstrong(const ContactParameters& c) {
  return {c.stiffness_Nm_rad,
          c.coulomb_Nm,
          c.viscous_Nms_rad,
          c.static_Nm - c.coulomb_Nm,
          c.stribeck_speed_rad_s,
          matched_lag_s,
          0.1};
}

}  // namespace

FrictionModelEntry armstrong_model() {
  return model<ArmstrongFriction>({.break_away = true,
                                   .stribeck = true,
                                   .lag = true,
                                   .presliding = true,
                                   .remembers_rest = true},
                                  armstrong);
}

}  // namespace tribolog::friction
