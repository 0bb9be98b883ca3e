#include "simulate/unmodelled_effects.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "friction/lugre.h"
#include "friction/static_laws.h"
#include "simulate/scenario.h"
#include "statistics/random_stream.h"
#include "statistics/sampled_signal.h"

namespace tribolog::simulate {
namespace {

using std::numbers::pi;

/// Of the load, where the gear is twisted by it: q = q_load + windup cos(q_load - q_peak), the
/// windup larger and smaller once a turn.
double load_angle(const Scenario& s, double motor_q_rad) {
  const double windup = s.effects.gear_windup_rad;
  if (windup == 0) return motor_q_rad;
  double q = motor_q_rad;
  for (int k = 0; k < 30; ++k) {
    const double here = windup * (1 + s.effects.uneven_windup * std::sin(q));
    q = motor_q_rad - here * std::cos(q - s.load.q_peak_rad());
  }
  return q;
}

double lost_by_warming_up(const JointEffects& e, double share_of_session) {
  constexpr double time_constants = 3;
  return e.warm_up * -std::expm1(-time_constants * share_of_session);
}

/// 1 in sliding, less while the contact builds up.
double built_up(double friction_Nm, double static_Nm) {
  const double sign = friction_Nm < 0 ? -1 : 1;
  if (!(static_Nm > 0)) return friction_Nm == 0 ? 0 : sign;
  return std::clamp(friction_Nm / static_Nm, -1.0, 1.0);
}

double scaled_friction(const Scenario& s, double q_rad, double friction_Nm,
                       double share_of_session) {
  const JointEffects& e = s.effects;
  const double direction = friction_Nm < 0 ? -1 : 1;
  return friction_Nm * (1 + e.direction_asymmetry * direction) *
         (1 - lost_by_warming_up(e, share_of_session)) *
         (1 + e.friction_by_angle * std::cos(2 * q_rad)) *
         (1 + e.friction_by_motor_angle * std::cos(e.periods_per_motor_turn * s.gear_ratio * q_rad +
                                                   e.phase_of_motor_angle_rad));
}

/// What a viscous torque that is no straight line of the speed has beside the straight one.
double bend_of_viscous_Nm(const JointEffects& e, double motor_rad_s) {
  if (e.viscous_exponent == 1 || motor_rad_s == 0) return 0;
  const double share = std::abs(motor_rad_s) / e.bent_viscous_rad_s;
  return e.bent_viscous_Nms_rad * motor_rad_s * (std::pow(share, e.viscous_exponent - 1) - 1);
}

}  // namespace

bool JointEffects::any() const {
  return gear_loss != 0 || load_friction != 0 || direction_asymmetry != 0 ||
         torque_offset_Nm != 0 || offset_drift_Nm != 0 || warm_up != 0 || friction_by_angle != 0 ||
         friction_by_motor_angle != 0 || viscous_exponent != 1 || gear_windup_rad != 0 ||
         spring_Nm_rad != 0 || twice_the_angle_Nm != 0 || taken_off != 0 || gravity_left_out != 0 ||
         tool_gravity != 0 || (foreign_run != 0 && foreign_friction != 1) || second_harmonic != 0 ||
         third_harmonic != 0;
}

bool LogEffects::any() const {
  return torque_delay_s != 0 || torque_filter_Hz != 0 || resonance_Hz != 0 || torque_mean_s != 0 ||
         torque_scale != 1 || scale_of_loops != 1 || scale_of_runs != 1 || coulomb_model_Nm != 0 ||
         crosstalk_Nm != 0 || touch_Nm != 0 || tare_Nm != 0 || repeated_percent != 0 ||
         saturation_per_Nm2 != 0 || saturation_per_Nm != 0 || dead_zone_Nm != 0 ||
         torque_limit_Nm != 0 || vibration_Nm != 0 || coloured_Nm != 0 || neighbour_Nm != 0 ||
         outlier_percent != 0 || held_percent != 0 || dead_percent != 0 || speed_scale != 1 ||
         wrap_rad != 0 || jump_rad != 0 || homed_anew_rad != 0 || lost_percent != 0 ||
         mirrored_angle || mirrored_torque;
}

joint::EffectSizes absent_effects(const Scenario& s) {
  namespace effect = joint::effect;
  LogEffects log = s.noise.effects;
  log.mirrored_angle = log.mirrored_torque = false;
  joint::EffectSizes absent;
  if (s.effects.any() || log.any()) return absent;
  for (const joint::Effect& one : joint::statable_effects()) absent.state(one, 0);
  // Of Coulomb, viscous and Stribeck's torque alone the candidate laws are exact.
  const friction::FrictionModel* model = &s.sliding_model();
  const bool is_exact = dynamic_cast<const friction::LuGreFriction*>(model) != nullptr ||
                        dynamic_cast<const friction::StribeckFriction*>(model) != nullptr;
  if (!is_exact) absent.forget(effect::law_misfit);
  const auto* bristle = dynamic_cast<const friction::LuGreFriction*>(s.presliding.get());
  const bool is_fitted = bristle != nullptr && bristle->parameters().stribeck_power == 2 &&
                         bristle->parameters().damping_speed_rad_s == 0;
  if (!is_fitted) absent.forget(effect::contact_misfit);
  constexpr double slow = 24;  // periods in a turn of the joint, up to which means show a ripple
  for (const Noise::Ripple& ripple : s.noise.ripple) {
    if (ripple.amplitude_Nm == 0 || ripple.periods_per_turn * s.gear_ratio > slow) continue;
    for (const joint::Effect& one :
         {effect::harmonics, effect::smooth_over_angle, effect::torque_over_turn}) {
      absent.forget(one);
    }
  }
  return absent;
}

double torque_of_angle_Nm(const Scenario& s, double q_rad) {
  const double away = q_rad - s.load.q_peak_rad();
  return s.effects.spring_Nm_rad * away + s.effects.twice_the_angle_Nm * std::cos(2 * away);
}

void put_together(const Scenario& s, const SessionClock& clock, MovedJoint& moved) {
  const JointEffects& e = s.effects;
  const double n = s.gear_ratio;
  joint::Recording& r = moved.recording;
  const bool is_foreign = moved.run > 0 && moved.run == e.foreign_run;
  const double of_joint = is_foreign ? e.foreign_friction : 1;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const double share =
        clock.whole_s > 0 ? (clock.start_s + r.t_s[i] - r.t_s.front()) / clock.whole_s : 0;
    const double q = load_angle(s, r.q_rad[i]);
    const double load = load_torque_Nm(s, q, r.role) / n;
    const double contact = r.torque_Nm[i];
    const double way = built_up(contact, moved.static_Nm);
    const double turned = r.dq_rad_s[i] != 0 ? (r.dq_rad_s[i] < 0 ? -1 : 1) : way;
    const double sliding = contact + bend_of_viscous_Nm(e, n * r.dq_rad_s[i]);
    const double friction =
        of_joint * (scaled_friction(s, r.q_rad[i], sliding, share) +
                    e.load_friction * std::abs(load) * way + e.gear_loss * std::abs(load) * turned);
    const double ddq = moved.ddq_rad_s2[i];
    r.torque_Nm[i] =
        s.motor_inertia_kgm2 * n * ddq + friction +
        (s.arm_inertia_kgm2 * ddq + load_torque_Nm(s, q, r.role)) / n + torque_of_angle_Nm(s, q) +
        e.torque_offset_Nm + e.offset_drift_Nm * share -
        e.taken_off * friction * std::tanh(n * std::abs(r.dq_rad_s[i]) / e.taken_off_from_rad_s) -
        left_out_Nm(s, r.q_rad[i], r.role);
  }
}

