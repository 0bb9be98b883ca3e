#include "method/hysteresis/lugre_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <Eigen/Core>

#include "base/enum_text.h"
#include "base/requirements.h"
#include "method/hysteresis/lugre_experiments.h"
#include "method/hysteresis/lugre_identifiability.h"
#include "method/hysteresis/lugre_ladder.h"
#include "method/hysteresis/traced_loop.h"
#include "statistics/distributions.h"
#include "statistics/levenberg_marquardt.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::hysteresis {
namespace {

/// Samples per cycle on which first guesses are tried.
constexpr double thinned_per_cycle = 60;

std::size_t stride_of(const joint::Recording& r, double frequency_Hz) {
  const double per_cycle =
      static_cast<double>(r.size() - 1) / ((r.t_s.back() - r.t_s.front()) * frequency_Hz);
  return static_cast<std::size_t>(std::max(1.0, std::floor(per_cycle / thinned_per_cycle)));
}

using GrainOf = LuGreGrain (*)(const LuGreInput& loop);

/// The samples for first guesses; of many cycles the first hundred or two.
LuGreGrain thinned(const LuGreInput& loop) {
  constexpr std::size_t most_samples = 10'000;
  return {stride_of(*loop.recording, loop.frequency_Hz()), 1, most_samples};
}

/// Samples that lead close to the solution for all samples: a few times as many as for first
/// guesses.
LuGreGrain halfway(const LuGreInput& loop) {
  constexpr std::size_t most_samples = 20'000;
  constexpr std::size_t times_thinned = 4;
  const std::size_t finest = thinned(loop).stride;
  const std::size_t stride =
      std::max(finest / times_thinned, loop.recording->size() / most_samples);
  return {std::clamp<std::size_t>(stride, 1, finest), 1, most_samples};
}

/// All samples; in a long recording neighbours are averaged where their mean contains all they do.
/// This bounds the fit's memory.
LuGreGrain all_samples(const LuGreInput& loop) {
  constexpr std::size_t enough_rows = 100'000;
  constexpr std::size_t fewest_thinned = 4;  // rows where the thinned problem has one sample
  const std::size_t together = loop.recording->size() / enough_rows;
  return {1, std::clamp<std::size_t>(
                 together, 1, std::max<std::size_t>(1, thinned(loop).stride / fewest_thinned))};
}

LuGreProblem problem_of(const std::vector<LuGreInput>& loops, double gear_ratio, double q_peak_rad,
                        GrainOf grain) {
  std::vector<LuGreLoopModel> models;
  for (const LuGreInput& loop : loops) {
    models.push_back(loop.model(gear_ratio, q_peak_rad, grain(loop)));
  }
  return LuGreProblem(std::move(models));
}

std::optional<LuGreProblem> problem_halfway(const std::vector<LuGreInput>& loops, double gear_ratio,
                                            double q_peak_rad) {
  const bool is_worth_it = std::any_of(loops.begin(), loops.end(),
                                       [](const LuGreInput& l) { return halfway(l).stride > 1; });
  if (!is_worth_it) return std::nullopt;
  return problem_of(loops, gear_ratio, q_peak_rad, halfway);
}

/// Half loops of all recordings, numbered consecutively, within which residuals of a misfitted loop
/// are correlated; of each row that of its first sample.
std::vector<std::size_t> half_loop_blocks(const std::vector<LuGreInput>& loops,
                                          const LuGreProblem& problem) {
  std::vector<std::size_t> blocks;
  for (std::size_t r = 0; r < loops.size(); ++r) {
    const std::size_t first = blocks.empty() ? 0 : blocks.back() + 1;
    const std::vector<std::size_t> halves = loops[r].half_loops();
    const std::size_t in_row = problem.models()[r].samples_in_row();
    for (std::size_t i = 0; i < halves.size(); i += in_row) blocks.push_back(first + halves[i]);
  }
  return blocks;
}

/// The same of the samples for first guesses.
std::vector<std::size_t> thinned_blocks(const std::vector<LuGreInput>& loops) {
  std::vector<std::size_t> blocks;
  for (const LuGreInput& loop : loops) {
    const std::size_t first = blocks.empty() ? 0 : blocks.back() + 1;
    const std::vector<std::size_t> halves = loop.half_loops();
    const LuGreGrain grain = thinned(loop);
    for (std::size_t k = 0; k < grain.most_samples && k * grain.stride < halves.size(); ++k) {
      blocks.push_back(first + halves[k * grain.stride]);
    }
  }
  return blocks;
}

LuGreClimb climb_from_coarse(const std::vector<LuGreInput>& loops, double gear_ratio,
                             double q_peak_rad, const LuGreProblem& problem) {
  const LuGreProblem coarse = problem_of(loops, gear_ratio, q_peak_rad, thinned);
  const std::optional<LuGreProblem> between = problem_halfway(loops, gear_ratio, q_peak_rad);
  return climb_lugre_ladder({coarse, between ? &*between : nullptr, problem},
                            half_loop_blocks(loops, problem));
}

/// All samples, each compared by itself.
LuGreGrain every_sample(const LuGreInput& /*loop*/) { return {}; }

void describe_excitation(const std::vector<LuGreInput>& loops, const LuGreProblem& problem,
                         LuGreFit& fit) {
  for (std::size_t r = 0; r < loops.size(); ++r) {
    const LuGreLoopModel& model = problem.models()[r];
    fit.height_Nm = std::max(fit.height_Nm, model.height_Nm());
    fit.peak_speed_rad_s = std::max(fit.peak_speed_rad_s, model.peak_speed_rad_s());
    if (model.motor_amplitude_rad() > fit.motor_amplitude_rad) {
      fit.motor_amplitude_rad = model.motor_amplitude_rad();
      fit.frequency_Hz = loops[r].frequency_Hz();
    }
  }
}

/// How the model's motion was obtained, and what that shows about the loop.
void describe_motion(const LuGreInput& input, const LuGreLoopModel& model, const LuGreClimb& climb,
                     double gear_ratio, const LuGreSignals& signals, LuGreLoop& loop) {
  loop.motion = input.traced != nullptr ? LoopMotion::spline : LoopMotion::harmonics;
  loop.motion_residual_rad =
      input.traced != nullptr ? input.traced->residual_rad : input.motion->residual_rad;
  if (input.traced == nullptr) return;
  const double stiffness = std::exp(climb.point.shared(LuGreShared::log_stiffness));
  std::vector<double> slope(model.speed_rad_s().size(), stiffness);
  for (std::size_t i = 0; i < signals.dz_rad_s.size(); ++i) {
    const double w = model.speed_rad_s()[i];
    if (w != 0) slope[i] *= signals.dz_rad_s[i] / w;
  }
  loop.traced =
      describe_traced_loop(*input.recording, *input.traced, signals.torque_Nm, slope, gear_ratio);
}

/// What of a loop the fit compared.
struct Compared {
  joint::Recording recording;
  std::vector<double> model_Nm, speed_rad_s;
};

Compared compared(const joint::Recording& r, const LuGreLoopModel& model,
                  const std::vector<double>& model_Nm) {
  const auto behind = [&](const std::vector<double>& all) {
    return std::vector<double>(all.begin() + model.rows_left_out(), all.end());
  };
  Compared out;
  out.recording.name = r.name;
  out.recording.t_s = behind(r.t_s);
  out.recording.q_rad = behind(r.q_rad);
  out.recording.torque_Nm = behind(r.torque_Nm);
  out.model_Nm = behind(model_Nm);
  out.speed_rad_s = behind(model.speed_rad_s());
  return out;
}

/// Strokes of any size: what they repeat, or what is left beyond the noise, whichever is more.
double systematic_of_traced(const joint::Recording& recording, const LuGreInput& input,
                            const LuGreSignals& signals, const LuGreLoop& loop) {
  constexpr double noise_known_to = 1.25;  // to a quarter, by the angle's and the torque's scatter
  const double unexplained =
      std::pow(loop.residual_Nm, 2) - std::pow(noise_known_to * loop.traced->explained_Nm, 2);
  return std::max(repeated_misfit_Nm(recording, signals.torque_Nm, input.traced->turns_s,
                                     loop.samples_left_out),
                  std::sqrt(std::max(0.0, unexplained)));
}

/// Whether a loop shows enough of another contact to identify which.
bool leaves_what_repeats(const LuGreFit& fit) {
  constexpr double least = 1e-3;  // of a loop's height
  const LuGreLoop* worst = fit.worst_described();
  return worst != nullptr && worst->systematic_Nm > least * worst->height_Nm;
}

/// What repeats in all loops, rms.
double systematic_of_all(const LuGreFit& fit) {
  double squares = 0;
  for (const LuGreLoop& loop : fit.loops) squares += loop.systematic_Nm * loop.systematic_Nm;
  return std::sqrt(squares / static_cast<double>(fit.loops.size()));
}

/// Local parameters from which a recording's model can be followed from its first sample on. Behind
/// a start that is left out nothing but a remainder of its deflection is compared, and what least
/// squares makes of that need not be a deflection that a bristle holds: T_s/sigma0 is the largest
/// (eq. (4)); beyond it the arm is taken to start from rest.
LuGreLocal followed_from_the_start(const LuGreLoopModel& model, const LuGreShared::Vector& shared,
                                   LuGreLocal local) {
  const double largest_rad = LuGreShared::largest_deflection_rad(shared);
  if (model.rows_left_out() > 0 && std::abs(local.start_rad) > largest_rad) local.start_rad = 0;
  return local;
}

/// Gravity of each recording, and the fit's bristle in it.
/// @param problem of every sample.
void describe_loops(const std::vector<LuGreInput>& inputs, const LuGreProblem& problem,
                    const LuGreClimb& climb, const LoopEffects& effects, double gear_ratio,
                    FittedLuGre& made) {
  LuGreFit& fit = made.fit;
  double squares = 0;
  Eigen::Index samples = 0;
  for (std::size_t r = 0; r < inputs.size(); ++r) {
    const joint::Recording& recording = *inputs[r].recording;
    const Eigen::Index column = LuGreProblem::gravity_column(climb.free, r);
    const auto half_width = [&](Eigen::Index k) { return climb.standing(k, 1).half_width; };
    LuGreLoop loop;
    loop.recording = recording.name;
    LuGreSignals signals;
    const LuGreLoopModel& model = problem.models()[r];
    Eigen::VectorXd residuals = model.residuals(climb.point.shared, climb.point.locals[r]);
    const LuGreLocal local =
        followed_from_the_start(model, climb.point.shared, climb.point.locals[r]);
    if (model.rows_left_out() > 0) {
      residuals.head(model.rows_left_out()) =
          model.residuals(climb.point.shared, local).head(model.rows_left_out());
    }
    const auto part = residuals.tail(model.rows() - model.rows_left_out());
    loop.residual_Nm = std::sqrt(part.squaredNorm() / static_cast<double>(part.size()));
    squares += part.squaredNorm();
    samples += part.size();
    signals.torque_Nm.reserve(recording.size());
    for (Eigen::Index i = 0; i < residuals.size(); ++i) {
      signals.torque_Nm.push_back(recording.torque_Nm[static_cast<std::size_t>(i)] + residuals(i));
    }
    loop.height_Nm = model.height_Nm();
    loop.samples_left_out = static_cast<std::size_t>(model.rows_left_out());
    if (loop.samples_left_out > 0) {
      loop.left_out_s = recording.t_s[loop.samples_left_out] - recording.t_s.front();
    }
    const Compared seen = compared(recording, model, signals.torque_Nm);
    loop.misfit = loop_misfit(seen.recording, seen.model_Nm, seen.speed_rad_s);
    if (inputs[r].traced == nullptr) {
      loop.cycle_misfit = cycle_misfit(seen.recording, seen.model_Nm, inputs[r].frequency_Hz());
    }
    if (climb.free.starts) {
      loop.gravity_Nm = statistics::symmetric_estimate(
          climb.point.locals[r].gravity_Nm, half_width(column), {"interval.lugre_fit_blocks"});
      // The loop shows the deflection at its start within an interval; where that holds zero, the
      // arm started from rest and z = 0 is the simpler truth.
      loop.start_deflection_rad = local.start_rad;
      const double start = std::abs(loop.start_deflection_rad) <= half_width(column + 1)
                               ? 0.0
                               : loop.start_deflection_rad;
      model.bristle(climb.point.shared, start, signals.z_rad, signals.dz_rad_s);
    }
    describe_motion(inputs[r], model, climb, gear_ratio, signals, loop);
    // Loops of other sizes cross the same angle at other torques: bins of the angle mix them.
    loop.systematic_Nm = loop.traced ? systematic_of_traced(recording, inputs[r], signals, loop)
                         : loop.cycle_misfit.is_known() ? loop.cycle_misfit.systematic_Nm
                                                        : loop.misfit.systematic_Nm;
    loop.systematic_Nm = std::hypot(loop.systematic_Nm, effects.misfit_Nm(r));
    fit.loops.push_back(std::move(loop));
    made.signals.push_back(std::move(signals));
  }
  const Eigen::Index freedom = samples - climb.linear.r_factor.cols();
  fit.residual_Nm = std::sqrt(squares / std::max(1.0, static_cast<double>(freedom)));
}

PositionMean gravity_over_positions(const std::vector<LuGreInput>& inputs, const LuGreFit& fit,
                                    double gear_ratio, const gravity::Ripple& ripple) {
  std::vector<statistics::Estimate> each;
  std::vector<double> angle;
  for (std::size_t r = 0; r < inputs.size(); ++r) {
    each.push_back(present(fit.loops[r].gravity_Nm));
    angle.push_back(gear_ratio * inputs[r].centre_rad());
  }
  return mean_over_positions(each, angle, ripple,
                             {"interval.scatter_of_half_cycles_and_recordings"});
}

void add_columns(const Eigen::MatrixXd& more, Eigen::MatrixXd& to) {
  to.conservativeResize(more.rows(), to.cols() + more.cols());
  to.rightCols(more.cols()) = more;
}

Statement what_is_not_shown(LuGreRung rung, const LuGreFit& fit) {
  switch (rung) {
    case LuGreRung::elastic:
      return {"lugre.loops_do_not_bend", {{"elastic_up_to_Nm", fit.height_Nm / 2}}};
    case LuGreRung::level:
      return {"lugre.loops_too_slow", {{"peak_speed_rad_s", fit.peak_speed_rad_s}}};
    case LuGreRung::curvature:
      return {"lugre.stribeck_not_apart", {{"peak_speed_rad_s", fit.peak_speed_rad_s}}};
    case LuGreRung::whole:
      return {};
  }
  return {};
}

/// Of each recording.
std::vector<std::size_t> samples_in_rows(const LuGreProblem& problem) {
  std::vector<std::size_t> samples;
  for (const LuGreLoopModel& model : problem.models()) samples.push_back(model.samples_in_row());
  return samples;
}

/// States where neighbouring samples were averaged.
void add_grain(const std::vector<std::size_t>& samples_in_row, LuGreFit& fit) {
  for (std::size_t r = 0; r < fit.loops.size(); ++r) {
    if (samples_in_row[r] == 1) continue;
    fit.reason.add({"lugre.neighbours_averaged",
                    {{"recording", fit.loops[r].recording}, {"samples", samples_in_row[r]}}});
  }
}

/// States where the start of a loop was left out, by the longest.
void add_starts(LuGreFit& fit) {
  const auto longest = std::max_element(
      fit.loops.begin(), fit.loops.end(),
      [](const LuGreLoop& a, const LuGreLoop& b) { return a.left_out_s < b.left_out_s; });
  if (longest == fit.loops.end() || longest->samples_left_out == 0) return;
  const auto loops = std::count_if(fit.loops.begin(), fit.loops.end(),
                                   [](const LuGreLoop& l) { return l.samples_left_out > 0; });
  std::size_t samples = 0;
  for (const LuGreLoop& loop : fit.loops) samples += loop.samples_left_out;
  fit.reason.add({"lugre.start_left_out",
                  {{"loops", static_cast<std::size_t>(loops)},
                   {"samples", samples},
                   {"recording", longest->recording},
                   {"longest_s", longest->left_out_s}}});
}

/// The misfit of the loop that noise explains worst; empty where it explains all of them.
Statement worst_misfit(const LuGreFit& fit) {
  const LuGreLoop* worst = nullptr;
  const auto share = [](const LuGreLoop& loop) {
    return loop.residual_Nm / loop.traced->explained_Nm;
  };
  for (const LuGreLoop& loop : fit.loops) {
    if (loop.traced && (worst == nullptr || share(loop) > share(*worst))) worst = &loop;
  }
  return worst == nullptr
             ? Statement{}
             : described_misfit(worst->recording, present(worst->traced), worst->residual_Nm);
}

}  // namespace

