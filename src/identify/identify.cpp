#include "identify/identify.h"

#include <utility>

#include "calibration/calibration.h"
#include "method/checks/data_checks.h"
#include "method/hysteresis/break_away.h"
#include "method/hysteresis/lugre_experiments.h"
#include "method/intervals/bootstrap.h"
#include "method/selection/gravity_by_other_ways.h"
#include "truth/truth_check.h"
#include "verdict/judge.h"

namespace tribolog::identify {

// What is left of a calibration where no torque was recorded.

namespace {

/// Sets every stage's report: not identifiable, for want of torque, and what to record.
void refuse_for_want_of_torque(calibration::Calibration& c) {
  const auto refuse = [](statistics::StageReport& stage, const char* name, Code needed) {
    stage = {name, statistics::StageState::not_identifiable, needed};
  };
  constexpr Code column{"no_torque.log_a_column"};
  refuse(c.rough.stage, "cog_rough", column);
  refuse(c.precise.stage, "cog_precise", column);
  refuse(c.hysteresis.stage, "hysteresis", "no_torque.no_loop");
  refuse(c.masses.stage, "surrogate_masses", "no_torque.no_mass");
  refuse(c.viscous.stage, "viscous_curves", "no_torque.no_curve");
  refuse(c.quality.stage, "quality_errors", "no_torque.no_curve_to_check");
  refuse(c.selection.stage, "selection", "no_torque.no_mass_to_select");
  refuse(c.friction.stage, "friction_parameters", "no_torque.no_curve_to_fit");
}

/// What the earlier stages know of gravity.
std::optional<method::hysteresis::KnownGravity> known_gravity(const calibration::Calibration& c) {
  const method::hysteresis::SurrogateMass* mass = c.masses.find(c.selection.recommended);
  if (mass == nullptr || !c.q_peak_rad) return std::nullopt;
  return method::hysteresis::KnownGravity{mass->gravity_Nm, c.q_peak_rad->value};
}

using StageBegins = std::function<void(const char* stage)>;

/// The stages from the sweeps to the friction parameters: every number that can be held against a
/// known truth, and what later stages start from. Needs a torque.
void identify_quantities(const joint::Dataset& dataset, const StageBegins& begin,
                         calibration::Calibration& c) {
  const joint::Manifest& m = dataset.manifest;
  const double n = m.drive.gear_ratio();

  begin("centre of gravity, rough sweep");
  c.rough = method::gravity::identify_cog_sweep("cog_rough",
                                                dataset.with_role(joint::Role::rough_sweep), n);

  begin("centre of gravity, precise sweep");
  std::optional<statistics::Estimate> amplitude;
  if (c.rough.found) amplitude = c.rough.gravity_Nm;
  c.precise = method::gravity::identify_cog_sweep(
      "cog_precise", dataset.with_role(joint::Role::precise_sweep), n, amplitude, c.rough.ripple);
  for (const method::gravity::CogSweepResult* sweep : {&c.rough, &c.precise}) {
    if (!sweep->found) continue;
    if (!c.q_peak_rad || sweep->q_peak_rad.half_width() < c.q_peak_rad->half_width()) {
      c.q_peak_rad = sweep->q_peak_rad;
      c.q_peak_source = sweep->stage.name;
    }
  }

  c.run_gravity =
      method::gravity::identify_run_gravity(dataset.with_role(joint::Role::constant_speed), n);
  if (!c.q_peak_rad && c.run_gravity.found) {
    c.q_peak_rad = c.run_gravity.q_peak_rad;
    c.q_peak_source = "runs";
  }

  begin("hysteresis loop");
  c.hysteresis = method::hysteresis::identify_hysteresis(
      dataset.with_role(joint::Role::oscillation), c.rough, n, c.q_peak_rad);

  begin("surrogate masses");
  c.masses = method::hysteresis::identify_surrogate_masses(c.rough, c.hysteresis, c.q_peak_rad, n,
                                                           m.surrogate_distance_m, m.gravity_m_s2,
                                                           {&c.run_gravity, m.known_gravity});

  begin("viscous curves");
  c.viscous =
      method::viscous::identify_viscous_curves(dataset.with_role(joint::Role::constant_speed),
                                               c.rough, c.masses, c.q_peak_rad, n, m.known_gravity);

  begin("quality errors");
  c.quality = method::selection::identify_quality_errors(c.viscous, m.reference.get());

  begin("selection");
  c.selection =
      method::selection::select_estimator(c.masses, c.quality, c.hysteresis, c.q_peak_rad);

  begin("friction parameters");
  c.friction = method::selection::fit_friction_parameters(c.viscous, c.selection);
}

/// Simulates what was identified and identifies it again: of the simulations the numbers alone, for
/// nothing else of them is compared.
calibration::TruthCheckResult known_truth_check(const joint::Dataset& dataset,
                                                const calibration::Calibration& calibration,
                                                const IdentifyOptions& options) {
  const auto quantities = [](const joint::Dataset& simulated, std::uint64_t /*seed*/) {
    calibration::Calibration c;
    c.manifest = simulated.manifest;
    identify_quantities(simulated, [](const char*) {}, c);
    return c;
  };
  return truth::check_known_truth(dataset, calibration, quantities,
                                  {options.truth_runs, options.seed, options.threads});
}

}  // namespace

calibration::Calibration identify(const joint::Dataset& dataset, const IdentifyOptions& options,
                                  const StageProgress& progress) {
  const int all = options.truth_runs > 0 ? 13 : 12;
  int done = 0;
  const auto begin = [&](const char* stage) {
    if (progress) progress(stage, done, all);
    ++done;
  };
  const joint::Manifest& m = dataset.manifest;
  const double n = m.drive.gear_ratio();
  calibration::Calibration c;
  c.manifest = m;
  c.inputs = dataset.inputs;
  c.notes = dataset.notes;
  c.speed_sources = method::motion::speed_sources(dataset.recordings);

  begin("checks on the data");
  c.data_checks = method::checks::check_recordings(dataset);
  if (m.drive.kind() == joint::EffortKind::none) {
    refuse_for_want_of_torque(c);
    c.judgement = verdict::judge(c);
    if (progress) progress("identified", all, all);
    return c;
  }

  identify_quantities(dataset, begin, c);
  method::checks::add_gravity_checks(dataset, c.rough, c.run_gravity, c.q_peak_rad, c.data_checks);
  if (c.hysteresis.lugre && c.friction.waiboer && c.friction.waiboer->converged) {
    c.hysteresis.lugre = method::hysteresis::with_experiments(
        std::move(*c.hysteresis.lugre), n, c.friction.waiboer->stribeck_speed_rad_s.value);
  }
  c.load_dependence = method::viscous::identify_load_dependence(c.rough, c.q_peak_rad, n);
  c.direction_asymmetry = method::viscous::identify_direction_asymmetry(
      c.viscous, c.masses.find(c.selection.recommended), c.rough.offset_Nm);
  c.curve_model = method::viscous::choose_curve_model(c.viscous, c.selection.recommended);
  c.direction_lines = method::viscous::fit_direction_lines(c.viscous, c.selection.recommended);

  begin("break-away ramps and loop shapes");
  c.loop_shapes =
      method::hysteresis::describe_loops(dataset.with_role(joint::Role::oscillation), n);
  c.break_away = method::hysteresis::identify_break_away(dataset.with_role(joint::Role::break_away),
                                                         known_gravity(c));
  if (c.hysteresis.lugre) {
    c.hysteresis.lugre =
        method::hysteresis::against_ramps(std::move(*c.hysteresis.lugre), c.break_away);
  }

  begin("gravity by other ways");
  const method::selection::OtherWays other_ways = method::selection::gravity_by_other_ways(
      dataset.with_role(joint::Role::rough_sweep), dataset.with_role(joint::Role::constant_speed),
      c.rough, c.viscous, c.q_peak_rad, n);
  const method::intervals::ChainResults results{
      c.rough,   c.precise, c.q_peak_rad, c.q_peak_source, c.hysteresis, c.masses,
      c.viscous, c.quality, c.selection,  c.friction,      other_ways,   n};

  begin("intervals");
  c.intervals = method::intervals::resample_chain(
      results, {options.resamples, options.seed, options.threads}, [&](std::size_t resamples) {
        const std::string words = "intervals, resample " + std::to_string(resamples) + " of " +
                                  std::to_string(options.resamples);
        if (progress) progress(words, done - 1, all);
      });
  c.cross_checks = method::intervals::cross_check(results, c.intervals);
  c.position_plan = method::hysteresis::plan_positions(c.rough, c.hysteresis, n);
  method::intervals::state_intervals(c.intervals, c.friction);

  if (options.truth_runs > 0) {
    begin("known-truth check");
    c.truth_check = known_truth_check(dataset, c, options);
  }
  c.judgement = verdict::judge(c);
  if (progress) progress("identified", all, all);
  return c;
}

}  // namespace tribolog::identify
