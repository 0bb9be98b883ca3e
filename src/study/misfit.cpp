#include "study/misfit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/parallel_for.h"
#include "friction/catalogue.h"
#include "friction/lugre.h"
#include "identify/identify.h"
#include "joint/degrees.h"
#include "simulate/simulate_joint.h"
#include "statistics/distributions.h"
#include "study/study.h"

namespace tribolog::study {
namespace {

using joint::Quantity;
using simulate::Scenario;
using LuGre = friction::LuGreFriction::Parameters;

constexpr std::size_t joints_of_the_study = 4;
constexpr double no_truth = std::numeric_limits<double>::quiet_NaN();

const LuGre& lugre_of(const Scenario& s) {
  return dynamic_cast<const friction::LuGreFriction&>(*s.presliding).parameters();
}

double motor_gravity(const Scenario& s) { return s.load.amplitude_Nm() / s.gear_ratio; }

double friction_of(const Scenario& s) { return std::abs(s.presliding->steady_torque_Nm(1e-9)); }

void set_lugre(Scenario& s, const LuGre& p) {
  s.presliding = std::make_shared<friction::LuGreFriction>(p);
}

void set_contact(Scenario& s, const char* model) {
  const LuGre& p = lugre_of(s);
  s.presliding = friction::dynamic_friction_model(model).matched(
      {p.bristle_stiffness_Nm_rad, p.bristle_damping_Nms_rad, p.viscous_Nms_rad, p.coulomb_Nm,
       p.static_Nm, p.stribeck_speed_rad_s});
}

void scale_amplitude(Scenario& s, double factor) {
  if (s.oscillation) s.oscillation->amplitude_rad *= factor;
  for (simulate::OscillationExperiment& e : s.further_oscillations) e.amplitude_rad *= factor;
}

/// Loops and ramps at one motor angle, that of the largest friction: from there nothing averages.
void record_at_largest_friction(Scenario& s) {
  s.effects.phase_of_motor_angle_rad =
      -s.effects.periods_per_motor_turn * s.gear_ratio * s.break_away->centre_rad;
  const double here = s.oscillation->centre_rad;
  std::erase_if(s.further_oscillations,
                [&](const simulate::OscillationExperiment& e) { return e.centre_rad != here; });
}

/// A joint from the numbers that tell it from others; its experiments fit them.
struct JointSketch {
  double gear_ratio;
  double motor_inertia_kgm2;
  double mass_kg, distance_m, q_peak_deg;
  LuGre friction;
  double rate_Hz;
  double white_Nm, torque_step_Nm, encoder_counts;
  double fastest_rad_s;  ///< Motor side.
};

Scenario sketched(const JointSketch& j) {
  Scenario s;
  s.name = "joint of the misfit study";
  s.robot = s.serial = "simulated";
  s.joint = std::string("1");  // GCC 12 warns of an overlap where the literal is assigned
  s.log.keeps_friction_secret = true;
  s.gear_ratio = j.gear_ratio;
  s.motor_inertia_kgm2 = j.motor_inertia_kgm2;
  s.arm_inertia_kgm2 = j.mass_kg * j.distance_m * j.distance_m;
  s.load = joint::GravityLoad(j.mass_kg, j.distance_m, j.q_peak_deg * joint::rad_per_degree);
  set_lugre(s, j.friction);
  const double n = j.gear_ratio;
  const double q = s.load.q_peak_rad();
  const double range = 70 * joint::rad_per_degree;
  simulate::SweepExperiment sweep{q - range, q + range * 0.9, 0};
  sweep.speed_rad_s = 4 * joint::rad_per_degree;
  sweep.sample_rate_Hz = j.rate_Hz / 4;
  s.rough_sweep = sweep;
  const double bristle = j.friction.static_Nm / j.friction.bristle_stiffness_Nm_rad;
  simulate::OscillationExperiment loop{q, 5 * bristle / n, 1, 10, j.rate_Hz, false};
  auto loops = simulate::spread_over_motor_turn(loop, n > 1 ? 4 : 1, n);
  // A faster, larger one shows how friction falls with speed.
  simulate::OscillationExperiment large = loop;
  large.amplitude_rad *= 20;
  loops.push_back(large);
  s.oscillation = loops.front();
  s.further_oscillations.assign(loops.begin() + 1, loops.end());
  simulate::ConstantSpeedExperiment runs;
  constexpr int speeds = 12;
  const double slowest = std::min(0.15 * j.friction.stribeck_speed_rad_s, j.fastest_rad_s / 100);
  for (int k = 0; k < speeds; ++k) {
    runs.motor_speeds_rad_s.push_back(
        slowest * std::pow(j.fastest_rad_s / slowest, static_cast<double>(k) / (speeds - 1)));
  }
  runs.centre_rad = q;
  runs.largest_travel_rad = range;
  runs.longest_plateau_s = 3;
  runs.acceleration_rad_s2 = 20;
  runs.sample_rate_Hz = j.rate_Hz / 2;
  s.constant_speed = runs;
  simulate::BreakAwayExperiment ramps;
  ramps.centre_rad = q;
  ramps.largest_torque_Nm = 1.6 * j.friction.static_Nm;
  ramps.rate_Nm_s = ramps.largest_torque_Nm / 3;
  ramps.largest_travel_rad = 20 * bristle / n;
  ramps.repeats = 3;
  ramps.sample_rate_Hz = j.rate_Hz;
  s.break_away = ramps;
  s.noise.torque_white_Nm = j.white_Nm;
  s.noise.torque_step_Nm = j.torque_step_Nm;
  s.noise.encoder_counts_per_turn = j.encoder_counts;
  s.noise.speed_filter_Hz = 100;
  return s;
}

std::vector<Disturbance> all_disturbances() {
  return {
      {"torque_delay",
       {0.0005, 0.002, 0.005},
       [](Scenario& s, double x) { s.noise.effects.torque_delay_s = x; },
       {"cause.lag"}},
      {"angle_delay",
       {0.0005, 0.002, 0.005},
       [](Scenario& s, double x) { s.noise.effects.torque_delay_s = -x; },
       {"cause.lag"}},
      {"torque_filter",
       {100, 50, 20},
       [](Scenario& s, double x) { s.noise.effects.torque_filter_Hz = x; },
       {"cause.lag"}},
      {"elasto_plastic_contact",
       {1, 2, 0.7},
       [](Scenario& s, double x) {
         set_contact(s, "elasto_plastic");
         scale_amplitude(s, x);
       },
       {"cause.other_contact"}},
      {"maxwell_slip_contact",
       {1, 2, 0.7},
       [](Scenario& s, double x) {
         set_contact(s, "gms");
         scale_amplitude(s, x);
       },
       {"cause.other_contact"}},
      {"leuven_contact",
       {1, 2, 0.7},
       [](Scenario& s, double x) {
         set_contact(s, "leuven");
         scale_amplitude(s, x);
       },
       {"cause.other_contact"}},
      {"gear_loss",
       {0.005, 0.02, 0.05},
       [](Scenario& s, double x) { s.effects.gear_loss = x; },
       {"cause.load"}},
      {"load_friction",
       {0.01, 0.03, 0.1},
       [](Scenario& s, double x) { s.effects.load_friction = x; },
       {"cause.load"}},
      {"direction_asymmetry",
       {0.01, 0.05, 0.2},
       [](Scenario& s, double x) { s.effects.direction_asymmetry = x; },
       {"cause.asymmetry"}},
      {"torque_offset",
       {0.001, 0.005, 0.02},
       [](Scenario& s, double x) { s.effects.torque_offset_Nm = x * motor_gravity(s); },
       {"cause.offset", "cause.asymmetry"}},
      {"offset_drift",
       {0.002, 0.01, 0.03},
       [](Scenario& s, double x) { s.effects.offset_drift_Nm = x * motor_gravity(s); },
       {"cause.drift", "cause.offset"}},
      {"warm_up",
       {0.05, 0.1, 0.2},
       [](Scenario& s, double x) { s.effects.warm_up = x; },
       {"cause.drift"}},
      {"friction_by_angle",
       {0.02, 0.05, 0.2},
       [](Scenario& s, double x) { s.effects.friction_by_angle = x; },
       {"cause.angle", "cause.load"}},
      {"friction_by_motor_angle",
       {0.02, 0.05, 0.1},
       [](Scenario& s, double x) {
         s.effects.friction_by_motor_angle = x;
         record_at_largest_friction(s);
       },
       {"cause.friction_by_motor_angle", "cause.angle"}},
      {"gear_windup",
       {0.1, 0.5, 1},
       [](Scenario& s, double x) { s.effects.gear_windup_rad = x * joint::rad_per_degree; },
       {"cause.elastic_gear", "cause.lag"}},
      {"spring",
       {0.002, 0.01, 0.05},
       [](Scenario& s, double x) { s.effects.spring_Nm_rad = x * motor_gravity(s); },
       {"cause.spring", "cause.negative_twist", "cause.torque_of_angle"}},
      {"twice_the_angle",
       {0.002, 0.01, 0.05},
       [](Scenario& s, double x) { s.effects.twice_the_angle_Nm = x * motor_gravity(s); },
       {"cause.torque_of_angle", "cause.offset", "cause.saturation_or_offset"}},
      {"late_stribeck_dip",
       {2, 5, 10},
       [](Scenario& s, double x) {
         LuGre p = lugre_of(s);
         const double slowest = s.constant_speed->motor_speeds_rad_s.front();
         p.stribeck_speed_rad_s *= x;
         set_lugre(s, p);
         s.constant_speed->motor_speeds_rad_s.front() = slowest;
       },
       {"cause.stribeck", "curve_model"}},
      {"stribeck_power",
       {1, 1.5, 3},
       [](Scenario& s, double x) {
         LuGre p = lugre_of(s);
         p.stribeck_power = x;
         set_lugre(s, p);
       },
       {"cause.stribeck_exponent", "cause.stribeck"}},
      {"damping_fall",
       {1, 0.6, 0.3},  // of the loops' peak speed
       [](Scenario& s, double x) {
         LuGre p = lugre_of(s);
         p.damping_speed_rad_s = x * s.gear_ratio * 2 * std::numbers::pi *
                                 s.oscillation->frequency_Hz * s.oscillation->amplitude_rad;
         set_lugre(s, p);
       },
       {"cause.damping_falls", "cause.other_contact"}},
      {"friction_taken_off",
       {0.1, 0.4, 0.8},
       [](Scenario& s, double x) {
         s.effects.taken_off = x;
         s.effects.taken_off_from_rad_s = 0.1 * lugre_of(s).stribeck_speed_rad_s;
       },
       {"cause.runs_against_ramps", "cause.runs_against_loops", "cause.friction_taken_off"}},
      {"convex_viscous",
       {1.2, 1.5, 1.8},
       [](Scenario& s, double x) {
         s.effects.viscous_exponent = x;
         s.effects.bent_viscous_Nms_rad = lugre_of(s).viscous_Nms_rad;
         s.effects.bent_viscous_rad_s = s.constant_speed->motor_speeds_rad_s.back();
       },
       {"curve_model.viscous_not_linear", "cause.viscous"}},
      {"second_harmonic",
       {0.01, 0.03, 0.1},
       [](Scenario& s, double x) { s.effects.second_harmonic = x; },
       {"cause.motion"}},
      {"third_harmonic",
       {0.01, 0.03, 0.1},
       [](Scenario& s, double x) { s.effects.third_harmonic = x; },
       {"cause.motion"}},
      {"coloured_noise",
       {1, 3, 10},
       [](Scenario& s, double x) {
         s.noise.effects.coloured_Nm = x * s.noise.torque_white_Nm;
         s.noise.effects.coloured_time_s = 0.1;
       },
       {"cause.coloured_noise"}},
      {"ripple",
       {0.003, 0.01, 0.03},
       [](Scenario& s, double x) {
         const double a = x * motor_gravity(s);
         s.noise.ripple = {{a, 1, 0}, {a, 6, 0}};
       },
       {"cause.ripple", "check.torque_ripple", "positions."}},
      {"vibration",
       {0.003, 0.01, 0.03},
       [](Scenario& s, double x) {
         s.noise.effects.vibration_Nm = x * motor_gravity(s);
         s.noise.effects.vibration_Hz = 7.3;
       },
       {"cause.vibration"}},
      {"other_joint_moves",
       {0.01, 0.05, 0.2},
       [](Scenario& s, double x) {
         s.noise.effects.neighbour_Nm = x * motor_gravity(s);
         s.noise.effects.neighbour_Hz = 0.13;
       },
       {"cause.other_joint", "cause.drift", "cause.vibration"}},
      {"torque_constant",
       {1.02, 1.1, 1.5},
       [](Scenario& s, double x) { s.noise.effects.torque_scale = x; },
       {"budget."},
       {},
       true},
      {"torque_saturates",
       {0.003, 0.01, 0.04},
       [](Scenario& s, double x) {
         s.noise.effects.saturation_per_Nm2 = x / std::pow(motor_gravity(s), 2);
       },
       {"cause.torque_saturates", "cause.saturation_or_offset", "cause.load"}},
      {"torque_grows_out_of_proportion",
       {0.005, 0.02, 0.05},
       [](Scenario& s, double x) { s.noise.effects.saturation_per_Nm = x / motor_gravity(s); },
       {"cause.torque_saturates", "cause.saturation_or_offset", "cause.load"}},
      {"dead_zone",
       {0.003, 0.01, 0.03},
       [](Scenario& s, double x) { s.noise.effects.dead_zone_Nm = x * motor_gravity(s); },
       {"cause.dead_zone", "cause.offset"}},
      {"torque_limit",
       {0.98, 0.9, 0.8},
       [](Scenario& s, double x) {
         s.noise.effects.torque_limit_Nm = x * (motor_gravity(s) + friction_of(s));
       },
       {"check.torque_saturation"}},
      {"torque_outliers",
       {0.05, 0.5, 5},
       [](Scenario& s, double x) {
         s.noise.effects.outlier_percent = x;
         s.noise.effects.outlier_Nm = 5 * friction_of(s);
       },
       {"cause.outliers", "check.torque_outliers"}},
      {"torque_stuck",
       {1, 5, 20},
       [](Scenario& s, double x) { s.noise.effects.held_percent = x; },
       {"check.torque_alive", "check.torque_held"}},
      {"torque_dead",
       {10, 40, 100},
       [](Scenario& s, double x) { s.noise.effects.dead_percent = x; },
       {"check.torque_alive"}},
      {"torque_step",
       {0.05, 0.2, 0.5},
       [](Scenario& s, double x) { s.noise.torque_step_Nm = x * friction_of(s); },
       {"check.torque_step"}},
      {"coarse_encoder",
       {20, 8, 3},
       [](Scenario& s, double x) {
         const LuGre& p = lugre_of(s);
         const double bristle = p.static_Nm / p.bristle_stiffness_Nm_rad;
         s.noise.encoder_counts_per_turn = 2 * std::numbers::pi / (bristle / x);
       },
       {"check.encoder_step"}},
      {"angle_jumps",
       {0.1, 0.3, 1},
       [](Scenario& s, double x) { s.noise.effects.jump_rad = x * joint::rad_per_degree; },
       {"check.angle_jumps"}},
      {"homed_anew",
       {0.2, 0.5, 2},
       [](Scenario& s, double x) { s.noise.effects.homed_anew_rad = x * joint::rad_per_degree; },
       {"cause.angle_of_runs", "cause.angle_of_precise_sweep", "check.oscillation_at_peak"}},
      {"speed_scale",
       {0.9, 0.5, 2},
       [](Scenario& s, double x) { s.noise.effects.speed_scale = x; },
       {"check.speed_scale"}},
      {"small_oscillation",
       {0.3, 0.15, 0.05},
       [](Scenario& s, double x) {
         scale_amplitude(s, x);
         s.further_oscillations.pop_back();
         s.break_away.reset();
       },
       {"check.oscillation_slides", "lugre."}},
      {"one_direction",
       {1, 2, 3},
       [](Scenario& s, double x) {
         if (x != 2) s.constant_speed->both_directions = false;
         if (x != 1) s.rough_sweep->both_directions = false;
       },
       {"check.run_directions", "check.sweep_directions"}},
      {"few_speeds_below_dip",
       {1, 2, 3},
       [](Scenario& s, double x) {
         auto& speeds = s.constant_speed->motor_speeds_rad_s;
         speeds.erase(speeds.begin(), speeds.begin() + static_cast<std::ptrdiff_t>(2 * x));
       },
       {"curve_model", "cause.stribeck"}},
      {"jittered_clock",
       {0.0002, 0.001, 0.003},
       [](Scenario& s, double x) { s.noise.clock_jitter_s = x; },
       {"cause.false_stamps", "check.clock_jitter"}},
      {"no_gravity",
       {0.05, 0.01, 0.001},
       [](Scenario& s, double x) {
         s.load = joint::GravityLoad(x * friction_of(s) * s.gear_ratio / (9.81 * 0.1), 0.1,
                                     s.load.q_peak_rad());
       },
       {"cause.no_gravity"}},
      {"mirrored",
       {1, 2, 3},
       [](Scenario& s, double x) {
         s.noise.effects.mirrored_angle = x != 2;
         s.noise.effects.mirrored_torque = x != 1;
       },
       {"check.friction_dissipates"},
       3},
  };
}

/// What an error-free identification would find, by the verdict's keys; SI, motor side.
std::map<Quantity, double> truths_of(const Scenario& undisturbed, const Scenario& laid) {
  const LuGre& p = lugre_of(undisturbed);
  double q_peak = laid.load.q_peak_rad();
  if (laid.noise.effects.mirrored_angle) q_peak = -q_peak;
  // With the torque mirrored too the joint is one whose peak lies where the trough was.
  if (laid.noise.effects.mirrored_angle && laid.noise.effects.mirrored_torque) {
    q_peak += std::numbers::pi;
  }
  const double n = laid.gear_ratio;
  std::map<Quantity, double> t{
      {Quantity::cog_angle, q_peak},
      {Quantity::gravity_torque, motor_gravity(laid)},
      {Quantity::surrogate_mass,
       laid.load.amplitude_Nm() / (laid.load.gravity_m_s2() * laid.surrogate_distance_m)},
      {Quantity::break_away_torque, p.static_Nm},
      {Quantity::bristle_stiffness, p.bristle_stiffness_Nm_rad},
      {Quantity::bristle_damping, p.bristle_damping_Nms_rad},
      {Quantity::inertia, laid.motor_inertia_kgm2 + laid.arm_inertia_kgm2 / (n * n)},
      {Quantity::coulomb_torque, p.coulomb_Nm},
      {Quantity::stribeck_speed, p.stribeck_speed_rad_s},
      {Quantity::viscous_coefficient, p.viscous_Nms_rad}};
  if (const auto* now = dynamic_cast<const friction::LuGreFriction*>(laid.presliding.get())) {
    t[Quantity::stribeck_speed] = now->parameters().stribeck_speed_rad_s;
  }
  // A slope that goes on growing is none of the definition's.
  if (laid.effects.viscous_exponent != 1) t[Quantity::viscous_coefficient] = no_truth;
  const std::string model = laid.presliding->name();
  if (model != "lugre") t[Quantity::bristle_damping] = no_truth;
  return t;
}

bool names(const calibration::Judgement& judgement, const Disturbance& d) {
  const std::function<bool(const Statement&)> is_named = [&](const Statement& s) {
    for (const std::string& prefix : d.named_by) {
      if (s.code().text().starts_with(prefix)) return true;
    }
    return std::any_of(s.values().begin(), s.values().end(), [&](const StatedValue& v) {
      const auto* inside = std::get_if<std::vector<Statement>>(&v.value);
      return inside != nullptr && std::any_of(inside->begin(), inside->end(), is_named);
    });
  };
  return std::any_of(judgement.findings.begin(), judgement.findings.end(), is_named);
}

struct RunOutcome {
  std::vector<calibration::QuantityVerdict> quantities;
  bool named{};
};

/// Of a normal error, to be beyond its 95 % interval and beyond what matters.
/// @param half_width of the interval, in terms of what matters.
double chance_of_wrong(double half_width) {
  const double matters = half_width > 0 ? statistics::normal_975 / half_width
                                        : std::numeric_limits<double>::infinity();
  return std::erfc(std::max(matters, statistics::normal_975) / std::numbers::sqrt2);
}

MisfitCase run_misfit_case(const MisfitJoint& joint, const Disturbance* disturbance, double size,
                           const MisfitOptions& options) {
  Scenario laid = joint.scenario;
  if (disturbance != nullptr) disturbance->lay(laid, size);
  const std::vector<simulate::IdealRecording> ideal = simulate::simulate_ideal_joint(laid);
  MisfitCase out;
  out.joint = joint.key;
  if (disturbance != nullptr) out.disturbance = disturbance->key;
  out.size = size;
  out.runs = options.runs;
  out.has_cause = disturbance != nullptr && disturbance->sound_at != size;
  std::vector<RunOutcome> runs(options.runs);
  parallel_for(
      options.runs,
      [&](std::size_t run) {
        const simulate::Noise noise = noise_of_run(laid.noise, options.seed, run);
        std::vector<joint::Recording> logs = simulate::with_noise(ideal, noise, laid.gear_ratio);
        if (run == 0 && options.keep_logs) options.keep_logs(out, laid, logs);
        const joint::Dataset dataset = simulate::simulated_dataset(laid, std::move(logs));
        identify::IdentifyOptions how;
        how.resamples = options.resamples;
        how.seed = noise.seed;
        how.threads = 1;
        calibration::Calibration c = identify::identify(dataset, how);
        runs[run].named = out.has_cause && names(c.judgement, *disturbance);
        runs[run].quantities = std::move(c.judgement.quantities);
      },
      options.threads);
  const auto truths = truths_of(joint.scenario, laid);
  for (const auto& quantity : runs.front().quantities) {
    const auto truth = truths.find(quantity.quantity);
    if (truth == truths.end()) continue;
    MisfitQuantity q{quantity.quantity, truth->second};
    for (const RunOutcome& run : runs) {
      const auto it = std::find_if(run.quantities.begin(), run.quantities.end(),
                                   [&](const auto& one) { return one.quantity == q.quantity; });
      if (it == run.quantities.end() || !it->estimate ||
          it->verdict == calibration::Verdict::not_identifiable)
        continue;
      ++q.found;
      const bool is_usable = it->verdict == calibration::Verdict::usable;
      q.usable += is_usable ? 1 : 0;
      if (std::isnan(q.truth)) continue;
      const bool inside = it->estimate->low <= q.truth && q.truth <= it->estimate->high;
      double off = it->estimate->value - q.truth;
      if (q.quantity == Quantity::cog_angle) off = std::remainder(off, 2 * std::numbers::pi);
      off = std::abs(off) / bound_of(q.quantity, q.truth);
      const bool is_wrong = !inside && off > 1;
      q.inside += inside ? 1 : 0;
      q.wrong += is_wrong ? 1 : 0;
      q.wrong_usable += is_wrong && is_usable ? 1 : 0;
      if (!is_usable) continue;
      q.worst_usable = std::max(q.worst_usable, off);
      q.by_chance += chance_of_wrong(it->estimate->half_width() / bound_of(q.quantity, q.truth));
    }
    out.quantities.push_back(std::move(q));
  }
  for (const RunOutcome& run : runs) out.named += run.named ? 1 : 0;
  return out;
}

template <class Item>
std::vector<Item> picked(const std::vector<Item>& all, const std::vector<std::string>& keys,
                         const char* what) {
  if (keys.empty()) return all;
  std::vector<Item> out;
  std::vector<std::string> known;
  for (const Item& item : all) known.push_back(item.key);
  for (const std::string& key : keys) {
    const auto it =
        std::find_if(all.begin(), all.end(), [&](const Item& i) { return i.key == key; });
    if (it == all.end()) {
      throw std::invalid_argument(
          fmt::format("{} '{}' is none of these: {}", what, key, fmt::join(known, ", ")));
    }
    out.push_back(*it);
  }
  return out;
}

}  // namespace

const std::vector<Disturbance>& disturbances() {
  static const std::vector<Disturbance> all = all_disturbances();
  return all;
}

std::vector<MisfitJoint> misfit_joints() {
  return {
      {"geared_arm", sketched({100,
                               1e-4,
                               98.96,
                               0.4,
                               -22.23187,
                               {465.42, 0.7708, 0.001, 0.60, 0.88437633, 5},
                               1000,
                               0.02,
                               0.005,
                               131072,
                               300})},
      {"cobot_joint", sketched({101,
                                2.5e-4,
                                11.2,
                                0.45,
                                8.0,
                                {90, 0.12, 4e-4, 0.12, 0.16, 3},
                                500,
                                0.004,
                                0.001,
                                524288,
                                150})},
      {"direct_drive", sketched({1,
                                 0.05,
                                 12,
                                 0.32,
                                 -85.0,
                                 {3.0e4, 120, 3.0, 9.5, 11.5, 0.06},
                                 500,
                                 0.05,
                                 0.01,
                                 4194304,
                                 1.6})},
      {"small_servo", sketched({30,
                                1.2e-5,
                                0.49,
                                0.1,
                                31.0,
                                {1.1, 3e-3, 8e-5, 1.6e-3, 2.2e-3, 4},
                                250,
                                5e-5,
                                1e-5,
                                131072,
                                150})},
      // A big axis, a light wrist of much friction, and a gantry's fast axis with little.
      {"heavy_axis", sketched({185,
                               6e-3,
                               420,
                               0.9,
                               -64.0,
                               {2400, 3.0, 9e-3, 3.2, 4.4, 6},
                               250,
                               0.08,
                               0.02,
                               65536,
                               200})},
      {"harmonic_wrist", sketched({160,
                                   3e-5,
                                   3.1,
                                   0.11,
                                   47.0,
                                   {42, 0.03, 3e-5, 0.031, 0.042, 8},
                                   1000,
                                   4e-4,
                                   1e-4,
                                   1048576,
                                   400})},
      {"belt_drive", sketched({5,
                               4e-4,
                               2.4,
                               0.28,
                               -120.0,
                               {95, 0.08, 9e-4, 0.055, 0.066, 2},
                               2000,
                               3e-3,
                               5e-4,
                               1048576,
                               60})},
  };
}

double bound_of(joint::Quantity quantity, double truth) {
  static const std::map<Quantity, double> shares{{Quantity::gravity_torque, 0.001},
                                                 {Quantity::surrogate_mass, 0.001},
                                                 {Quantity::break_away_torque, 0.02},
                                                 {Quantity::coulomb_torque, 0.02},
                                                 {Quantity::bristle_stiffness, 0.02},
                                                 {Quantity::viscous_coefficient, 0.05},
                                                 {Quantity::stribeck_speed, 0.05},
                                                 {Quantity::bristle_damping, 0.25},
                                                 {Quantity::inertia, 0.25}};
  if (quantity == Quantity::cog_angle) return 0.05 * joint::rad_per_degree;
  return shares.at(quantity) * std::abs(truth);
}

std::vector<MisfitCase> run_misfit_study(const MisfitOptions& options,
                                         const MisfitProgress& progress) {
  std::vector<MisfitJoint> joints = picked(misfit_joints(), options.joints, "joint");
  std::vector<Disturbance> laid;
  if (!options.only_sound) {
    laid = picked(disturbances(), options.disturbances, "disturbance");
    if (options.joints.empty()) joints.resize(joints_of_the_study);
  }
  std::size_t all = 0;
  for (const Disturbance& d : laid) all += d.sizes.size() * joints.size();
  all += joints.size();
  std::vector<MisfitCase> out;
  const auto run = [&](const MisfitJoint& joint, const Disturbance* d, double size) {
    if (progress) {
      progress(fmt::format("{}, {} {:g}", joint.key, d == nullptr ? "sound" : d->key, size),
               out.size(), all);
    }
    out.push_back(run_misfit_case(joint, d, size, options));
  };
  for (const MisfitJoint& joint : joints) {
    run(joint, nullptr, 0);
    for (const Disturbance& d : laid) {
      for (const double size : d.sizes) run(joint, &d, size);
    }
  }
  return out;
}

}  // namespace tribolog::study
