#include "method/intervals/cross_checks.h"

#include <algorithm>
#include <cmath>

#include "joint/gravity_load.h"
#include "statistics/distributions.h"

namespace tribolog::method::intervals {
namespace {

using hysteresis::Estimator;
using selection::IndependentMethod;

/// A gravity torque that is compared, and what would make it differ.
struct Compared {
  GravityMethod method;
  Code cause;
};

constexpr Compared compared[] = {
    {Estimator::midline, "cross_check.ripple_at_position"},
    {Estimator::AB, "cross_check.loop_not_steady"},
    {Estimator::CD, "cross_check.loop_not_steady"},
    {Estimator::EF, "cross_check.loop_not_steady"},
    {Estimator::fit, "cross_check.friction_beyond_lugre"},
    {Estimator::sweep, "cross_check.ripple_load_or_zero"},
    {Estimator::runs, "cross_check.friction_by_load_or_direction"},
    {IndependentMethod::sweep_directions, "cross_check.offset_or_direction"},
    {IndependentMethod::run_directions, "cross_check.offset_or_direction"},
    {IndependentMethod::classical, "cross_check.linear_model"}};

/// The gravity torque by a method; nullptr where it gave none.
const statistics::Estimate* gravity_by(const GravityMethod& method, const ChainResults& r) {
  if (const auto* estimator = std::get_if<Estimator>(&method)) {
    const hysteresis::SurrogateMass* mass = r.masses.find(*estimator);
    return mass == nullptr ? nullptr : &mass->gravity_Nm;
  }
  const selection::IndependentGravity* way =
      r.independent.find(std::get<IndependentMethod>(method));
  return way == nullptr ? nullptr : &way->gravity_Nm;
}

/// Half width of what a method's gravity shifts by if the sweep's offset is friction by direction.
double offset_ambiguity_Nm(const GravityMethod& method, const ChainResults& r) {
  const auto* estimator = std::get_if<Estimator>(&method);
  const hysteresis::SurrogateMass* mass =
      estimator == nullptr ? nullptr : r.masses.find(*estimator);
  return mass == nullptr ? 0.0 : mass->offset.ambiguity_Nm;
}

bool is_pair_mean(const GravityMethod& method) {
  const auto* estimator = std::get_if<Estimator>(&method);
  return estimator != nullptr && hysteresis::points_of_pair(*estimator);
}

/// Whether points that lie opposite each other on a sine do not on these loops.
bool is_no_sine(const hysteresis::HysteresisResult& loops) {
  constexpr double largest_harmonic = 0.005;
  return loops.midline_by_angle || std::any_of(loops.oscillations.begin(), loops.oscillations.end(),
                                               [](const hysteresis::Oscillation& o) {
                                                 return o.third_harmonic > largest_harmonic;
                                               });
}

/// The methods at hand, in the order of the table above.
std::vector<CrossCheck> collect(const ChainResults& r) {
  std::vector<CrossCheck> checks;
  for (const Compared& one : compared) {
    const statistics::Estimate* gravity = gravity_by(one.method, r);
    if (gravity == nullptr) continue;
    CrossCheck check;
    check.method = one.method;
    check.gravity_Nm = *gravity;
    check.is_biased = is_no_sine(r.hysteresis) && is_pair_mean(one.method);
    checks.push_back(std::move(check));
  }
  return checks;
}

const GravityDifference* find(const std::vector<GravityDifference>& all,
                              const GravityMethod& method) {
  const auto it = std::find_if(all.begin(), all.end(),
                               [&](const GravityDifference& d) { return d.method == method; });
  return it == all.end() ? nullptr : &*it;
}

/// @param recommended with which it disagrees.
Statement cause_of(const CrossCheck& check, const CrossCheck& recommended, const ChainResults& r) {
  const bool is_of_offset =
      offset_ambiguity_Nm(check.method, r) > 0 && offset_ambiguity_Nm(recommended.method, r) > 0;
  if (is_pair_mean(check.method) && is_of_offset) return {"cross_check.offset_or_direction"};
  for (const Compared& one : compared) {
    if (one.method == check.method) return one.cause;
  }
  return {};
}

Statement name_of(const GravityMethod& method) {
  return Code::of("estimator." + to_string(method));
}

Statement finding(const CrossCheck& check, const CrossCheck& recommended, const ChainResults& r) {
  return {"cross_check.disagree",
          {{"recommended", name_of(recommended.method)},
           {"other", name_of(check.method)},
           {"recommended_kg", recommended.mass_kg.value},
           {"other_kg", check.mass_kg.value},
           {"difference_percent", check.difference_percent},
           {"interval_percent", check.difference_half_width_percent},
           {"cause", cause_of(check, recommended, r)}}};
}

/// Probability of as large a difference between estimates of the same quantity.
double chance_of(const CrossCheck& check) {
  return std::erfc(statistics::normal_975 * check.difference_in_intervals / std::sqrt(2.0));
}

/// S. Holm, Scand. J. Statist. 6 (1979) 65-70: with many comparisons, some differ by chance. The
/// least likely is tested at the level divided by their number, the next at the level divided by
/// one less, until one passes.
void find_disagreements(std::vector<CrossCheck*> checks, double gravity_Nm) {
  constexpr double level = 0.05;
  std::sort(checks.begin(), checks.end(), [](const CrossCheck* a, const CrossCheck* b) {
    return a->difference_in_intervals > b->difference_in_intervals;
  });
  for (std::size_t k = 0; k < checks.size(); ++k) {
    if (chance_of(*checks[k]) > level / static_cast<double>(checks.size() - k)) return;
    checks[k]->disagrees =
        std::abs(checks[k]->gravity_Nm.value - gravity_Nm) > least_difference * gravity_Nm;
  }
}

/// The recommended torque, its interval wide enough for every method that disagrees.
statistics::Estimate widened(const CrossCheck& recommended, const std::vector<CrossCheck>& checks) {
  const statistics::Estimate& ours = recommended.gravity_Nm;
  double reach = 0;
  for (const CrossCheck& check : checks) {
    if (!check.counts() || !check.disagrees) continue;
    reach = std::max(reach, std::abs(check.gravity_Nm.value - ours.value) +
                                std::hypot(check.gravity_Nm.half_width(), ours.half_width()));
  }
  if (reach == 0) return ours;
  return statistics::symmetric_estimate(
      ours.value, reach, {"interval.widened_by_methods", {{"interval", ours.method}}});
}

}  // namespace

bool CrossCheck::counts() const {
  return !is_recommended && !is_biased && method != GravityMethod(IndependentMethod::classical);
}

CrossChecksResult cross_check(const ChainResults& r, const IntervalsResult& intervals) {
  CrossChecksResult out;
  out.classical = r.independent.classical;
  std::vector<CrossCheck> checks = collect(r);
  const auto recommended = std::find_if(checks.begin(), checks.end(), [&](const CrossCheck& c) {
    return r.selection.recommended && c.method == GravityMethod(*r.selection.recommended);
  });
  if (recommended == checks.end()) return out;
  recommended->is_recommended = true;
  const statistics::Estimate ours = recommended->gravity_Nm;
  // Shares of a gravity that cannot be told from none say nothing.
  if (!(ours.low > 0)) return out;
  const double kg_per_Nm =
      joint::surrogate_mass_kg(1.0, r.gear_ratio, r.masses.distance_m, r.masses.gravity_m_s2, 1.0);
  for (CrossCheck& check : checks) {
    check.mass_kg = statistics::scaled(check.gravity_Nm, kg_per_Nm);
    const GravityDifference* resampled = find(intervals.differences, check.method);
    double half_width = std::hypot(check.gravity_Nm.half_width(), ours.half_width());
    if (resampled != nullptr) {
      check.resampled_kg = statistics::scaled(resampled->gravity_Nm, kg_per_Nm);
      half_width = resampled->difference_Nm.half_width();
    }
    half_width = std::hypot(half_width, numerical_share * ours.value);
    // No resample draws it: all shift in the same sense, each by its own friction.
    half_width += std::abs(offset_ambiguity_Nm(check.method, r) -
                           offset_ambiguity_Nm(recommended->method, r));
    if (check.is_recommended) half_width = 0;
    const double difference = check.gravity_Nm.value - ours.value;
    check.difference_percent = 100 * difference / ours.value;
    check.difference_half_width_percent = 100 * half_width / std::abs(ours.value);
    check.difference_in_intervals = half_width > 0 ? std::abs(difference) / half_width : 0.0;
  }
  std::vector<CrossCheck*> compared_ones;
  std::vector<CrossCheck*> beside;
  for (CrossCheck& check : checks) {
    if (check.counts()) compared_ones.push_back(&check);
    if (!check.counts() && !check.is_recommended) beside.push_back(&check);
  }
  find_disagreements(compared_ones, ours.value);
  find_disagreements(beside, ours.value);
  const statistics::Estimate wide = widened(*recommended, checks);
  out.doubtful =
      wide.half_width() > ours.half_width() && wide.half_width() > largest_spread * ours.value;
  if (wide.half_width() > ours.half_width() && !out.doubtful) out.widened_gravity_Nm = wide;
  for (const CrossCheck& check : checks) {
    // What the motion biases is told where its harmonics are, and is in the table.
    if (check.disagrees && !check.is_biased) {
      out.findings.push_back(finding(check, *recommended, r));
    }
  }
  out.checks = std::move(checks);
  return out;
}

}  // namespace tribolog::method::intervals
