#include "simulate/simulate_joint.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/requirements.h"
#include "base/statement.h"
#include "friction/lugre.h"
#include "simulate/bristle_integrator.h"
#include "simulate/drive_noise.h"
#include "simulate/forced_motion.h"
#include "simulate/model_portrait.h"
#include "simulate/motion.h"

namespace tribolog::simulate {

namespace {

joint::Recording empty_recording(std::string name, joint::Role role, std::size_t samples) {
  joint::Recording recording;
  recording.name = std::move(name);
  recording.role = role;
  recording.t_s.reserve(samples);
  recording.q_rad.reserve(samples);
  recording.dq_rad_s.reserve(samples);
  recording.torque_Nm.reserve(samples);
  recording.rows_read = samples;
  return recording;
}

/// LuGre's torque under a motion of the motor from rest, and its bristles on the way.
struct BristleResponse {
  std::vector<double> torque_Nm, z_rad, dz_rad_s;
};

BristleResponse bristle_response(const friction::LuGreFriction& lugre, const Motion& motor,
                                 double sample_rate_Hz, std::size_t samples) {
  BristleResponse out{std::vector<double>(samples), std::vector<double>(samples),
                      std::vector<double>(samples)};
  integrate_bristle(lugre, motor, 0.0, 1 / sample_rate_Hz, 0.0, out.z_rad, out.dz_rad_s);
  for (std::size_t i = 0; i < samples; ++i) {
    out.torque_Nm[i] = lugre.torque_Nm(out.z_rad[i], out.dz_rad_s[i],
                                       motor.speed(static_cast<double>(i) / sample_rate_Hz));
  }
  return out;
}

/// The dynamic model's under a motion of the motor from rest; the bristles of LuGre alone.
BristleResponse dynamic_response(const Scenario& s, const Motion& motor, double sample_rate_Hz,
                                 std::size_t samples) {
  const auto* lugre = dynamic_cast<const friction::LuGreFriction*>(s.presliding.get());
  if (lugre != nullptr) return bristle_response(*lugre, motor, sample_rate_Hz, samples);
  BristleResponse out{std::vector<double>(samples), {}, {}};
  std::vector<double> state = s.presliding->unloaded();
  friction_response(*s.presliding, motor, 0.0, 1 / sample_rate_Hz, state, out.torque_Nm);
  return out;
}

/// Friction torque of sliding, by the static law or by the dynamic model.
std::vector<double> sliding_torque(const Scenario& s, const Motion& joint, double sample_rate_Hz,
                                   std::size_t samples) {
  const MotorSide motor(joint, s.gear_ratio);
  if (!s.sliding) return dynamic_response(s, motor, sample_rate_Hz, samples).torque_Nm;
  std::vector<double> torque(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    torque[i] = s.sliding->torque_Nm(motor.speed(static_cast<double>(i) * (1 / sample_rate_Hz)));
  }
  return torque;
}

/// A motion in which the joint slides, from time 0 on.
MovedJoint sliding(const Scenario& s, const Motion& motion, std::size_t samples,
                   double sample_rate_Hz, std::string name, joint::Role role) {
  const std::vector<double> friction = sliding_torque(s, motion, sample_rate_Hz, samples);
  MovedJoint moved{empty_recording(std::move(name), role, samples), {}, 0, 0};
  joint::Recording& r = moved.recording;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / sample_rate_Hz;
    r.t_s.push_back(t);
    r.q_rad.push_back(motion.angle(t));
    r.dq_rad_s.push_back(motion.speed(t));
    r.torque_Nm.push_back(friction[i]);
    moved.ddq_rad_s2.push_back(motion.acceleration(t));
  }
  return moved;
}

/// A there-and-back travel.
MovedJoint travel(const Scenario& s, const TravelMotion::Plan& plan, double sample_rate_Hz,
                  std::string name, joint::Role role) {
  require_positive(sample_rate_Hz, "sample_rate_Hz", "Hz");
  const TravelMotion motion(plan);
  const auto samples =
      static_cast<std::size_t>(std::floor(motion.duration_s() * sample_rate_Hz)) + 1;
  return sliding(s, motion, samples, sample_rate_Hz, std::move(name), role);
}

MovedJoint sweep(const Scenario& s, const SweepExperiment& e, std::string name, joint::Role role) {
  return travel(s, {e.from_rad, e.to_rad, e.speed_rad_s, e.acceleration_rad_s2, e.both_directions},
                e.sample_rate_Hz, std::move(name), role);
}

std::size_t samples_of_cycles(double cycles, double frequency_Hz, double sample_rate_Hz) {
  require_positive(sample_rate_Hz, "sample_rate_Hz", "Hz");
  if (!(cycles >= 1)) throw Refusal({"scenario.too_few_cycles", {{"cycles", cycles}}});
  return static_cast<std::size_t>(std::floor(cycles / frequency_Hz * sample_rate_Hz + 1e-9)) + 1;
}

MovedJoint sine_sweep(const Scenario& s, const SineSweepExperiment& e) {
  require_positive(e.amplitude_rad, "amplitude", "rad");
  const HarmonicMotion motion(e.centre_rad, e.frequency_Hz, {{-e.amplitude_rad, 0}});
  return sliding(s, motion, samples_of_cycles(e.cycles, e.frequency_Hz, e.sample_rate_Hz),
                 e.sample_rate_Hz, "sine_sweep.csv", joint::Role::rough_sweep);
}

HarmonicMotion oscillating_motor(const Scenario& s, const OscillationExperiment& e) {
  const double a = s.gear_ratio * e.amplitude_rad;
  std::vector<HarmonicMotion::Harmonic> harmonics{{0, a}};
  if (s.effects.second_harmonic != 0 || s.effects.third_harmonic != 0) {
    harmonics.push_back({0, a * s.effects.second_harmonic});
    harmonics.push_back({0, a * s.effects.third_harmonic});
  }
  return {s.gear_ratio * e.centre_rad, e.frequency_Hz, std::move(harmonics)};
}

MovedJoint oscillation(const Scenario& s, const OscillationExperiment& e, std::string name) {
  require_positive(e.amplitude_rad, "amplitude", "rad");
  const double n = s.gear_ratio;
  const HarmonicMotion motor = oscillating_motor(s, e);
  const std::size_t samples = samples_of_cycles(e.cycles, e.frequency_Hz, e.sample_rate_Hz);
  BristleResponse response = dynamic_response(s, motor, e.sample_rate_Hz, samples);
  MovedJoint moved{empty_recording(std::move(name), joint::Role::oscillation, samples),
                   {},
                   std::abs(s.presliding->steady_torque_Nm(1e-9)),
                   0};
  joint::Recording& r = moved.recording;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / e.sample_rate_Hz;
    const double w = motor.speed(t);
    r.t_s.push_back(t);
    r.q_rad.push_back(motor.angle(t) / n);
    r.dq_rad_s.push_back(w / n);
    moved.ddq_rad_s2.push_back(motor.acceleration(t) / n);
  }
  r.torque_Nm = std::move(response.torque_Nm);
  if (e.record_bristle) {
    r.z_rad = std::move(response.z_rad);
    r.dz_rad_s = std::move(response.dz_rad_s);
  }
  return moved;
}