std::string to_string(LuGreParameterName name) {
  constexpr EnumTexts<LuGreParameterName> keys(
      "bristle_stiffness_Nm_rad", "bristle_damping_Nms_rad", "viscous_Nms_rad", "static_Nm",
      "coulomb_Nm", "stribeck_speed_rad_s", "speed_weakening_Nms2_rad2", "inertia_kgm2");
  return std::string(keys.of(name));
}

std::string to_string(LoopMotion motion) { return own_name(motion); }

const LuGreLoop* LuGreFit::worst_described() const {
  const auto worst =
      std::max_element(loops.begin(), loops.end(), [](const LuGreLoop& a, const LuGreLoop& b) {
        return a.systematic_Nm * b.height_Nm < b.systematic_Nm * a.height_Nm;
      });
  return worst == loops.end() ? nullptr : &*worst;
}

std::optional<double> LuGreFit::misfit_share() const {
  const LuGreLoop* worst = converged ? worst_described() : nullptr;
  if (worst == nullptr || !(worst->height_Nm > 0)) return std::nullopt;
  return worst->systematic_Nm / worst->height_Nm;
}

std::optional<statistics::Estimate> LuGreFit::shown(LuGreParameterName name) const {
  for (const LuGreParameter& p : parameters) {
    if (p.name == name) return p.estimate;
  }
  return std::nullopt;
}

