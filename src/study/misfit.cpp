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
#include "base/requirements.h"
#include "identify/identify.h"
#include "joint/degrees.h"
#include "simulate/simulate_joint.h"
#include "statistics/distributions.h"
#include "study/misfit_runs.h"
#include "study/misfit_truths.h"
#include "study/study.h"

namespace tribolog::study {
namespace {

using joint::Quantity;
using simulate::Scenario;

constexpr std::size_t joints_of_the_study = 4;

/// Whether a finding, or a reason against a quantity, names the cause.
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
  const auto has_name = [&](const std::vector<Statement>& all) {
    return std::any_of(all.begin(), all.end(), is_named);
  };
  return has_name(judgement.findings) ||
         std::any_of(judgement.quantities.begin(), judgement.quantities.end(),
                     [&](const auto& q) { return has_name(q.reasons); });
}

/// Of a normal error, to be beyond its 95 % interval and beyond what matters.
/// @param half_width of the interval, in terms of what matters.
double chance_of_wrong(double half_width) {
  const double matters = half_width > 0 ? statistics::normal_975 / half_width
                                        : std::numeric_limits<double>::infinity();
  return std::erfc(std::max(matters, statistics::normal_975) / std::numbers::sqrt2);
}

/// What one run found, if anything, against the truth in it.
void count(const calibration::QuantityVerdict& run, double truth, MisfitQuantity& q) {
  if (!run.estimate || run.verdict == calibration::Verdict::not_identifiable) return;
  const statistics::Estimate& found = present(run.estimate);
  ++q.found;
  const bool is_usable = run.verdict == calibration::Verdict::usable;
  q.usable += is_usable ? 1 : 0;
  if (std::isnan(truth)) return;
  ++q.judged;
  const double matters = bound_of(q.quantity, truth);
  const bool inside = found.low <= truth && truth <= found.high;
  double off = found.value - truth;
  if (q.quantity == Quantity::cog_angle) off = std::remainder(off, 2 * std::numbers::pi);
  off = std::abs(off) / matters;
  const bool is_wrong = !inside && off > 1;
  q.inside += inside ? 1 : 0;
  q.rms_error += off * off;
  q.half_width += found.half_width() / matters;
  q.wrong += is_wrong ? 1 : 0;
  q.wrong_usable += is_wrong && is_usable ? 1 : 0;
  if (!is_usable) return;
  q.worst_usable = std::max(q.worst_usable, off);
  q.by_chance += chance_of_wrong(found.half_width() / matters);
}

const calibration::QuantityVerdict* find(const MisfitRun& run, Quantity quantity) {
  const auto it = std::find_if(run.quantities.begin(), run.quantities.end(),
                               [&](const auto& one) { return one.quantity == quantity; });
  return it != run.quantities.end() ? &*it : nullptr;
}

/// Whether a number is wrong, or less usable than on the sound joint with the same noise.
bool is_harmed(const MisfitRun& run, const MisfitRun& sound) {
  constexpr auto usable = calibration::Verdict::usable;
  for (const calibration::QuantityVerdict& one : sound.quantities) {
    const calibration::QuantityVerdict* now = find(run, one.quantity);
    if (one.verdict == usable && (now == nullptr || now->verdict != usable)) return true;
    const auto truth = run.truths.find(one.quantity);
    if (now == nullptr || truth == run.truths.end()) continue;
    MisfitQuantity alone{one.quantity};
    count(*now, truth->second, alone);
    if (alone.wrong > 0) return true;
  }
  return false;
}

/// Over all runs. @param truths of the quantity in each of them.
MisfitQuantity counted(Quantity quantity, const std::vector<MisfitRun>& runs,
                       const std::vector<double>& truths) {
  const bool is_one = std::all_of(truths.begin(), truths.end(),
                                  [&](double truth) { return truth == truths.front(); });
  MisfitQuantity q{quantity, is_one ? truths.front() : std::numeric_limits<double>::quiet_NaN()};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (const auto* found = find(runs[k], quantity)) count(*found, truths[k], q);
  }
  if (q.judged > 0) {
    q.rms_error = std::sqrt(q.rms_error / static_cast<double>(q.judged));
    q.half_width /= static_cast<double>(q.judged);
  }
  return q;
}