double load_torque_Nm(const Scenario& s, double q_rad, joint::Role role) {
  const bool has_new_tool = role == joint::Role::constant_speed || role == joint::Role::break_away;
  return s.load.torque_Nm(q_rad) * (has_new_tool ? 1 + s.effects.tool_gravity : 1);
}

double left_out_Nm(const Scenario& s, double q_rad, joint::Role role) {
  return s.effects.gravity_left_out * load_torque_Nm(s, q_rad, role) / s.gear_ratio;
}

FrictionChange friction_change(const Scenario& s, double q_rad, double direction,
                               double share_of_session, joint::Role role) {
  const double load = std::abs(load_torque_Nm(s, load_angle(s, q_rad), role)) / s.gear_ratio;
  return {scaled_friction(s, q_rad, direction, share_of_session) / direction,
          (s.effects.load_friction + s.effects.gear_loss) * load};
}

double friction_factor_of_ramp(const Scenario& s, double q_rad, double direction) {
  const double static_Nm = std::abs(s.presliding->steady_torque_Nm(1e-9));
  const FrictionChange change = friction_change(s, q_rad, direction, 1, joint::Role::break_away);
  return static_Nm > 0 ? change.factor + change.of_load_Nm / static_Nm : change.factor;
}

namespace {

/// What was true so much earlier, between samples along a straight line.
void delay(std::vector<double>& signal, double samples) {
  const std::vector<double> before = signal;
  const auto last = static_cast<double>(before.size() - 1);
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const double at = std::clamp(static_cast<double>(i) - samples, 0.0, last);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, before.size() - 1);
    signal[i] = std::lerp(before[below], before[above], at - static_cast<double>(below));
  }
}

