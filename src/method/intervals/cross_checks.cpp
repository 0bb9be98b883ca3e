#include "method/intervals/cross_checks.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "joint/gravity_load.h"

namespace tribolog::method::intervals {
namespace {

struct Method {
  std::string name, words, cause;
};

const std::vector<Method>& methods() {
  static const std::vector<Method> all{
      {"midline", "mid-line", "ripple at the position of the oscillation would do that"},
      {"AB", "mean of A and B", "a loop that is not yet steady would do that"},
      {"CD", "mean of C and D", "a loop that is not yet steady would do that"},
      {"EF", "mean of E and F", "a loop that is not yet steady would do that"},
      {"fit", "LuGre model fitted to the loops",
       "friction that LuGre does not describe would do that"},
      {"sweep", "rough sweep",
       "torque ripple, friction that depends on the load, or a torque that is not zero without "
       "load would do that"},
      {"runs", "gravity from the runs", "friction that depends on load or direction would do that"},
      {"sweep_directions", "mean of the sweep's directions at equal angle",
       "a constant offset of the torque, or friction that differs with the direction would do "
       "that"},
      {"run_directions", "mean of both directions of the runs",
       "a constant offset of the torque, or friction that differs with the direction would do "
       "that"},
      {"classical", "linear least squares over everything that moves",
       "the linear model has no Stribeck effect and no bend of the viscous friction, which it "
       "takes for "
       "gravity where angles and speeds are not balanced"}};
  return all;
}

/// The methods at hand, in the order of the table above.
std::vector<CrossCheck> collect(const ChainResults& r) {
  std::vector<CrossCheck> checks;
  for (const Method& method : methods()) {
    CrossCheck check;
    check.method = method.name;
    if (const hysteresis::SurrogateMass* mass = r.masses.find(method.name)) {
      check.gravity_Nm = mass->gravity_Nm;
    } else if (const selection::GravityByOtherWay* way = r.other_ways.find(method.name)) {
      check.gravity_Nm = way->gravity_Nm;
    } else {
      continue;
    }
    checks.push_back(std::move(check));
  }
  return checks;
}

const GravityDifference* find(const std::vector<GravityDifference>& all, const std::string& name) {
  const auto it = std::find_if(all.begin(), all.end(),
                               [&](const GravityDifference& d) { return d.method == name; });
  return it == all.end() ? nullptr : &*it;
}

std::string cause_of(const std::string& method) {
  for (const Method& m : methods()) {
    if (m.name == method) return m.cause;
  }
  return "";
}

std::string finding(const CrossCheck& check, const CrossCheck& recommended) {
  return fmt::format(
      "{} and {} disagree: {:.3f} kg against {:.3f} kg, a difference of {:+.2f} % where {:.2g} % "
      "would be within its interval; {}",
      method_in_words(recommended.method), method_in_words(check.method), recommended.mass_kg.value,
      check.mass_kg.value, check.difference_percent, check.difference_half_width_percent,
      cause_of(check.method));
}

}  // namespace

std::string method_in_words(const std::string& method) {
  for (const Method& m : methods()) {
    if (m.name == method) return m.words;
  }
  return method;
}

CrossChecksResult cross_check(const ChainResults& r, const IntervalsResult& intervals) {
  CrossChecksResult out;
  out.classical = r.other_ways.classical;
  std::vector<CrossCheck> checks = collect(r);
  const auto recommended = std::find_if(checks.begin(), checks.end(), [&](const CrossCheck& c) {
    return c.method == r.selection.recommended;
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
    if (check.is_recommended) half_width = 0;
    const double difference = check.gravity_Nm.value - ours.value;
    check.difference_percent = 100 * difference / ours.value;
    check.difference_half_width_percent = 100 * half_width / std::abs(ours.value);
    check.difference_in_intervals = half_width > 0 ? std::abs(difference) / half_width : 0.0;
    check.disagrees = !check.is_recommended && std::abs(difference) > half_width &&
                      std::abs(difference) > least_difference * std::abs(ours.value);
    out.doubtful = out.doubtful || (check.disagrees && check.method != "classical");
  }
  for (const CrossCheck& check : checks) {
    if (check.disagrees) out.findings.push_back(finding(check, *recommended));
  }
  out.checks = std::move(checks);
  return out;
}

}  // namespace tribolog::method::intervals
