#include "method/intervals/cross_checks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "joint/gravity_load.h"

namespace tribolog::method::intervals {
namespace {

/// A gravity torque that is compared, and what would make it differ.
struct Method {
  const char* name;
  Code cause;
};

constexpr std::array<Method, 10> methods{{{"midline", "cross_check.ripple_at_position"},
                                          {"AB", "cross_check.loop_not_steady"},
                                          {"CD", "cross_check.loop_not_steady"},
                                          {"EF", "cross_check.loop_not_steady"},
                                          {"fit", "cross_check.friction_beyond_lugre"},
                                          {"sweep", "cross_check.ripple_load_or_zero"},
                                          {"runs", "cross_check.friction_by_load_or_direction"},
                                          {"sweep_directions", "cross_check.offset_or_direction"},
                                          {"run_directions", "cross_check.offset_or_direction"},
                                          {"classical", "cross_check.linear_model"}}};

/// The methods at hand, in the order of the table above.
std::vector<CrossCheck> collect(const ChainResults& r) {
  std::vector<CrossCheck> checks;
  for (const Method& method : methods) {
    CrossCheck check;
    check.method = method.name;
    if (const hysteresis::SurrogateMass* mass = r.masses.find(method.name)) {
      check.gravity_Nm = mass->gravity_Nm;
    } else if (const selection::IndependentGravity* way = r.independent.find(method.name)) {
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

Statement cause_of(const std::string& method) {
  for (const Method& m : methods) {
    if (m.name == method) return m.cause;
  }
  return {};
}

Statement name_of(const std::string& method) { return Code::of("estimator." + method); }

Statement finding(const CrossCheck& check, const CrossCheck& recommended) {
  return {"cross_check.disagree",
          {{"recommended", name_of(recommended.method)},
           {"other", name_of(check.method)},
           {"recommended_kg", recommended.mass_kg.value},
           {"other_kg", check.mass_kg.value},
           {"difference_percent", check.difference_percent},
           {"interval_percent", check.difference_half_width_percent},
           {"cause", cause_of(check.method)}}};
}

}  // namespace

CrossChecksResult cross_check(const ChainResults& r, const IntervalsResult& intervals) {
  CrossChecksResult out;
  out.classical = r.independent.classical;
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