/// Second-order low pass, exactly for a signal that runs along straight lines between its samples;
/// it has rested at its first value before.
/// @param frequency undamped, in radians per sample. @param quality > 0.5.
void resonate(std::vector<double>& signal, double frequency, double quality) {
  const double decay = frequency / (2 * quality);
  const double swing = std::sqrt(frequency * frequency - decay * decay);
  const double left = std::exp(-decay);
  const double behind = 1 / (quality * frequency);  // by which it follows a straight line
  double input = signal.front();
  double value = input;
  double slope = 0;
  for (double& sample : signal) {
    const double rise = sample - input;
    const double away = value - (input - rise * behind);
    const double speed = slope - rise;
    const double by_cos = left * std::cos(swing);
    const double by_sin = left * std::sin(swing) / swing;
    value = sample - rise * behind + away * by_cos + (speed + decay * away) * by_sin;
    slope = rise + speed * by_cos - (decay * speed + frequency * frequency * away) * by_sin;
    input = sample;
    sample = value;
  }
}

void add_coloured(std::vector<double>& signal, double sd, double time_s, double sample_rate_Hz,
                  statistics::RandomStream& random) {
  const double keep = std::exp(-1 / (time_s * sample_rate_Hz));
  double state = sd * random.normal();
  for (double& value : signal) {
    value += state;
    state = keep * state + sd * std::sqrt(1 - keep * keep) * random.normal();
  }
}

void hold(std::vector<double>& signal, double percent, statistics::RandomStream& random) {
  constexpr std::size_t burst = 50;
  for (std::size_t i = burst; i + burst < signal.size(); i += burst) {
    if (100 * random.uniform() < percent)
      std::fill_n(signal.begin() + static_cast<std::ptrdiff_t>(i), burst, signal[i - 1]);
  }
}

/// Messages that do not come: their rows repeat the last one in all channels.
void repeat_rows(joint::Recording& r, double percent, statistics::RandomStream& random) {
  constexpr std::size_t burst = 20;
  for (std::size_t i = burst; i + burst < r.size(); i += burst) {
    if (100 * random.uniform() >= percent) continue;
    for (std::vector<double>* signal : {&r.q_rad, &r.dq_rad_s, &r.torque_Nm}) {
      std::fill_n(signal->begin() + static_cast<std::ptrdiff_t>(i), burst, (*signal)[i - 1]);
    }
  }
}

