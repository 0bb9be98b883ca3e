#include "joint/wrapped_angle.h"

#include <algorithm>
#include <cmath>

namespace tribolog::joint {
namespace {

constexpr double least_jump = 0.8;        // of the range
constexpr double largest_step = 0.2;      // of the range: of samples beside a jump
constexpr double longest_interval = 3.0;  // of the usual one: the clock goes on
constexpr double at_an_end = 1.5;         // steps from the end of the range
constexpr double most_turns = 8;
constexpr double agreement = 0.03;  // of the period

struct Candidate {
  AngleWraps::Jump jump;
  double period{};  // by the jump and the steps beside it
  double step{};    // the larger one of these
  bool goes_on{};   // the joint moves the other way than the jump, before and behind it
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The samples without gaps.
std::vector<std::size_t> finite(const std::vector<double>& time, const std::vector<double>& angle) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < angle.size(); ++i) {
    if (std::isfinite(time[i]) && std::isfinite(angle[i])) out.push_back(i);
  }
  return out;
}

/// The nearest to the period of the whole numbers of turns and, of a range about zero or from zero
/// on, the round numbers; 0: none is near. Four turns and 25 rad are half a per cent apart.
double certain_period(double period, double low, double high, double step,
                      const std::vector<double>& turns) {
  double nearest = 0;
  const auto offer = [&](double one, double tolerance) {
    if (std::abs(one - period) < std::min(tolerance * period, std::abs(nearest - period))) {
      nearest = one;
    }
  };
  for (const double turn : turns) {
    const double count = std::round(period / turn);
    if (count >= 1 && count <= most_turns) offer(count * turn, agreement);
  }
  const bool is_about_zero = std::abs(high + low) < 2 * step;
  const bool is_from_zero = std::abs(low) < 2 * step;
  if (is_about_zero || is_from_zero) {
    const double unit = std::pow(10, std::floor(std::log10(period)) - 1);
    constexpr double of_a_round_one = 0.01;
    offer(unit * std::round(period / unit), of_a_round_one);
  }
  return nearest;
}

}  // namespace

std::optional<AngleWraps> find_wraps(const std::vector<double>& time,
                                     const std::vector<double>& angle,
                                     const std::vector<double>& turns) {
  const std::vector<std::size_t> at = finite(time, angle);
  constexpr std::size_t fewest = 20;
  if (at.size() < fewest) return std::nullopt;
  double low = angle[at.front()];
  double high = low;
  for (const std::size_t i : at) {
    low = std::min(low, angle[i]);
    high = std::max(high, angle[i]);
  }
  const double range = high - low;
  std::vector<std::size_t> jumps;  // numbers in `at` of the first behind
  for (std::size_t k = 1; k < at.size(); ++k) {
    if (std::abs(angle[at[k]] - angle[at[k - 1]]) > least_jump * range) jumps.push_back(k);
  }
  if (jumps.empty() || !(range > 0)) return std::nullopt;
  std::vector<double> intervals;
  for (std::size_t k = 1; k < at.size(); ++k) intervals.push_back(time[at[k]] - time[at[k - 1]]);
  const double interval = median(intervals);

  std::vector<Candidate> found;
  for (const std::size_t k : jumps) {
    if (k < 2 || k + 1 >= at.size()) return std::nullopt;  // nothing shows whether it goes on
    const double before = angle[at[k - 1]] - angle[at[k - 2]];
    const double jump = angle[at[k]] - angle[at[k - 1]];
    const double after = angle[at[k + 1]] - angle[at[k]];
    const double step = std::max(std::abs(before), std::abs(after));
    const double waited = std::abs(time[at[k]] - time[at[k - 1]]);
    // Jumps may follow one another where the angle trembles about an end of the range.
    const bool is_alone = step < largest_step * range;
    if (!is_alone) continue;
    if (waited > longest_interval * interval) return std::nullopt;
    const double reach = at_an_end * std::max(step, std::abs(range - std::abs(jump)));
    const bool is_at_ends = std::min(angle[at[k - 1]], angle[at[k]]) < low + reach &&
                            std::max(angle[at[k - 1]], angle[at[k]]) > high - reach;
    if (!is_at_ends) return std::nullopt;
    const double expected = (before + after) / 2 * waited / interval;
    found.push_back({{at[k], jump > 0},
                     std::abs(jump - expected),
                     step,
                     before * jump < 0 && after * jump < 0});
  }
  // A joint that steps from one end to the other between two samples rests there.
  const auto going_on =
      std::count_if(found.begin(), found.end(), [](const Candidate& c) { return c.goes_on; });
  constexpr double most = 0.8;
  if (going_on == 0 || static_cast<double>(going_on) < most * static_cast<double>(found.size())) {
    return std::nullopt;
  }
  std::vector<double> periods;
  std::vector<double> steps;
  for (const Candidate& c : found) {
    periods.push_back(c.period);
    steps.push_back(c.step);
  }
  const double largest = *std::max_element(steps.begin(), steps.end());
  AngleWraps out;
  out.period = certain_period(median(periods), low, high, largest, turns);
  if (out.period == 0) return std::nullopt;
  const bool all_agree = std::all_of(found.begin(), found.end(), [&](const Candidate& c) {
    return std::abs(c.period - out.period) < c.step + agreement * out.period;
  });
  if (!all_agree) return std::nullopt;
  for (const std::size_t k : jumps) {
    out.jumps.push_back({at[k], angle[at[k]] > angle[at[k - 1]]});
  }
  return out;
}

std::vector<double> unwrapped(std::vector<double> angle, const AngleWraps& wraps) {
  double offset = 0;
  auto next = wraps.jumps.begin();
  for (std::size_t i = 0; i < angle.size(); ++i) {
    if (next != wraps.jumps.end() && next->sample == i) {
      offset += next->is_up ? -wraps.period : wraps.period;
      ++next;
    }
    angle[i] += offset;
  }
  return angle;
}

}  // namespace tribolog::joint
