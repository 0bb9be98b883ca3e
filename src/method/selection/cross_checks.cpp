#include "method/selection/cross_checks.h"

#include <algorithm>
#include <cmath>

#include "joint/gravity_load.h"
#include "statistics/distributions.h"

namespace tribolog::method::selection {
namespace {

using hysteresis::Estimator;

/// An estimator that is compared, and what would make it differ.
struct Compared {
  Estimator estimator;
  Code cause;
};

constexpr Compared compared[] = {{Estimator::model, "cross_check.ripple_load_or_zero"},
                                 {Estimator::midline, "cross_check.ripple_at_position"},
                                 {Estimator::AB, "cross_check.loop_not_steady"},
                                 {Estimator::CD, "cross_check.loop_not_steady"},
                                 {Estimator::EF, "cross_check.loop_not_steady"},
                                 {Estimator::fit, "cross_check.friction_beyond_lugre"},
                                 {Estimator::sweep, "cross_check.ripple_load_or_zero"}};

/// Whether points that lie opposite each other on a sine do not on these loops.
bool is_no_sine(const hysteresis::HysteresisResult& loops) {
  constexpr double largest_harmonic = 0.005;
  return loops.midline_by_angle || std::any_of(loops.oscillations.begin(), loops.oscillations.end(),
                                               [](const hysteresis::Oscillation& o) {
                                                 return o.third_harmonic > largest_harmonic;
                                               });
}

bool is_of_loops(Estimator estimator) {
  return estimator != Estimator::model && estimator != Estimator::sweep;
}

Statement name_of(Estimator estimator) { return Code::of("estimator." + to_string(estimator)); }

Statement finding(const CrossCheck& check, const CrossCheck& recommended, Code cause) {
  return {"cross_check.disagree",
          {{"recommended", name_of(recommended.estimator)},
           {"other", name_of(check.estimator)},
           {"recommended_kg", recommended.mass_kg.value},
           {"other_kg", check.mass_kg.value},
           {"difference_percent", check.difference_percent},
           {"interval_percent", check.difference_half_width_percent},
           {"cause", cause}}};
}

/// Probability of as large a difference between estimates of the same quantity.
double chance_of(const CrossCheck& check) {
  return std::erfc(statistics::normal_975 * check.difference_in_intervals / std::sqrt(2.0));
}

/// S. Holm, Scand. J. Statist. 6 (1979) 65-70: with many comparisons, some differ by chance. The
/// least likely is tested at the level divided by their number, the next at the level divided by
/// one less, until one passes.
void find_disagreements(std::vector<CrossCheck*> checks) {
  constexpr double level = 0.05;
  std::sort(checks.begin(), checks.end(), [](const CrossCheck* a, const CrossCheck* b) {
    return a->difference_in_intervals > b->difference_in_intervals;
  });
  for (std::size_t k = 0; k < checks.size(); ++k) {
    if (chance_of(*checks[k]) > level / static_cast<double>(checks.size() - k)) return;
    checks[k]->disagrees = std::abs(checks[k]->difference_percent) > 100 * least_difference;
  }
}

}  // namespace

CrossChecksResult cross_check(const hysteresis::SurrogateMassesResult& masses,
                              const std::optional<Estimator>& recommended,
                              const hysteresis::HysteresisResult& loops, double gear_ratio) {
  CrossChecksResult out;
  const hysteresis::SurrogateMass* ours = masses.find(recommended);
  // Shares of a gravity that may be zero say nothing.
  if (ours == nullptr || !(ours->gravity_Nm.low > 0)) return out;
  const bool has_no_sine = is_no_sine(loops);
  const bool rests_on_loops = is_of_loops(*recommended);
  const double kg_per_Nm =
      joint::surrogate_mass_kg(1.0, gear_ratio, masses.distance_m, masses.gravity_m_s2, 1.0);
  const double gravity_Nm = ours->gravity_Nm.value;
  for (const Compared& one : compared) {
    const hysteresis::SurrogateMass* mass = masses.find(one.estimator);
    if (mass == nullptr) continue;
    CrossCheck check;
    check.estimator = one.estimator;
    check.gravity_Nm = mass->gravity_Nm;
    check.mass_kg = statistics::scaled(mass->gravity_Nm, kg_per_Nm);
    check.is_recommended = one.estimator == *recommended;
    check.is_biased = has_no_sine && hysteresis::points_of_pair(one.estimator).has_value();
    check.has_same_samples = is_of_loops(one.estimator) == rests_on_loops;
    const double half_width = check.is_recommended ? 0
                                                   : std::hypot(mass->gravity_Nm.half_width(),
                                                                ours->gravity_Nm.half_width(),
                                                                numerical_share * gravity_Nm);
    const double difference = mass->gravity_Nm.value - gravity_Nm;
    check.difference_percent = 100 * difference / gravity_Nm;
    check.difference_half_width_percent = 100 * half_width / gravity_Nm;
    check.difference_in_intervals = half_width > 0 ? std::abs(difference) / half_width : 0.0;
    out.checks.push_back(check);
  }
  const auto at = std::find_if(out.checks.begin(), out.checks.end(),
                               [](const CrossCheck& c) { return c.is_recommended; });
  if (at == out.checks.end()) return {};
  std::vector<CrossCheck*> counting;
  std::vector<CrossCheck*> beside;
  for (CrossCheck& check : out.checks) {
    if (check.counts()) counting.push_back(&check);
    if (!check.counts() && !check.is_recommended) beside.push_back(&check);
  }
  find_disagreements(counting);
  find_disagreements(beside);
  for (const CrossCheck& check : out.checks) {
    // What does not count is in the table.
    if (!check.disagrees || !check.counts()) continue;
    const auto* const of =
        std::find_if(std::begin(compared), std::end(compared),
                     [&](const Compared& one) { return one.estimator == check.estimator; });
    out.findings.push_back(finding(check, *at, of->cause));
    out.doubtful |= std::abs(check.difference_percent) + check.difference_half_width_percent >
                    100 * largest_spread;
  }
  return out;
}

}  // namespace tribolog::method::selection