void lose_rows(joint::Recording& r, double percent, statistics::RandomStream& random) {
  std::vector<bool> is_lost(r.size());
  for (std::size_t i = 1; i + 1 < r.size(); ++i) is_lost[i] = 100 * random.uniform() < percent;
  for (std::vector<double>* signal :
       {&r.t_s, &r.q_rad, &r.dq_rad_s, &r.torque_Nm, &r.z_rad, &r.dz_rad_s, &r.temperature_C}) {
    if (signal->size() != is_lost.size()) continue;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < is_lost.size(); ++i) {
      if (!is_lost[i]) (*signal)[kept++] = (*signal)[i];
    }
    signal->resize(kept);
  }
}

/// What draws random numbers: each kind has streams of its own, so that none changes another's.
enum class Draw : std::uint64_t {
  torque = 0,
  touch = std::uint64_t{1} << 29U,
  tare = std::uint64_t{1} << 30U,
  log = std::uint64_t{1} << 31U,
  repeats = std::uint64_t{3} << 30U,
};

/// Random numbers of the effects alone.
statistics::RandomStream effects_stream(std::uint64_t seed, std::uint64_t stream, Draw draw) {
  constexpr std::uint64_t behind_those_of_noise = std::uint64_t{1} << 33U;
  return {seed, behind_those_of_noise + static_cast<std::uint64_t>(draw) + stream};
}

/// A hand that leans on the arm: in each sweep, and in every third run or so.
void touch(joint::Recording& r, double torque_Nm, statistics::RandomStream random) {
  constexpr double usual_s = 1.5;
  constexpr double share_of_runs = 1.0 / 3;
  const double begins = random.uniform();
  const bool is_of_some = random.uniform() < share_of_runs;
  const bool is_sweep = r.role == joint::Role::rough_sweep || r.role == joint::Role::precise_sweep;
  if (!is_sweep && !(r.role == joint::Role::constant_speed && is_of_some)) return;
  const double whole_s = r.t_s.back() - r.t_s.front();
  const double lasts_s = std::min(usual_s, whole_s / 4);
  const double from_s = r.t_s.front() + begins * (whole_s - lasts_s);
  for (std::size_t i = 0; i < r.size(); ++i) {
    const double passed = (r.t_s[i] - from_s) / lasts_s;
    if (passed > 0 && passed < 1) r.torque_Nm[i] += torque_Nm * std::sin(pi * passed);
  }
}

/// Torques that a sensor feels beside the joint's own.
void add_further_torques(joint::Recording& r, const LogEffects& e, std::uint64_t seed,
                         std::uint64_t stream, statistics::RandomStream& random) {
  const double vibration_phase = 2 * pi * random.uniform();
  const double neighbour_phase = 2 * pi * random.uniform();
  for (std::size_t i = 0; i < r.size(); ++i) {
    r.torque_Nm[i] +=
        e.vibration_Nm * std::sin(2 * pi * e.vibration_Hz * r.t_s[i] + vibration_phase) +
        e.neighbour_Nm * std::sin(2 * pi * e.neighbour_Hz * r.t_s[i] + neighbour_phase);
    if (e.crosstalk_Nm == 0) continue;
    const double angle = r.q_rad[i] - e.crosstalk_zero_rad;
    r.torque_Nm[i] += e.crosstalk_Nm * (std::sin(angle) + std::sin(2 * angle));
  }
  if (e.touch_Nm != 0) touch(r, e.touch_Nm, effects_stream(seed, stream, Draw::touch));
}

/// What lies between the torque and the log in time.
void smooth_torque(std::vector<double>& torque, const LogEffects& e, double sample_rate_Hz) {
  if (e.torque_filter_Hz > 0) {
    statistics::low_pass(torque, sample_rate_Hz / (2 * pi * e.torque_filter_Hz));
  }
  if (e.resonance_Hz > 0) {
    resonate(torque, 2 * pi * e.resonance_Hz / sample_rate_Hz, e.resonance_quality);
  }
  statistics::moving_mean(torque, e.torque_mean_s * sample_rate_Hz);
  if (e.torque_delay_s != 0) delay(torque, e.torque_delay_s * sample_rate_Hz);
}

