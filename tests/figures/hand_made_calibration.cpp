#include "figures/hand_made_calibration.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace tribolog::test {
namespace {

using method::hysteresis::Estimator;

constexpr double rate_Hz = 100.0;
constexpr double two_pi = 2 * std::numbers::pi;

/// Rest, up, rest, down, rest, between two angles, at constant speed.
joint::Recording sweep(const std::string& name, joint::Role role, double from_rad, double to_rad) {
  constexpr int rest = 30;
  constexpr int way = 400;
  joint::Recording recording;
  recording.name = name;
  recording.role = role;
  const auto add = [&](double q, double direction) {
    recording.t_s.push_back(static_cast<double>(recording.t_s.size()) / rate_Hz);
    recording.q_rad.push_back(q);
    recording.torque_Nm.push_back(known::gravity_Nm * std::cos(q - known::q_peak_rad) +
                                  direction * known::friction_Nm);
  };
  for (int i = 0; i < rest; ++i) add(from_rad, 0.0);
  for (int i = 0; i < way; ++i) add(from_rad + (to_rad - from_rad) * i / way, 1.0);
  for (int i = 0; i < rest; ++i) add(to_rad, 0.0);
  for (int i = 0; i < way; ++i) add(to_rad - (to_rad - from_rad) * i / way, -1.0);
  for (int i = 0; i < rest; ++i) add(from_rad, 0.0);
  return recording;
}

/// Torque leads the angle by a quarter of a cycle: the loop is an ellipse, entered at its side.
joint::Recording oscillation() {
  joint::Recording recording;
  recording.name = "oscillation.csv";
  recording.role = joint::Role::oscillation;
  for (int i = 0; i <= known::cycles * known::samples_per_cycle; ++i) {
    const double phase = two_pi * i / known::samples_per_cycle;
    recording.t_s.push_back(phase / two_pi / known::frequency_Hz);
    recording.q_rad.push_back(known::centre_rad + known::amplitude_rad * std::sin(phase));
    recording.torque_Nm.push_back(known::gravity_Nm + known::loop_Nm * std::cos(phase));
    recording.z_rad.push_back(known::z_rad * std::sin(phase));
    recording.dz_rad_s.push_back(known::dz_rad_s * std::cos(phase));
  }
  return recording;
}

/// The strokes of a sweep, and the cosine that it was made of.
method::gravity::SweepCurves sweep_curves(const joint::Recording& recording) {
  method::gravity::SweepCurves curves;
  std::vector<bool> used;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    used.push_back((i >= 35 && i < 425) || (i >= 465 && i < 855));
  }
  curves.used = {used};
  curves.lowest_rad = recording.q_rad.front();
  curves.highest_rad = recording.q_rad[430];
  for (int i = 0; i <= 50; ++i) {
    const double q = curves.lowest_rad + (curves.highest_rad - curves.lowest_rad) * i / 50;
    const double gravity = known::gravity_Nm * std::cos(q - known::q_peak_rad);
    curves.fit_q_rad.push_back(q);
    curves.fit_rising_Nm.push_back(gravity + known::friction_Nm);
    curves.fit_falling_Nm.push_back(gravity - known::friction_Nm);
  }
  return curves;
}

method::gravity::CogSweepResult sweep_result(const std::string& name,
                                             const joint::Recording* recording, double half_rad) {
  method::gravity::CogSweepResult result;
  result.stage = {name, statistics::StageState::done, {}};
  result.found = true;
  result.method = Statement::verbatim("least squares");
  result.argmax_rad = known::q_peak_rad + 0.002;
  result.argmax_low_rad = known::q_peak_rad - 0.006;
  result.argmax_high_rad = known::q_peak_rad + 0.007;
  result.argmax_torque_Nm = known::gravity_Nm + known::friction_Nm;
  result.q_peak_rad =
      statistics::symmetric_estimate(known::q_peak_rad, half_rad, Statement::verbatim("by hand"));
  result.gravity_Nm =
      statistics::symmetric_estimate(known::gravity_Nm, 0.012, Statement::verbatim("by hand"));
  result.coulomb_Nm =
      statistics::symmetric_estimate(known::friction_Nm, 0.003, Statement::verbatim("by hand"));
  result.both_directions = true;
  result.constant_speed = true;
  result.lowest_rad = recording->q_rad.front();
  result.highest_rad = recording->q_rad[430];
  result.samples_used = 780;
  result.samples_left_out = recording->size() - result.samples_used;
  return result;
}