FittedLuGre fit_lugre(const std::vector<LuGreInput>& loops, double gear_ratio, double q_peak_rad,
                      const gravity::Ripple& ripple, const KnownOfLoops& known) {
  if (loops.empty()) throw std::invalid_argument("no loops");
  FittedLuGre made;
  LuGreFit& fit = made.fit;
  LuGreProblem problem = problem_of(loops, gear_ratio, q_peak_rad, all_samples);
  describe_excitation(loops, problem, fit);
  if (!(fit.height_Nm > 0)) {
    fit.reason = {"lugre.no_friction_to_fit"};
    return made;
  }
  LuGreClimb climb = climb_from_coarse(loops, gear_ratio, q_peak_rad, problem);
  fit.iterations = climb.evaluations;
  fit.rung = climb.rung;
  if (!climb.converged) {
    fit.reason = {"lugre.not_converged"};
    return made;
  }
  fit.converged = true;
  const LoopEffects effects(problem, climb, ripple, known.effects);
  if (!effects.empty()) {
    problem = effects.taken_off(problem);
    climb = solved_again(std::move(climb), problem, half_loop_blocks(loops, problem));
  }
  Eigen::MatrixXd& shifts = climb.linear.fit.further_shifts;  // that of an open fall, or none
  if (!effects.empty()) add_columns(effects.shifts(), shifts);
  add_columns(shifts_by_motion_noise(loops, climb, gear_ratio, q_peak_rad), shifts);
  fit.damping_fall =
      fall_of_damping(climb, problem, effects.contact_Nm(problem), known.inertia_kgm2);
  climb.around.covariance += shifts * shifts.transpose();
  const double omega = 2 * std::numbers::pi * fit.frequency_Hz;
  fit.parameters = read_lugre_parameters(climb, effects, fit.peak_speed_rad_s);
  fit.identifiability =
      lugre_identifiability(climb, fit.peak_speed_rad_s, omega * fit.peak_speed_rad_s);
  const std::vector<std::size_t> samples_in_row = samples_in_rows(problem);
  if (std::any_of(samples_in_row.begin(), samples_in_row.end(),
                  [](std::size_t together) { return together > 1; })) {
    problem = LuGreProblem({});  // its room is wanted for the next
    problem = effects.taken_off(problem_of(loops, gear_ratio, q_peak_rad, every_sample));
  }
  describe_loops(loops, problem, climb, effects, gear_ratio, made);
  if (climb.free.starts && leaves_what_repeats(fit)) {
    fit.contacts = compare_contacts(
        loops, effects.taken_off(problem_of(loops, gear_ratio, q_peak_rad, thinned), false),
        thinned_blocks(loops), climb.point, systematic_of_all(fit), gear_ratio, q_peak_rad);
  }
  if (climb.free.starts) {
    made.positions = gravity_over_positions(loops, fit, gear_ratio, ripple);
    fit.gravity_Nm = made.positions->freedom > 0
                         ? made.positions->gravity_Nm
                         : gravity::with_ripple(made.positions->gravity_Nm, ripple);
  }
  fit.reason = what_is_not_shown(climb.rung, fit);
  const auto stiffness = fit.shown(LuGreParameterName::bristle_stiffness);
  const auto level = fit.shown(LuGreParameterName::static_torque);
  if (stiffness && level && fit.motor_amplitude_rad * stiffness->value < level->value) {
    fit.reason.add({"lugre.static_torque_extrapolated",
                    {{"way_to_sliding_percent",
                      100 * fit.motor_amplitude_rad * stiffness->value / level->value}}});
  }
  add_grain(samples_in_row, fit);
  add_starts(fit);
  fit.reason.add(worst_misfit(fit));
  fit = with_experiments(std::move(fit), gear_ratio, std::nullopt);
  return made;
}

}  // namespace tribolog::method::hysteresis
