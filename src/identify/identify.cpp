#include "identify/identify.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "base/parallel_for.h"
#include "base/requirements.h"
#include "calibration/calibration.h"
#include "calibration/headline.h"
#include "identify/influence_shifts.h"
#include "method/checks/data_checks.h"
#include "method/hysteresis/break_away.h"
#include "method/hysteresis/loop_widening.h"
#include "method/hysteresis/lugre_experiments.h"
#include "method/model/model_quantities.h"
#include "method/motion/false_stamps.h"
#include "method/motion/steady_runs.h"
#include "method/motion/torque_outliers.h"
#include "truth/truth_check.h"
#include "verdict/judge.h"

namespace tribolog::identify {
namespace {

using calibration::Calibration;
using joint::Role;
using method::gravity::SweepKind;

/// What the steps pass on: the calibration as it grows, and what no calibration holds.
struct Progress {
  Progress(const joint::Dataset& of, const IdentifyOptions& with) : dataset(of), options(with) {
    c.manifest = dataset.manifest;
  }

  const joint::Dataset& dataset;
  const IdentifyOptions& options;
  bool are_numbers_enough{};  ///< Of a simulation: no recording is checked.
  joint::Dataset
      cleaned;  ///< Without outliers of the torque and false stamps, where there are some.

  const double n = dataset.manifest.drive.gear_ratio();
  method::motion::Sweep rough_sweep;
  method::motion::Sweep precise_sweep;
  std::optional<statistics::Estimate> inertia_kgm2;  ///< By the model, known to a half.
  method::motion::SteadyRuns runs;                   ///< At constant speed.
  method::hysteresis::LoopTiming loop_timing;
  /// Oscillations without the lag of their torque, and without the ripple within them.
  std::vector<joint::Recording> prepared;
  method::gravity::CogSweep rough;
  method::gravity::CogSweep precise;
  method::hysteresis::Hysteresis loop;
  Calibration c;