/// @param sound runs of the joint without disturbance: of a case of such runs, filled with them.
MisfitCase run_misfit_case(const MisfitJoint& joint, const Disturbance* disturbance, double size,
                           const MisfitOptions& options, std::vector<MisfitRun>& sound) {
  Scenario laid = joint.scenario;
  if (disturbance != nullptr) disturbance->lay(laid, size);
  const std::vector<simulate::IdealRecording> ideal = simulate::simulate_ideal_joint(laid);
  const std::map<Quantity, double> truths = truths_of(joint.scenario, laid, ideal);
  MisfitCase out;
  out.joint = joint.key;
  if (disturbance != nullptr) out.disturbance = disturbance->key;
  out.size = size;
  out.runs = options.runs;
  out.has_cause = disturbance != nullptr && disturbance->sound_at != size;
  std::vector<MisfitRun> runs(options.runs);
  std::vector<char> is_named(options.runs);
  parallel_for(
      options.runs,
      [&](std::size_t run) {
        const simulate::Noise noise = noise_of_run(laid.noise, options.seed, run);
        const auto keep = run == 0 ? options.keep_logs : KeepLogs{};
        const calibration::Judgement judgement =
            identified(out, laid, ideal, noise, keep, options.unstated);
        is_named[run] = out.has_cause && names(judgement, *disturbance) ? 1 : 0;
        runs[run] = {judgement.quantities, truths};
      },
      options.threads);
  out.quantities = count_runs(runs);
  if (disturbance == nullptr) sound = runs;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const bool named = is_named[k] != 0;
    const bool harmed = out.has_cause && is_harmed(runs[k], sound.at(k));
    out.named += named ? 1 : 0;
    out.harmed += harmed ? 1 : 0;
    out.harmed_and_named += harmed && named ? 1 : 0;
  }
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

calibration::Judgement identified(const MisfitCase& of, const simulate::Scenario& laid,
                                  std::vector<simulate::IdealRecording> ideal,
                                  const simulate::Noise& noise, const KeepLogs& keep,
                                  bool unstated) {
  std::vector<joint::Recording> logs =
      simulate::with_noise(std::move(ideal), noise, laid.gear_ratio);
  if (keep) keep(of, laid, logs);
  identify::IdentifyOptions how;
  how.seed = noise.seed;
  how.threads = 1;
  joint::Dataset dataset = simulate::simulated_dataset(laid, std::move(logs));
  if (unstated) dataset.manifest.effects = {};
  return identify::identify(dataset, how).judgement;
}

std::vector<MisfitQuantity> count_runs(const std::vector<MisfitRun>& runs) {
  std::vector<MisfitQuantity> all;
  for (const auto& quantity : runs.front().quantities) {
    std::vector<double> truths;
    for (const MisfitRun& run : runs) {
      const auto truth = run.truths.find(quantity.quantity);
      if (truth != run.truths.end()) truths.push_back(truth->second);
    }
    if (truths.size() < runs.size()) continue;
    all.push_back(counted(quantity.quantity, runs, truths));
  }
  return all;
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
    laid = picked(options.lacks ? lacks() : disturbances(), options.disturbances, "disturbance");
    if (options.joints.empty() && !options.lacks) joints.resize(joints_of_the_study);
  }
  std::size_t all = 0;
  for (const Disturbance& d : laid) all += d.sizes.size() * joints.size();
  all += joints.size();
  std::vector<MisfitCase> out;
  std::vector<MisfitRun> sound;
  const auto run = [&](const MisfitJoint& joint, const Disturbance* d, double size) {
    if (progress) {
      progress(fmt::format("{}, {} {:g}", joint.key, d == nullptr ? "sound" : d->key, size),
               out.size(), all);
    }
    out.push_back(run_misfit_case(joint, d, size, options, sound));
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