MovedJoint constant_speed(const Scenario& s, const ConstantSpeedExperiment& e, std::size_t index) {
  const double motor_speed = e.motor_speeds_rad_s[index];
  require_positive(motor_speed, "motor_speeds_rad_s", "rad/s");
  require_positive(e.largest_travel_rad, "largest_travel_rad", "rad");
  require_positive(e.longest_plateau_s, "longest_plateau_s", "s");
  MovedJoint moved =
      travel(s, run_at(motor_speed, e, s.gear_ratio), e.sample_rate_Hz,
             fmt::format("constant_speed_{:02}.csv", index + 1), joint::Role::constant_speed);
  moved.run = index + 1;
  return moved;
}

/// Driving torques, one recording after the other.
std::vector<IdealRecording> put_together(const Scenario& s,
                                         std::vector<std::pair<MovedJoint, double>> moved) {
  SessionClock clock;
  for (const auto& [one, rate] : moved) clock.whole_s += one.recording.t_s.back();
  std::vector<IdealRecording> out;
  for (auto& [one, rate] : moved) {
    put_together(s, clock, one);
    clock.start_s += one.recording.t_s.back();
    out.push_back({std::move(one.recording), rate});
  }
  return out;
}

}  // namespace

TravelMotion::Plan run_at(double motor_speed_rad_s, const ConstantSpeedExperiment& e,
                          double gear_ratio) {
  const double speed = motor_speed_rad_s / gear_ratio;
  const double plateau = std::min(e.largest_travel_rad, speed * e.longest_plateau_s);
  const double half_way = plateau / 2 + TravelMotion::ramp_way_rad(speed, e.acceleration_rad_s2);
  return {e.centre_rad - half_way, e.centre_rad + half_way, speed, e.acceleration_rad_s2,
          e.both_directions};
}