/// Logged over true, in a recording of that role.
double scale_of(const LogEffects& e, joint::Role role) {
  if (role == joint::Role::oscillation) return e.torque_scale * e.scale_of_loops;
  if (role == joint::Role::constant_speed) return e.torque_scale * e.scale_of_runs;
  return e.torque_scale;
}

/// What is logged for a torque: out of proportion, with a dead zone, at another scale.
double logged_torque_Nm(double true_Nm, const LogEffects& e, joint::Role role) {
  constexpr double edge = 0.1;  // of a dead zone
  double value = true_Nm;
  value *= 1 + e.saturation_per_Nm2 * value * value + e.saturation_per_Nm * std::abs(value);
  if (e.dead_zone_Nm > 0) {
    value += e.dead_zone_Nm * std::clamp(value / (edge * e.dead_zone_Nm), -1.0, 1.0);
  }
  return value * scale_of(e, role);
}

void add_coulomb_model(joint::Recording& r, const LogEffects& e) {
  for (std::size_t i = 0; i < r.size(); ++i) {
    r.torque_Nm[i] += e.coulomb_model_Nm * std::tanh(r.dq_rad_s[i] / e.coulomb_model_from_rad_s);
  }
}

}  // namespace

void add_torque_effects(joint::Recording& r, const LogEffects& e, double sample_rate_Hz,
                        std::uint64_t seed, std::uint64_t stream) {
  if (!e.any() || r.t_s.empty()) return;
  statistics::RandomStream random = effects_stream(seed, stream, Draw::torque);
  add_further_torques(r, e, seed, stream, random);
  smooth_torque(r.torque_Nm, e, sample_rate_Hz);
  if (e.coloured_Nm > 0)
    add_coloured(r.torque_Nm, e.coloured_Nm, e.coloured_time_s, sample_rate_Hz, random);
  for (double& value : r.torque_Nm) value = logged_torque_Nm(value, e, r.role);
  if (e.coulomb_model_Nm != 0) add_coulomb_model(r, e);
  if (e.tare_Nm == 0) return;
  const double tare_Nm = e.tare_Nm * effects_stream(seed, stream, Draw::tare).normal();
  for (double& value : r.torque_Nm) value += tare_Nm;
}

void add_log_effects(joint::Recording& r, const LogEffects& e, std::uint64_t seed,
                     std::uint64_t stream) {
  if (!e.any() || r.t_s.empty()) return;
  statistics::RandomStream random = effects_stream(seed, stream, Draw::log);
  std::vector<double>& torque = r.torque_Nm;
  for (double& value : torque) {
    if (e.outlier_percent > 0 && 100 * random.uniform() < e.outlier_percent) {
      value += random.uniform() < 0.5 ? -e.outlier_Nm : e.outlier_Nm;
    }
    if (e.torque_limit_Nm > 0) value = std::clamp(value, -e.torque_limit_Nm, e.torque_limit_Nm);
  }
  if (e.held_percent > 0) hold(torque, e.held_percent, random);
  if (e.repeated_percent > 0) {
    statistics::RandomStream repeats = effects_stream(seed, stream, Draw::repeats);
    repeat_rows(r, e.repeated_percent, repeats);
  }
  if (100 * random.uniform() < e.dead_percent)
    std::fill(torque.begin(), torque.end(), torque.front());
  for (double& speed : r.dq_rad_s) speed *= e.speed_scale;
  const bool is_rough = r.role == joint::Role::rough_sweep;
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (!is_rough) r.q_rad[i] += e.homed_anew_rad;
    if (is_rough && i > r.size() / 3) r.q_rad[i] += e.jump_rad;
  }
  if (e.lost_percent > 0) lose_rows(r, e.lost_percent, random);
  if (e.wrap_rad > 0) {
    for (double& q : r.q_rad) q -= e.wrap_rad * std::round(q / e.wrap_rad);
  }
  if (e.mirrored_angle) {
    for (double& q : r.q_rad) q = -q;
    for (double& speed : r.dq_rad_s) speed = -speed;
  }
  if (e.mirrored_torque) {
    for (double& value : torque) value = -value;
  }
}

}  // namespace tribolog::simulate
