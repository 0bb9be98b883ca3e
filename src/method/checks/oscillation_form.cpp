// The oscillation: how many cycles, and whether friction turns over within it.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "method/checks/check_list.h"

namespace tribolog {
namespace {

constexpr std::size_t bins = 20;  // of a stroke

/// Stiffness of the loop towards the end of its strokes, in % of that behind the turns: 0 where
/// friction has reached its level, 100 for a spring.
std::optional<double> stiffness_left_percent(const CheckedRecording& r) {
  constexpr double whole_stroke = 0.8;  // of the range: the start-up stroke is shorter
  // Each direction for itself: gravity is far larger than what is looked for.
  std::array<std::array<double, bins>, 2> sum{};
  std::array<std::array<std::size_t, bins>, 2> count{};
  for (const Stroke& stroke : r.strokes) {
    if (stroke.travel_rad < whole_stroke * r.range_rad()) continue;
    const std::size_t way = stroke.direction > 0 ? 0 : 1;
    const double start = r.recording->q_rad[stroke.first];
    for (std::size_t i = stroke.first; i < stroke.last; ++i) {
      const double place = std::abs(r.recording->q_rad[i] - start) / stroke.travel_rad;
      if (!(place >= 0 && place < 1)) continue;
      const auto k = static_cast<std::size_t>(place * bins);
      sum[way][k] += r.recording->torque_Nm[i];
      ++count[way][k];
    }
  }
  for (const auto& counts : count) {
    if (std::any_of(counts.begin(), counts.end(), [](std::size_t c) { return c == 0; })) {
      return std::nullopt;
    }
  }
  const auto mean = [&](std::size_t k) {
    return (sum[0][k] / static_cast<double>(count[0][k]) -
            sum[1][k] / static_cast<double>(count[1][k])) /
           2;
  };
  const double behind_turn = mean(2) - mean(0);
  const double at_end = mean(bins - 2) - mean(bins - 6);
  if (!(behind_turn > 0)) return std::nullopt;
  return std::max(0.0, 100 * (at_end / 4) / (behind_turn / 2));
}

}  // namespace

DataCheck check_oscillation_cycles(const CheckedDataset& data) {
  constexpr double fewest = 3;
  constexpr double enough = 5;
  DataCheck check;
  check.name = "oscillation_cycles";
  check.title = "Cycles of the oscillation";
  check.measure = "cycles";
  check.unit = pure_number;
  check.at_least = enough;
  for (const CheckedRecording* r : data.with_role(Role::oscillation)) {
    if (r->strokes.empty()) continue;
    const double cycles = static_cast<double>(r->strokes.size() - 1) / 2;  // two turns each
    if (check.measured && cycles >= *check.measured) continue;
    check.measured = cycles;
    check.recording = r->recording->name;
  }
  if (!check.measured) {
    return not_applicable(check.name, check.title, "no oscillation was recorded");
  }
  check.found = fmt::format("{:.1f} cycles", *check.measured);
  check.state = *check.measured >= enough   ? CheckState::passed
                : *check.measured >= fewest ? CheckState::warns
                                            : CheckState::fails;
  if (check.state == CheckState::passed) return check;
  check.consequence =
      "the start-up stroke is no steady loop, and too few cycles follow it: the "
      "mid-line is biased by it, and nothing shows how cycles scatter";
  check.experiment = "record ten cycles or more";
  return check;
}

DataCheck check_oscillation_slides(const CheckedDataset& data) {
  constexpr double warning_percent = 10;
  constexpr double most_percent = 30;
  DataCheck check;
  check.name = "oscillation_slides";
  check.title = "Friction turns over in the loop";
  if (!data.has_torque) {
    return not_applicable(check.name, check.title, "no torque was recorded");
  }
  check.measure = "stiffness left at the end of a stroke, of that behind a turn";
  check.unit = percent_sign;
  check.at_most = warning_percent;
  for (const CheckedRecording* r : data.with_role(Role::oscillation)) {
    const auto left = stiffness_left_percent(*r);
    // The largest stroke decides: smaller ones beside it add to what it shows.
    if (!left || (check.measured && *left >= *check.measured)) continue;
    check.measured = left;
    check.recording = r->recording->name;
  }
  if (!check.measured) {
    return not_applicable(check.name, check.title, "no oscillation with whole strokes");
  }
  check.found =
      fmt::format("{:.2g} % of the stiffness is left at the end of a stroke", *check.measured);
  check.state = passed_or_warns_up_to(most_percent, check);
  if (check.state == CheckState::passed) return check;
  check.consequence =
      "the stroke is too small: friction does not reach its level, so that the "
      "break-away torque is not seen, only that it is larger";
  check.experiment = "oscillate with a larger amplitude, until the loop's branches run flat";
  return check;
}

}  // namespace tribolog