std::vector<IdealRecording> simulate_ideal_joint(const Scenario& scenario) {
  if (!scenario.presliding) throw Refusal({"scenario.no_friction_model"});
  require_positive(scenario.gear_ratio, "gear ratio", "");
  require_not_negative(scenario.motor_inertia_kgm2, "motor inertia", "kg·m²");
  require_not_negative(scenario.arm_inertia_kgm2, "arm inertia", "kg·m²");
  std::vector<std::pair<MovedJoint, double>> moved;
  const auto keep = [&](MovedJoint one, double rate) { moved.emplace_back(std::move(one), rate); };
  if (const auto& e = scenario.rough_sweep) {
    keep(sweep(scenario, *e, "rough_sweep.csv", joint::Role::rough_sweep), e->sample_rate_Hz);
  }
  if (const auto& e = scenario.precise_sweep) {
    keep(sweep(scenario, *e, "precise_sweep.csv", joint::Role::precise_sweep), e->sample_rate_Hz);
  }
  if (const auto& e = scenario.sine_sweep) keep(sine_sweep(scenario, *e), e->sample_rate_Hz);
  if (const auto& first = scenario.oscillation) {
    const bool is_only_one = scenario.further_oscillations.empty();
    keep(oscillation(scenario, *first, is_only_one ? "oscillation.csv" : "oscillation_01.csv"),
         first->sample_rate_Hz);
    std::size_t number = 1;
    for (const OscillationExperiment& e : scenario.further_oscillations) {
      keep(oscillation(scenario, e, fmt::format("oscillation_{:02}.csv", ++number)),
           e.sample_rate_Hz);
    }
  } else if (!scenario.further_oscillations.empty()) {
    throw Refusal({"scenario.no_first_oscillation"});
  }
  if (const auto& e = scenario.constant_speed) {
    for (std::size_t i = 0; i < e->motor_speeds_rad_s.size(); ++i) {
      keep(constant_speed(scenario, *e, i), e->sample_rate_Hz);
    }
  }
  std::vector<IdealRecording> recordings = put_together(scenario, std::move(moved));
  if (const auto& e = scenario.break_away) {
    const std::size_t directions = e->both_directions ? 2 : 1;
    std::vector<joint::Recording> ramps;  // repeats differ by the drive's noise alone
    for (std::size_t d = 0; d < directions; ++d) {
      ramps.push_back(simulate_break_away_ramp(scenario, *e, d == 0 ? 1.0 : -1.0, ""));
    }
    for (std::size_t k = 0; k < e->repeats * directions; ++k) {
      joint::Recording ramp = ramps[k % directions];
      ramp.name = fmt::format("break_away_{:02}.csv", k + 1);
      recordings.push_back({std::move(ramp), e->sample_rate_Hz});
    }
  }
  return recordings;
}

std::vector<joint::Recording> with_noise(std::vector<IdealRecording> ideal, const Noise& noise,
                                         double gear_ratio) {
  std::vector<joint::Recording> recordings;
  for (std::size_t i = 0; i < ideal.size(); ++i) {
    recordings.push_back(std::move(ideal[i].recording));
    add_drive_noise(recordings.back(), noise, gear_ratio, ideal[i].sample_rate_Hz, i);
  }
  return recordings;
}

std::vector<joint::Recording> simulate_joint(const Scenario& scenario) {
  return with_noise(simulate_ideal_joint(scenario), scenario.noise, scenario.gear_ratio);
}

joint::Dataset simulated_dataset(const Scenario& scenario,
                                 std::vector<joint::Recording> recordings) {
  joint::Dataset dataset;
  joint::Manifest& manifest = dataset.manifest;
  manifest.robot = scenario.robot;
  manifest.serial = scenario.serial;
  manifest.joint = scenario.joint;
  manifest.note = "simulated: " + scenario.name;
  manifest.drive =
      joint::Drive(scenario.gear_ratio, joint::EffortKind::motor_torque, joint::Side::motor);
  manifest.surrogate_distance_m = scenario.surrogate_distance_m;
  manifest.gravity_m_s2 = scenario.load.gravity_m_s2();
  manifest.reference = scenario.known_curve();
  manifest.effects = absent_effects(scenario);
  dataset.recordings = std::move(recordings);
  return dataset;
}

joint::Dataset simulated_dataset(const Scenario& scenario) {
  return simulated_dataset(scenario, simulate_joint(scenario));
}

}  // namespace tribolog::simulate