  /// Which all steps look at: the sweeps refer to them.
  [[nodiscard]] const joint::Dataset& used() const {
    return c.torque_outliers.replaced > 0 || c.false_stamps.replaced > 0 ? cleaned : dataset;
  }
  [[nodiscard]] std::vector<const joint::Recording*> recordings(Role role) const {
    return used().with_role(role);
  }
  [[nodiscard]] bool has_gravity() const {
    const std::optional<joint::StatedGravity>& stated = dataset.manifest.known_gravity;
    return !stated || stated->amplitude_Nm() != 0;
  }
  [[nodiscard]] const method::hysteresis::SurrogateMass* recommended_mass() const {
    return c.masses.find(c.selection.recommended);
  }
};

/// A step of the method: one result, made from the recordings and from what earlier steps found.
/// None changes the result of an earlier one.
struct Step {
  const char* name;  ///< Told before it; empty: a small one, of the step before.
  void (*run)(Progress& p);
};

/// By the model, where it is known well enough to be taken off.
std::optional<statistics::Estimate> inertia_of_model(const method::model::ModelResult& model) {
  constexpr double widest = 0.5;
  const method::model::ModelQuantity* found = model.find(joint::Quantity::inertia);
  if (found == nullptr) return std::nullopt;
  const statistics::Estimate inertia = found->as_estimate();
  if (!(inertia.half_width() < widest * inertia.value)) return std::nullopt;
  return inertia;
}

/// Gravity by the model, where it is known well enough to place loops and to be taken off runs.
const method::model::ModelQuantity* gravity_of_model(const method::model::ModelResult& model) {
  constexpr double widest_angle_rad = 0.5;
  const method::model::ModelQuantity* gravity = model.find(joint::Quantity::gravity_torque);
  const method::model::ModelQuantity* angle = model.find(joint::Quantity::cog_angle);
  if (gravity == nullptr || angle == nullptr || !(gravity->low > 0)) return nullptr;
  return angle->as_estimate().half_width() < widest_angle_rad ? gravity : nullptr;
}

/// The gravity peak: by the model; where it gives none, from the sweep with the narrower interval.
void choose_gravity_peak(Calibration& c) {
  using method::gravity::PeakSource;
  if (gravity_of_model(c.model) != nullptr) {
    c.q_peak_rad = c.model.find(joint::Quantity::cog_angle)->as_estimate();
    c.q_peak_source = PeakSource::model;
    return;
  }
  for (const PeakSource source : {PeakSource::rough_sweep, PeakSource::precise_sweep}) {
    const method::gravity::CogSweepResult& sweep =
        source == PeakSource::rough_sweep ? c.rough : c.precise;
    if (!sweep.found) continue;
    if (!c.q_peak_rad || sweep.q_peak_rad.half_width() < c.q_peak_rad->half_width()) {
      c.q_peak_rad = sweep.q_peak_rad;
      c.q_peak_source = source;
    }
  }
}

/// What other recordings than a precise sweep show of gravity.
std::optional<method::gravity::KnownGravity> gravity_for_sweep(const Calibration& c) {
  if (const method::model::ModelQuantity* gravity = gravity_of_model(c.model)) {
    return method::gravity::KnownGravity{gravity->estimate,
                                         c.model.find(joint::Quantity::cog_angle)->estimate};
  }
  if (!c.rough.found) return std::nullopt;
  return method::gravity::KnownGravity{c.rough.gravity_Nm.value, c.rough.q_peak_rad.value};
}

std::optional<statistics::Estimate> gravity_of_loop_fit(const Progress& p) {
  return p.loop.lugre ? p.loop.lugre->fit.gravity_Nm : std::nullopt;
}

/// The inertia as it will be stated: of motion, else of the loops.
std::optional<statistics::Estimate> inertia_for_ramps(const Progress& p) {
  const calibration::InertiaHeadline of_motion = calibration::inertia_headline(p.c);
  if (of_motion.kgm2 || !p.loop.lugre) return of_motion.kgm2;
  return p.loop.lugre->fit.shown(method::hysteresis::LuGreParameterName::inertia);
}

/// As ramps show the bristle: their torque is as late as it was logged, that of loops is not where
/// a lag was clear.
method::hysteresis::BehindTorque behind_torque(const Progress& p) {
  using method::hysteresis::LuGreParameterName;
  if (!p.loop.lugre) return {};
  const method::hysteresis::LuGreFit& fit = p.loop.lugre->fit;
  const auto damping = fit.shown(LuGreParameterName::bristle_damping);
  const auto stiffness = fit.shown(LuGreParameterName::bristle_stiffness);
  if (!damping || !stiffness) return {};
  // Of another contact neither is the joint's.
  if (fit.contacts.winner && fit.contacts.winner != method::hysteresis::ContactLaw::lugre)
    return {};
  return {damping->value / stiffness->value - p.loop_timing.lag_s,
          damping->half_width() / stiffness->value};
}

/// The loop fit as it is stated once curve and ramps are known: with the experiments that would
/// show the rest, and without a static torque that a ramp has exceeded.
std::optional<method::hysteresis::LuGreFit> stated_loop_fit(const Progress& p) {
  if (!p.loop.lugre) return std::nullopt;
  method::hysteresis::LuGreFit fit = p.loop.lugre->fit;
  const auto& dip = p.c.model.law.stribeck_speed_rad_s;
  if (dip || (p.c.friction.waiboer && p.c.friction.waiboer->converged)) {
    fit = method::hysteresis::with_experiments(
        std::move(fit), p.n, dip ? dip->value : p.c.friction.waiboer->stribeck_speed_rad_s.value);
  }
  fit = method::hysteresis::against_ramps(std::move(fit), p.c.break_away);
  return method::hysteresis::with_friction_of_runs(std::move(fit), p.c.model.friction_of_loops,
                                                   p.c.model.gain_of_loops);
}

std::optional<method::hysteresis::KnownGravity> known_gravity(const Progress& p) {
  if (!p.has_gravity()) {
    return method::hysteresis::KnownGravity{
        statistics::symmetric_estimate(0, 0, {"interval.stated_in_manifest"}), 0};
  }
  const method::hysteresis::SurrogateMass* mass = p.recommended_mass();
  if (mass == nullptr || !p.c.q_peak_rad) return std::nullopt;
  return method::hysteresis::KnownGravity{mass->gravity_Nm, p.c.q_peak_rad->value};
}

/// The manifest's; zero where the sweep shows none to speak of and nothing else gave one: friction
/// is then the torque itself.
std::optional<joint::StatedGravity> stated_gravity(const Calibration& c) {
  constexpr double most_of_friction = 0.05;
  const std::optional<joint::StatedGravity>& stated = c.manifest.known_gravity;
  const bool shows_none = !c.rough.found && c.rough.coulomb_Nm && c.rough.samples_used > 0 &&
                          c.rough.gravity_Nm.high < most_of_friction * c.rough.coulomb_Nm->value;
  if (stated || !shows_none || c.hysteresis.midline_Nm) return stated;
  return joint::StatedGravity(0, 0);
}

method::hysteresis::OtherGravity other_gravity(const Progress& p) {
  method::hysteresis::OtherGravity other;
  other.loop_fit_Nm = gravity_of_loop_fit(p);
  other.stated = stated_gravity(p.c);
  const method::model::ModelQuantity* gravity = gravity_of_model(p.c.model);
  if (gravity == nullptr) return other;
  other.model_Nm = gravity->as_estimate();
  other.friction_Nm = p.c.model.friction_Nm;
  if (const auto* offset = p.c.model.find(joint::effect::offset.key)) {
    other.offset_Nm = offset->coefficient;
  }
  const auto* drift = p.c.model.find(joint::effect::offset_drift.key);
  if (drift != nullptr && drift->coefficient) {
    other.offset_drift_Nm = std::abs(drift->coefficient->value);
  }
  return other;
}

/// About as many points as a screen is wide, over all recordings.
std::vector<calibration::LogTrace> traces_of(const joint::Dataset& dataset) {
  constexpr std::size_t most_points = 2400;
  constexpr std::size_t fewest_points = 12;  // of a recording
  std::size_t all = 1;
  for (const joint::Recording& r : dataset.recordings) all += r.size();
  std::vector<calibration::LogTrace> traces;
  for (const joint::Recording& r : dataset.recordings) {
    const std::size_t wanted = std::max(fewest_points, most_points * r.size() / all);
    const std::size_t stride = std::max<std::size_t>(1, r.size() / wanted);
    calibration::LogTrace& trace = traces.emplace_back();
    trace.recording = r.name;
    trace.role = r.role;
    for (std::size_t i = 0; i < r.size(); i += stride) {
      trace.t_s.push_back(r.t_s[i]);
      trace.q_rad.push_back(r.q_rad[i]);
    }
  }
  return traces;
}

/// Where the manifest's uncertainties tell of hoses there are some.
joint::EffectSizes sizes_of_effects(const joint::Manifest& manifest) {
  joint::EffectSizes sizes = manifest.effects;
  if (manifest.uncertainty.hoses_percent) sizes.forget(joint::effect::hoses);
  return sizes;
}

bool states_none(const joint::Manifest& manifest, const joint::Effect& effect) {
  return manifest.effects.is_stated(effect) && manifest.effects.of(effect) == 0;
}

/// What sweeps, runs and the manifest say of what acts on the loops.
method::hysteresis::KnownEffects known_effects(const Progress& p) {
  const method::gravity::CogSweepResult of_turn = method::hysteresis::of_motor_turn(p.c.rough, p.n);
  const double friction_share = of_turn.coulomb_Nm && of_turn.coulomb_Nm->value > 0
                                    ? of_turn.friction_by_angle_Nm / of_turn.coulomb_Nm->value
                                    : 0;
  return {sizes_of_effects(p.dataset.manifest), p.loop_timing, friction_share};
}

/// Copies the dataset only where a recording is damaged.
void clean(Progress& p) {
  const std::vector<joint::Recording>& recordings = p.dataset.recordings;
  std::vector<char> is_damaged(recordings.size());
  parallel_for(
      recordings.size(),
      [&](std::size_t i) {
        is_damaged[i] = method::motion::has_false_stamps(recordings[i]) ||
                        !method::motion::torque_outliers(recordings[i]).empty();
      },
      p.options.threads);
  if (std::count(is_damaged.begin(), is_damaged.end(), 1) == 0) return;
  p.cleaned = p.dataset;
  p.c.false_stamps = method::motion::replace_false_stamps(p.cleaned.recordings);
  p.c.torque_outliers = method::motion::replace_torque_outliers(p.cleaned.recordings);
}

void identify_model(Progress& p) {
  std::vector<const joint::Recording*> all;
  for (const joint::Recording& r : p.used().recordings) all.push_back(&r);
  p.c.model = method::model::identify_joint(all, p.dataset.friction_points, p.n, p.has_gravity(),
                                            sizes_of_effects(p.dataset.manifest));
  p.inertia_kgm2 = inertia_of_model(p.c.model);
  const method::model::ModelEffect* lag = p.c.model.find(joint::effect::lag.key);
  p.loop_timing =
      method::hysteresis::timing_of_loops(lag == nullptr ? std::nullopt : lag->coefficient);
}

void identify_rough_sweep(Progress& p) {
  p.rough_sweep = method::motion::Sweep(p.recordings(Role::rough_sweep));
  p.rough =
      method::gravity::identify_cog_sweep(SweepKind::rough, p.rough_sweep, p.n, p.has_gravity());
  p.c.rough = p.rough.result;
}

void check_recordings(Progress& p) { p.c.data_checks = method::checks::check_recordings(p.used()); }

/// What needs the recordings alone, at the same time.
void look_at_recordings(Progress& p) {
  constexpr void (*pieces[])(Progress&) = {identify_model, identify_rough_sweep, check_recordings};
  const std::size_t count = std::size(pieces) - (p.are_numbers_enough ? 1 : 0);
  parallel_for(count, [&](std::size_t k) { pieces[k](p); }, p.options.threads);
}

/// The paper's chain, from the sweeps to the friction parameters: every number that can be compared
/// with a known truth, and what later steps start from.
constexpr Step papers_chain[] = {
    {"recordings",
     [](Progress& p) {
       clean(p);
       p.c.curves.log = traces_of(p.used());
     }},
    {"joint model and rough sweep", look_at_recordings},
    {"",
     [](Progress& p) {
       p.runs = method::motion::SteadyRuns(p.recordings(Role::constant_speed),
                                           p.inertia_kgm2 ? p.n * p.inertia_kgm2->value : 0);
     }},
    {"centre of gravity, precise sweep",
     [](Progress& p) {
       p.precise_sweep = method::motion::Sweep(p.recordings(Role::precise_sweep));
       p.precise = method::gravity::identify_cog_sweep(SweepKind::precise, p.precise_sweep, p.n,
                                                       p.has_gravity(), gravity_for_sweep(p.c));
       p.c.precise = p.precise.result;
     }},
    {"", [](Progress& p) { choose_gravity_peak(p.c); }},
    {"hysteresis loop",
     [](Progress& p) {
       std::vector<const joint::Recording*> loops = p.recordings(Role::oscillation);
       const method::hysteresis::KnownOfLoops known{known_effects(p), p.inertia_kgm2};
       p.prepared.clear();
       p.prepared.reserve(loops.size());
       for (const joint::Recording*& r : loops) {
         p.prepared.push_back(method::hysteresis::aligned(*r, p.loop_timing.lag_s));
         method::hysteresis::subtract_ripple_from_loop(p.c.rough, p.n, p.prepared.back());
         r = &p.prepared.back();
       }
       p.loop = method::hysteresis::identify_hysteresis(loops, p.rough_sweep, p.c.rough, p.n,
                                                        p.c.q_peak_rad, known);
       p.c.hysteresis = p.loop.result;
     }},
    {"surrogate masses",
     [](Progress& p) {
       const joint::Manifest& m = p.dataset.manifest;
       p.c.masses = method::hysteresis::identify_surrogate_masses(
           p.c.rough, p.c.hysteresis, p.c.q_peak_rad, p.n, m.surrogate_distance_m, m.gravity_m_s2,
           other_gravity(p));
     }},
    {"viscous curves",
     [](Progress& p) {
       p.c.viscous = method::viscous::identify_viscous_curves(
           p.runs, p.dataset.friction_points, p.rough_sweep, p.c.rough, p.c.masses, p.c.q_peak_rad,
           p.n, stated_gravity(p.c));
     }},
    {"quality errors",
     [](Progress& p) {
       p.c.quality = method::selection::identify_quality_errors(p.c.viscous,
                                                                p.dataset.manifest.reference.get());
     }},
    {"selection",
     [](Progress& p) {
       p.c.selection = method::selection::select_estimator(p.c.masses, p.c.quality, p.c.hysteresis,
                                                           p.c.q_peak_rad);
     }},
    {"friction parameters",
     [](Progress& p) {
       p.c.friction = method::selection::fit_friction_parameters(p.c.viscous, p.c.selection);
     }},
};

/// Whether the data support the chain, what goes beyond the paper, and how certain all of it is.
constexpr Step further_steps[] = {
    {"checks of gravity",
     [](Progress& p) {
       method::checks::add_gravity_checks(p.used(), {p.c.rough, p.c.masses, p.c.q_peak_rad},
                                          p.c.data_checks);
     }},
    {"break-away ramps and loop shapes",
     [](Progress& p) {
       const std::optional<statistics::Estimate> inertia = inertia_for_ramps(p);
       method::hysteresis::KnownOfRamps known{known_gravity(p)};
       known.inertia_at_joint = inertia ? p.n * inertia->value : 0;
       known.gear_ratio = p.n;
       known.sweep = p.c.model.friction_of_ramps ? method::hysteresis::of_motor_turn(p.c.rough, p.n)
                                                 : p.c.rough;
       known.behind = behind_torque(p);
       known.friction_of_turn = 0.01 * p.dataset.manifest.effects.of(joint::effect::motor_turn);
       known.is_lugre = states_none(p.dataset.manifest, joint::effect::contact_misfit);
       p.c.break_away =
           method::hysteresis::identify_break_away(p.recordings(Role::break_away), known);
       method::hysteresis::refer_to_runs(p.c.model.friction_of_ramps, p.c.break_away);
     }},
    {"", [](Progress& p) { p.c.lugre = stated_loop_fit(p); }},
    {"",
     [](Progress& p) {
       p.c.loop_shapes = method::hysteresis::describe_loops(p.recordings(Role::oscillation), p.n);
     }},
    {"",
     [](Progress& p) {
       p.c.cross_checks = method::selection::cross_check(p.c.masses, p.c.selection.recommended,
                                                         p.c.hysteresis, p.n);
     }},
    {"",
     [](Progress& p) {
       p.c.position_plan =
           method::hysteresis::plan_positions(p.c.rough, p.c.hysteresis, p.loop.steady_cycles, p.n);
     }},
    {"",
     [](Progress& p) {
       p.c.curves = {std::move(p.rough.curves), std::move(p.precise.curves),
                     std::move(p.loop.traces), std::move(p.c.curves.log)};
     }},
};

/// Simulates what was identified and identifies it again; only the numbers of the simulations are
/// compared.
void check_known_truth(Progress& p) {
  const auto numbers_of = [&p](const joint::Dataset& simulated, std::uint64_t /*seed*/) {
    Progress chain(simulated, p.options);
    chain.are_numbers_enough = true;
    for (const Step& step : papers_chain) step.run(chain);
    if (chain.loop.lugre) chain.c.lugre = std::move(chain.loop.lugre->fit);
    return std::move(chain.c);
  };
  p.c.truth_check = truth::check_known_truth(
      p.used(), p.c, numbers_of, {p.options.truth_runs, p.options.seed, p.options.threads});
}

constexpr Step truth_step{"known-truth check", check_known_truth};

/// Each quantity as the recordings give it, by closed forms alone.
std::vector<calibration::QuantityVerdict> quantities_of(const joint::Dataset& dataset) {
  const IdentifyOptions on_one_thread{1, 1, 0};
  Progress p(dataset, on_one_thread);
  for (const Step& step : papers_chain) step.run(p);
  for (const Step& step : further_steps) step.run(p);
  return verdict::judge(p.c).quantities;
}

constexpr Step influences_step{"influences that the manifest states", [](Progress& p) {
                                 p.c.influence_shifts = find_influence_shifts(
                                     p.dataset, verdict::judge(p.c), quantities_of);
                               }};

/// All there is to do where no torque was recorded: each stage's report says so, and what to
/// record.
constexpr Step without_torque{
    "checks on the data", [](Progress& p) {
      Calibration& c = p.c;
      const auto refuse = [](statistics::StageReport& stage, const char* name, Code needed) {
        stage = {name, statistics::StageState::not_identifiable, needed};
      };
      c.data_checks = method::checks::check_recordings(p.dataset);
      constexpr Code column{"no_torque.log_a_column"};
      refuse(c.rough.stage, "cog_rough", column);
      refuse(c.precise.stage, "cog_precise", column);
      refuse(c.hysteresis.stage, "hysteresis", "no_torque.no_loop");
      refuse(c.masses.stage, "surrogate_masses", "no_torque.no_mass");
      refuse(c.viscous.stage, "viscous_curves", "no_torque.no_curve");
      refuse(c.quality.stage, "quality_errors", "no_torque.no_curve_to_check");
      refuse(c.selection.stage, "selection", "no_torque.no_mass_to_select");
      refuse(c.friction.stage, "friction_parameters", "no_torque.no_curve_to_fit");
    }};

std::vector<Step> steps_for(const joint::Dataset& dataset, const IdentifyOptions& options) {
  if (dataset.manifest.drive.kind() == joint::EffortKind::none) return {without_torque};
  std::vector<Step> steps(std::begin(papers_chain), std::end(papers_chain));
  steps.insert(steps.end(), std::begin(further_steps), std::end(further_steps));
  if (has_influence_to_shift(dataset.manifest)) steps.push_back(influences_step);
  if (options.truth_runs > 0) steps.push_back(truth_step);
  return steps;
}

}  // namespace

Calibration identify(const joint::Dataset& dataset, const IdentifyOptions& options,
                     const StageProgress& progress) {
  Progress p(dataset, options);
  p.c.inputs = dataset.inputs;
  p.c.notes = dataset.notes;
  p.c.speed_sources = method::motion::speed_sources(dataset.recordings);

  const std::vector<Step> steps = steps_for(dataset, options);
  const auto all = static_cast<int>(
      std::count_if(steps.begin(), steps.end(), [](const Step& step) { return *step.name != 0; }));
  int done = 0;
  const auto tell = [&](const std::string& step, int before) {
    if (progress) progress(step, before, all);
  };
  for (const Step& step : steps) {
    if (*step.name != 0) tell(step.name, done++);
    step.run(p);
  }
  p.c.judgement = verdict::judge(p.c);
  tell("identified", all);
  return std::move(p.c);
}

}  // namespace tribolog::identify