method::hysteresis::LoopPoint reading(Estimator name, const joint::Recording& recording,
                                      std::size_t at) {
  return {name,
          recording.t_s[at],
          recording.q_rad[at],
          recording.torque_Nm[at],
          recording.torque_Nm[at] - 0.01,
          recording.torque_Nm[at] + 0.01,
          recording.z_rad[at],
          recording.dz_rad_s[at]};
}

method::hysteresis::LoopTrace trace_of(const joint::Recording& recording) {
  method::hysteresis::LoopTrace trace;
  trace.recording = recording.name;
  trace.t_s = recording.t_s;
  trace.q_rad = recording.q_rad;
  trace.torque_Nm = recording.torque_Nm;
  trace.z_rad = recording.z_rad;
  trace.dz_rad_s = recording.dz_rad_s;
  trace.midline_q_rad = {known::centre_rad - 80e-6, known::centre_rad + 80e-6};
  trace.midline_Nm = {known::gravity_Nm, known::gravity_Nm};
  return trace;
}

method::hysteresis::HysteresisResult loop_result(const joint::Recording& recording) {
  method::hysteresis::HysteresisResult loop;
  loop.stage = {"hysteresis", statistics::StageState::done, {}};
  loop.found = true;
  loop.bristle_source = {"loop.bristle_recorded"};
  loop.oscillations.push_back({known::centre_rad, known::amplitude_rad, known::frequency_Hz,
                               known::cycles, known::cycles - 1.0, 0.0});
  loop.points = {reading(Estimator::A, recording, 0),   reading(Estimator::C, recording, 50),
                 reading(Estimator::F, recording, 80),  reading(Estimator::B, recording, 105),
                 reading(Estimator::D, recording, 150), reading(Estimator::E, recording, 180)};
  for (const method::hysteresis::LoopPoint& point : loop.points) {
    loop.steady_points.push_back(point);
    loop.steady_points.back().torque_Nm += 0.2;
  }
  loop.midline_Nm =
      statistics::symmetric_estimate(known::gravity_Nm, 0.008, Statement::verbatim("by hand"));
  loop.midline_q_rad = known::centre_rad;
  loop.loop_height_Nm = 2 * known::loop_Nm;
  return loop;
}

method::hysteresis::SurrogateMass mass(Estimator estimator, double torque_Nm) {
  const statistics::Estimate torque =
      statistics::symmetric_estimate(torque_Nm, 0.01, Statement::verbatim("by hand"));
  return {
      estimator, torque, known::centre_rad, statistics::scaled(torque, known::kg_per_Nm), torque,
      1.0,       {}};
}

/// Friction 0.5 N·m + 0.002 N·m·s/rad in both directions, seen with each candidate's gravity.
void add_runs(calibration::Calibration& calibration, const std::vector<double>& speeds) {
  method::viscous::ViscousCurvesResult& viscous = calibration.viscous;
  viscous.stage = {"viscous_curves", statistics::StageState::done, {}};
  for (const double speed : speeds) {
    method::viscous::ConstantSpeedRun run;
    run.recording = "runs.csv";
    run.speed_rad_s = speed;
    run.torque_Nm = known::gravity_Nm + std::copysign(known::friction_Nm, speed) + 0.002 * speed;
    run.torque_half_width_Nm = 0.01;
    run.q_rad = known::q_peak_rad;
    run.mean_cos = 1.0;
    run.samples = 100;
    viscous.runs.push_back(run);
    calibration.quality.reference_Nm.push_back(run.torque_Nm - known::gravity_Nm);
  }
  for (const method::hysteresis::SurrogateMass& candidate : calibration.masses.masses) {
    method::viscous::ViscousCurve curve{candidate.estimator, {}};
    method::selection::QualityError error{candidate.estimator, {}, 0.0};
    for (const method::viscous::ConstantSpeedRun& run : viscous.runs) {
      curve.friction_Nm.push_back(run.torque_Nm - candidate.gravity_Nm.value);
      error.percent.push_back(100 * (known::gravity_Nm - candidate.gravity_Nm.value) /
                              run.torque_Nm);
    }
    error.rms_percent = std::abs(error.percent.front());
    viscous.curves.push_back(std::move(curve));
    calibration.quality.errors.push_back(std::move(error));
  }
  calibration.quality.stage = {"quality_errors", statistics::StageState::done, {}};
  calibration.quality.reference = method::selection::CurveReference::direction_difference;
}

