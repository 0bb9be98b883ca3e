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
#include "friction/lugre.h"
#include "identify/identify.h"
#include "joint/degrees.h"
#include "simulate/simulate_joint.h"
#include "statistics/distributions.h"
#include "study/misfit_scenario.h"
#include "study/study.h"

namespace tribolog::study {
namespace {

using joint::Quantity;
using simulate::Scenario;

constexpr std::size_t joints_of_the_study = 4;
constexpr double no_truth = std::numeric_limits<double>::quiet_NaN();

/// What an error-free identification would find, by the verdict's keys; SI, motor side.
std::map<Quantity, double> truths_of(const Scenario& undisturbed, const Scenario& laid) {
  const LuGreParameters& p = lugre_of(undisturbed);
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
      const statistics::Estimate& found = present(it->estimate);
      ++q.found;
      const bool is_usable = it->verdict == calibration::Verdict::usable;
      q.usable += is_usable ? 1 : 0;
      if (std::isnan(q.truth)) continue;
      const bool inside = found.low <= q.truth && q.truth <= found.high;
      double off = found.value - q.truth;
      if (q.quantity == Quantity::cog_angle) off = std::remainder(off, 2 * std::numbers::pi);
      off = std::abs(off) / bound_of(q.quantity, q.truth);
      const bool is_wrong = !inside && off > 1;
      q.inside += inside ? 1 : 0;
      q.rms_error += off * off;
      q.half_width += found.half_width() / bound_of(q.quantity, q.truth);
      q.wrong += is_wrong ? 1 : 0;
      q.wrong_usable += is_wrong && is_usable ? 1 : 0;
      if (!is_usable) continue;
      q.worst_usable = std::max(q.worst_usable, off);
      q.by_chance += chance_of_wrong(found.half_width() / bound_of(q.quantity, q.truth));
    }
    if (q.found > 0) {
      q.rms_error = std::sqrt(q.rms_error / static_cast<double>(q.found));
      q.half_width /= static_cast<double>(q.found);
    }
    out.quantities.push_back(q);
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
