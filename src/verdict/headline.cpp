#include "verdict/headline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "calibration/friction_speeds.h"
#include "calibration/quantity_verdict.h"
#include "method/checks/data_check.h"
#include "verdict/quantity_rooms.h"

namespace tribolog::verdict {
namespace {

using calibration::FrictionAtSpeed;
using calibration::QuantityVerdict;
using calibration::Verdict;
using joint::Quantity;

double percent_of(const statistics::Estimate& e) {
  return 100 * e.half_width() / std::abs(e.value);
}

/// Over the widest stretch of speeds at which friction is usable; the least well known of them.
Statement friction_known(const std::vector<FrictionAtSpeed>& all, bool has_gear) {
  const std::vector<calibration::SpeedRange> ranges = calibration::usable_ranges(all, 1);
  if (ranges.empty()) return {};
  const calibration::SpeedRange& range = ranges.front();
  double percent = 0;
  for (const FrictionAtSpeed& f : all) {
    if (f.speed_rad_s < range.low_rad_s || f.speed_rad_s > range.high_rad_s) continue;
    percent = std::max(percent, percent_of(f.torque_Nm));
  }
  if (range.low_rad_s == range.high_rad_s) {
    return {"verdict.friction_known_at", {{"percent", percent}, {"speed", range.low_rad_s}}};
  }
  return {has_gear ? Code("verdict.friction_known") : Code("verdict.friction_known_at_joint"),
          {{"percent", percent}, {"slowest", range.low_rad_s}, {"fastest", range.high_rad_s}}};
}

Statement quantity_known(const calibration::Judgement& judgement, Quantity quantity) {
  const QuantityVerdict* const q = judgement.find(quantity);
  if (q == nullptr || !q->decides || q->verdict != Verdict::usable || !q->estimate) return {};
  return {"verdict.quantity_known",
          {{"quantity", Statement(Code::of("quantity." + to_string(quantity)))},
           {"percent", percent_of(q->budget ? q->budget->expanded : *q->estimate)}}};
}

/// Friction, by its curve or else by its torques, and gravity.
std::vector<Statement> what_is_known(const calibration::Judgement& judgement, bool has_gear) {
  std::vector<Statement> known;
  const auto add = [&](const Statement& one) {
    if (!one.empty()) known.push_back(one);
  };
  add(friction_known(judgement.friction_at_speed, has_gear));
  if (known.empty()) add(quantity_known(judgement, Quantity::coulomb_torque));
  if (known.empty()) add(quantity_known(judgement, Quantity::break_away_torque));
  add(quantity_known(judgement, Quantity::gravity_torque));
  return known;
}

/// Of a check that fails what it found, under its title: the consequence stands in the findings.
Statement in_short(const calibration::Calibration& c, const Statement& reason) {
  for (const method::checks::DataCheck* check :
       c.data_checks.in_state(method::checks::CheckState::fails)) {
    const StatedValue found{"found", check->found};
    const auto& values = reason.values();
    if (std::find(values.begin(), values.end(), found) == values.end()) continue;
    return {"verdict.check",
            {{"check", Statement(Code::of("check." + to_string(check->name)))}, found}};
  }
  return reason;
}

/// The reason that the most of the numbers that decide share, and one that has it: gravity's torque
/// or the curve before others.
Statement why_not_usable(const calibration::Calibration& c,
                         const calibration::Judgement& judgement) {
  const auto has = [](const QuantityVerdict& q, const Statement& reason) {
    return q.decides && q.verdict != Verdict::usable &&
           std::find(q.reasons.begin(), q.reasons.end(), reason) != q.reasons.end();
  };
  Statement why;
  std::ptrdiff_t most = 0;
  for (const QuantityVerdict& q : judgement.quantities) {
    for (const Statement& reason : q.reasons) {
      const auto share =
          std::count_if(judgement.quantities.begin(), judgement.quantities.end(),
                        [&](const QuantityVerdict& one) { return has(one, reason); });
      if (!has(q, reason) || share <= most) continue;
      most = share;
      why = reason;
    }
  }
  if (why.empty()) return {};
  const QuantityVerdict* named = nullptr;
  for (const Quantity first : {Quantity::gravity_torque, Quantity::viscous_curve}) {
    const QuantityVerdict* const one = judgement.find(first);
    if (named == nullptr && one != nullptr && has(*one, why)) named = one;
  }
  if (named == nullptr) {
    named = &*std::find_if(judgement.quantities.begin(), judgement.quantities.end(),
                           [&](const QuantityVerdict& one) { return has(one, why); });
  }
  const std::vector<StatedValue> values{
      {"quantity", Statement(Code::of("quantity." + to_string(named->quantity)))},
      {"why", in_short(c, why)}};
  return Statement::with(named->verdict == Verdict::doubtful ? Code("verdict.quantity_doubtful")
                                                             : Code("verdict.quantity_unknown"),
                         values);
}

/// What makes a joint doubtful of which something is known.
Statement what_decides(const calibration::Calibration& c, const calibration::Judgement& judgement) {
  if (c.cross_checks.doubtful && !c.cross_checks.findings.empty()) {
    return {"verdict.estimates_disagree", {{"why", c.cross_checks.findings.front()}}};
  }
  if (Statement why = why_not_usable(c, judgement); !why.empty()) return why;
  for (const QuantityVerdict& q : judgement.quantities) {
    for (const calibration::LimitOutcome& limit : q.limits) {
      if (limit.state == calibration::LimitState::inside) continue;
      return {"verdict.limit_not_kept", {{"why", limit.outcome}}};
    }
  }
  return {};
}

/// No more than its motion was found.
Statement without_torque(const calibration::Calibration& c) {
  for (const Statement& note : c.notes) {
    if (!note.is("reading.effort_not_read")) continue;
    return Statement::with("verdict.torque_not_read", note.values());
  }
  return {"verdict.no_torque"};
}

Statement not_identifiable(const calibration::Calibration& c,
                           const calibration::Judgement& judgement) {
  const auto failing = c.data_checks.in_state(method::checks::CheckState::fails);
  if (!failing.empty() && c.q_peak_rad && c.selection.recommended) {
    return {"verdict.data_cannot_carry", {{"found", failing.front()->found}}};
  }
  const auto is_known = [&](Quantity quantity) {
    const QuantityVerdict* const q = judgement.find(quantity);
    return q != nullptr && q->verdict != Verdict::not_identifiable;
  };
  if (is_known(Quantity::cog_angle)) return {"verdict.no_mass"};
  const bool has_mass = is_known(Quantity::gravity_torque) &&
                        (is_known(Quantity::surrogate_mass) || c.manifest.torque_is_in_amperes);
  return has_mass ? Statement{"verdict.no_angle"} : Statement{"verdict.neither_angle_nor_mass"};
}

}  // namespace

Statement headline(const calibration::Calibration& c, const calibration::Judgement& judgement,
                   bool without_gravity) {
  if (c.manifest.drive.kind() == joint::EffortKind::none) return without_torque(c);
  if (judgement.verdict == Verdict::not_identifiable) return not_identifiable(c, judgement);
  std::vector<Statement> parts = what_is_known(judgement, c.manifest.drive.gear_ratio() != 1.0);
  const bool is_usable = judgement.verdict == Verdict::usable;
  if (without_gravity) parts.push_back({"verdict.without_gravity"});
  if (!is_usable) {
    if (Statement why = what_decides(c, judgement); !why.empty()) parts.push_back(std::move(why));
  } else if (has_points_alone(c)) {
    parts.push_back({"verdict.friction_points_alone"});
  } else if (!without_gravity) {
    parts.push_back({"verdict.masses_agree"});
  }
  if (parts.empty()) return {"verdict.nothing_usable"};
  return {"verdict.headline", {{"parts", std::move(parts)}}};
}

}  // namespace tribolog::verdict