void add_laws(calibration::Calibration& calibration) {
  method::selection::FrictionParametersResult& friction = calibration.friction;
  friction.stage = {"friction_parameters", statistics::StageState::done, {}};
  friction.curve = calibration.selection.recommended;
  method::model::ModelLaw& law = calibration.model.law;
  law.family = "line";
  law.level_Nm = known::friction_Nm;
  law.rise_Nm = 0.6;
  law.slowest_rad_s = 10.0;
  law.fastest_rad_s = 300.0;
  friction.waiboer = method::viscous::WaiboerFit{};
  friction.waiboer->converged = true;
  friction.waiboer->residual_Nm = 0.0031;
  friction.waiboer->asperity_torque_Nm.value = 0.88;
  friction.waiboer->stribeck_speed_rad_s.value = 5;
  friction.waiboer->stribeck_power.value = 0.7;
  friction.waiboer->viscous_coefficient.value = 0.12;
  friction.waiboer->viscous_power.value = 0.6;
}

}  // namespace

joint::Dataset hand_made_dataset() {
  joint::Dataset dataset;
  dataset.manifest.drive =
      joint::Drive(known::gear_ratio, joint::EffortKind::motor_torque, joint::Side::motor);
  dataset.recordings.push_back(sweep("rough.csv", joint::Role::rough_sweep, -1.4, 1.0));
  dataset.recordings.push_back(sweep("precise.csv", joint::Role::precise_sweep, -0.42, -0.38));
  dataset.recordings.push_back(oscillation());
  return dataset;
}

calibration::Calibration hand_made_calibration(const joint::Dataset& dataset) {
  calibration::Calibration calibration;
  calibration.manifest = dataset.manifest;
  calibration.rough = sweep_result("cog_rough", &dataset.recordings[0], 0.003);
  calibration.precise = sweep_result("cog_precise", &dataset.recordings[1], 0.0005);
  calibration.curves.rough = sweep_curves(dataset.recordings[0]);
  calibration.curves.precise = sweep_curves(dataset.recordings[1]);
  calibration.curves.loops = {trace_of(dataset.recordings[2])};
  calibration.q_peak_rad = calibration.precise.q_peak_rad;
  calibration.q_peak_source = method::gravity::PeakSource::precise_sweep;
  calibration.hysteresis = loop_result(dataset.recordings[2]);
  calibration.masses.stage = {"surrogate_masses", statistics::StageState::done, {}};
  calibration.masses.distance_m = 0.5;
  calibration.masses.gravity_m_s2 = 9.81;
  calibration.masses.masses = {
      mass(Estimator::A, 4.8),         mass(Estimator::B, 3.96),    mass(Estimator::C, 4.9),
      mass(Estimator::D, 3.1),         mass(Estimator::E, 3.7),     mass(Estimator::F, 4.3),
      mass(Estimator::AB, 4.02),       mass(Estimator::CD, 4.01),   mass(Estimator::EF, 3.98),
      mass(Estimator::midline, 4.005), mass(Estimator::sweep, 4.03)};
  add_runs(calibration, {-300.0, -100.0, -10.0, -1.0, 1.0, 10.0, 100.0, 300.0});
  calibration.selection.stage = {"selection", statistics::StageState::done, {}};
  calibration.selection.paper_rule = Estimator::B;
  calibration.selection.recommended = Estimator::midline;
  calibration.selection.q_c_rad =
      statistics::symmetric_estimate(-known::q_peak_rad, 0.0005, Statement::verbatim("by hand"));
  add_laws(calibration);
  return calibration;
}

calibration::Calibration sweep_only_calibration(const joint::Dataset& dataset) {
  calibration::Calibration calibration;
  calibration.manifest = dataset.manifest;
  calibration.rough = sweep_result("cog_rough", &dataset.recordings[0], 0.003);
  calibration.rough.constant_speed = false;
  calibration.curves.rough = sweep_curves(dataset.recordings[0]);
  calibration.q_peak_rad = calibration.rough.q_peak_rad;
  calibration.q_peak_source = method::gravity::PeakSource::rough_sweep;
  calibration.precise.stage = {"cog_precise", statistics::StageState::skipped,
                               Statement::verbatim("no recording")};
  calibration.hysteresis.stage = {"hysteresis", statistics::StageState::not_identifiable,
                                  Statement::verbatim("encoder too coarse")};
  calibration.masses.masses = {mass(Estimator::sweep, 4.03)};
  add_runs(calibration, {-60.0, -50.0, -40.0, 40.0, 50.0, 60.0});
  calibration.viscous.from_sweep = true;
  calibration.selection.recommended = Estimator::sweep;
  add_laws(calibration);
  calibration.friction.waiboer.reset();
  return calibration;
}

}  // namespace tribolog::test
