#include "truth/what_if.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/parallel_for.h"
#include "method/motion/torque_lag.h"
#include "statistics/order_statistics.h"
#include "statistics/sampled_signal.h"
#include "truth/identified_joint.h"

namespace tribolog::truth {
namespace {

using calibration::Unexcluded;
using calibration::WhatIf;

double shortest_interval_s(const joint::Dataset& dataset) {
  double shortest = 0;
  for (const joint::Recording& r : dataset.recordings) {
    const double dt = statistics::median_interval(r.t_s);
    if (dt > 0 && (shortest == 0 || dt < shortest)) shortest = dt;
  }
  return shortest;
}

std::vector<WhatIf> effects_of(const IdentifiedJoint& joint, const calibration::Calibration& c) {
  const method::session::SessionFriction& session = c.session;
  std::vector<WhatIf> all;
  const auto add = [&](Unexcluded effect, double size, const char* unit) {
    if (std::isfinite(size) && size > 0) all.push_back({effect, size, unit, {}});
  };
  add(Unexcluded::lag,
      c.torque_lag.lag_s ? c.torque_lag.lag_s->half_width() : shortest_interval_s(joint.dataset),
      "s");
  if (session.direction.examined)
    add(Unexcluded::asymmetry, session.direction.asymmetry.half_width(), "");
  if (session.load.examined) add(Unexcluded::load, session.load.per_load.half_width(), "");
  if (session.angle.examined) add(Unexcluded::angle, session.angle.amplitude.half_width(), "");
  if (session.drift.examined)
    add(Unexcluded::warm_up, (session.drift.high - session.drift.low) / 2, "");
  if (session.offset_drift.examined)
    add(Unexcluded::offset_drift, session.offset_drift.change_Nm.half_width(), "N·m");
  return all;
}

/// The torque that an effect adds to a sample.
struct Sample {
  double friction_Nm{};
  double level_Nm{};  ///< Largest friction of the recording.
  double gravity_Nm{};
  double q_rad{};
  double session_share{};  ///< 0 at the begin, 1 at the end.
};

double added_Nm(const WhatIf& effect, const Sample& s) {
  switch (effect.effect) {
    case Unexcluded::asymmetry:
      return effect.size * std::abs(s.friction_Nm);
    case Unexcluded::load:
      return effect.size * std::abs(s.gravity_Nm) * s.friction_Nm / s.level_Nm;
    case Unexcluded::angle:
      return effect.size * std::cos(2 * s.q_rad) * s.friction_Nm;
    case Unexcluded::warm_up:
      return effect.size * (s.session_share - 0.5) * s.friction_Nm;
    case Unexcluded::offset_drift:
      return effect.size * (s.session_share - 0.5);
    case Unexcluded::lag:
      break;
  }
  return 0;
}

/// @param gravity_Nm amplitude. @param q_peak_rad where it acts.
IdentifiedJoint with_effect(const IdentifiedJoint& joint, const WhatIf& effect, double gravity_Nm,
                            double q_peak_rad) {
  IdentifiedJoint changed = joint;
  const auto count = static_cast<double>(joint.dataset.recordings.size());
  for (std::size_t k = 0; k < changed.dataset.recordings.size(); ++k) {
    joint::Recording& r = changed.dataset.recordings[k];
    if (effect.effect == Unexcluded::lag) {
      r = method::motion::aligned(r, -effect.size);
      continue;
    }
    Sample s;
    for (const double friction : joint.friction_Nm[k])
      s.level_Nm = std::max(s.level_Nm, std::abs(friction));
    if (!(s.level_Nm > 0)) continue;
    for (std::size_t i = 0; i < r.size(); ++i) {
      s.friction_Nm = joint.friction_Nm[k][i];
      s.q_rad = r.q_rad[i];
      s.gravity_Nm = gravity_Nm * std::cos(s.q_rad - q_peak_rad);
      s.session_share =
          (static_cast<double>(k) + static_cast<double>(i) / static_cast<double>(r.size())) / count;
      r.torque_Nm[i] += added_Nm(effect, s);
    }
  }
  return changed;
}

}  // namespace

std::vector<WhatIf> what_if(const IdentifiedJoint& joint, const calibration::Calibration& c,
                            const std::vector<Reading>& without,
                            const PlainIdentification& identify, const TruthCheckOptions& options) {
  const method::hysteresis::SurrogateMass* mass = c.masses.find(c.selection.recommended);
  if (mass == nullptr || joint.put_in.empty()) return {};
  const double q_peak_rad = c.q_peak_rad ? c.q_peak_rad->value : 0;
  std::vector<WhatIf> effects = effects_of(joint, c);
  parallel_for(
      effects.size(),
      [&](std::size_t k) {
        const joint::Dataset simulated = with_noise(
            with_effect(joint, effects[k], mass->gravity_Nm.value, q_peak_rad), options.seed, 0);
        const std::vector<Reading> with = readings_of(identify(simulated, options.seed));
        for (const Reading& put_in : joint.put_in) {
          const Reading* before = find_reading(without, put_in.name);
          const Reading* after = find_reading(with, put_in.name);
          if (before == nullptr || after == nullptr) continue;
          effects[k].shifts.push_back(
              {put_in.name, unit_of(put_in.quantity), before->estimate.value,
               after->estimate.value - before->estimate.value, before->estimate.half_width()});
        }
      },
      options.threads);
  return effects;
}

}  // namespace tribolog::truth
