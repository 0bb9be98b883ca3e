// Clipping: the torque stays flat on its extreme value.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "method/checks/check_list.h"

namespace tribolog {
namespace {

constexpr std::size_t shortest_run = 3;    // samples in a row that make a flat stretch
constexpr std::size_t fewest_levels = 20;  // a torque of fewer values is coarse, not clipped
constexpr double against_neighbours = 5;   // times as many samples as the values beside it
constexpr double beside_share = 0.02;      // of the range: what counts as beside the extreme

struct Extreme {
  double value{};
  std::size_t flat_samples{};  ///< In runs of at least three on the very value.
  std::size_t beside{};        ///< Samples close to the value, not on it.
};

Extreme extreme_of(const std::vector<double>& t, double value, double range) {
  Extreme out{value, 0, 0};
  const double same = 1e-9 * range;
  std::size_t run = 0;
  const auto close = [&] {
    if (run >= shortest_run) out.flat_samples += run;
    run = 0;
  };
  for (const double torque : t) {
    const double distance = std::abs(torque - value);
    if (distance <= same) {
      ++run;
      continue;
    }
    close();
    if (distance <= beside_share * range) ++out.beside;
  }
  close();
  return out;
}

/// Share of the samples off both extremes that repeat their neighbours, three or more in a row. A
/// torque in coarse steps, or held between updates, does that everywhere, clipped or not.
double flat_elsewhere(const std::vector<double>& t, double low, double high) {
  std::size_t flat = 0, others = 0, run = 1;
  for (std::size_t i = 0; i < t.size(); ++i) {
    run = i > 0 && t[i] == t[i - 1] ? run + 1 : 1;
    if (t[i] == low || t[i] == high) continue;
    ++others;
    if (run >= shortest_run) ++flat;
  }
  return others > 0 ? static_cast<double>(flat) / static_cast<double>(others) : 1.0;
}

bool has_fewer_levels(const std::vector<double>& t, std::size_t levels) {
  std::vector<double> met;
  for (const double torque : t) {
    if (std::find(met.begin(), met.end(), torque) == met.end()) met.push_back(torque);
    if (met.size() == levels) return false;
  }
  return true;
}

struct Saturation {
  double percent{};
  double value_Nm{};
};

/// The torque of what is used of a recording: a run may well start at the drive's limit.
std::vector<double> torque_of(const CheckedRecording& r) {
  const std::vector<double>& torque = r.recording->torque_Nm;
  if (r.recording->role != Role::constant_speed || r.motion.plateaus.empty()) return torque;
  std::vector<double> used;
  for (const Plateau& plateau : r.motion.plateaus) {
    used.insert(used.end(), torque.begin() + static_cast<std::ptrdiff_t>(plateau.first),
                torque.begin() + static_cast<std::ptrdiff_t>(plateau.last));
  }
  return used;
}

/// Both ends of the range, each only if values beside it are rare.
Saturation saturation_of(const std::vector<double>& t) {
  Saturation out;
  if (t.size() < fewest_levels) return out;
  const auto [low, high] = std::minmax_element(t.begin(), t.end());
  const double range = *high - *low;
  if (!(range > 0) || has_fewer_levels(t, fewest_levels)) return out;
  constexpr double held_or_coarse = 0.2;
  if (flat_elsewhere(t, *low, *high) > held_or_coarse) return out;
  for (const double end : {*low, *high}) {
    const Extreme extreme = extreme_of(t, end, range);
    const auto flat = static_cast<double>(extreme.flat_samples);
    if (flat < against_neighbours * static_cast<double>(extreme.beside) / 2) continue;
    const double percent = 100 * flat / static_cast<double>(t.size());
    if (percent > out.percent) out.value_Nm = end;
    out.percent += percent;
  }
  return out;
}

}  // namespace

DataCheck check_torque_saturation(const CheckedDataset& data) {
  constexpr double most_percent = 0.5;
  DataCheck check;
  check.name = "torque_saturation";
  check.title = "Torque not clipped";
  if (!data.has_torque) {
    return not_applicable(check.name, check.title, "no torque was recorded");
  }
  check.measure = "samples that lie flat on the extreme torque";
  check.unit = percent_sign;
  check.at_most = most_percent;
  double value_Nm = 0;
  std::size_t clipped = 0;
  for (const CheckedRecording& r : data.recordings) {
    if (r.recording->role == Role::break_away) continue;  // a ramp may well end at the limit
    const Saturation s = saturation_of(torque_of(r));
    if (s.percent > most_percent) ++clipped;
    if (!take_if_worst(check, s.percent, r.recording->name)) continue;
    value_Nm = s.value_Nm;
  }
  if (!check.measured) return not_applicable(check.name, check.title, "no recording");
  if (clipped == 0) {
    return passed_by_all(check, "the torque does not lie flat on its extremes");
  }
  check.state = CheckState::fails;
  check.found =
      fmt::format("{:.1f} % of the samples lie flat at {:.4g} N·m at the motor; {} clipped",
                  *check.measured, value_Nm, recordings_in_words(clipped));
  check.consequence =
      "the largest torques are cut off: gravity and friction come out too small, "
      "and the peak's angle is that of the cut";
  check.experiment =
      "widen the range of the measurement or of the drive's limit, or take load off "
      "the joint";
  return check;
}

}  // namespace tribolog
