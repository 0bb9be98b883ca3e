// Is there a signal in the torque at all?

#include <algorithm>
#include <cmath>

#include "method/checks/check_list.h"
#include "method/checks/direction_difference.h"
#include "method/checks/torque_ceiling.h"
#include "method/motion/encoder_resolution.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::checks {

namespace {

/// Sums of one role's torque: its own variance and that of its white part.
struct TorqueScatter {
  double sum{}, squares{}, count{};
  std::vector<double> third;

  void add(const std::vector<double>& t) {
    for (const double torque : t) {
      sum += torque;
      squares += torque * torque;
      count += 1;
    }
    const std::vector<double> more = statistics::third_differences(t);
    third.insert(third.end(), more.begin(), more.end());
  }
  /// White noise shows in third differences; a robot's own signal does not.
  [[nodiscard]] double white_percent() const {
    const double variance = squares / count - std::pow(sum / count, 2);
    if (!(variance > 0)) return 0;
    return std::min(100.0, 100 * statistics::white_variance(third) / variance);
  }
};

}  // namespace

DataCheck check_torque_alive(const CheckedDataset& data) {
  DataCheck check;
  check.name = CheckName::torque_alive;
  if (!data.has_torque) {
    return not_applicable(check.name, {"not_applicable.no_torque"});
  }
  check.measure = {"measure.live_recordings"};
  check.unit = percent_sign;
  check.at_least = 100;
  RecordingCounts alive;
  for (const CheckedRecording& r : data.recordings) {
    const std::vector<double>& t = r.recording->torque_Nm;
    const auto [low, high] = std::minmax_element(t.begin(), t.end());
    alive.add(!t.empty() && *high > *low, r.recording->name);
  }
  if (alive.all() == 0) return not_applicable(check.name, {"not_applicable.no_recording"});
  alive.take_share(check);
  if (alive.others() == 0) return passed_by_all(check, {"torque_alive.in_all"});
  check.state = CheckState::fails;
  check.found = {"torque_alive.constant",
                 {{"constant", alive.others()}, {"recordings", alive.all()}}};
  check.consequence = {"torque_alive.shows_nothing"};
  check.experiment = {"torque_alive.see_column"};
  return check;
}

// A torque that stands still for a while although noise changes it at nearly every sample: the log
// repeats an old value.

namespace {

constexpr std::size_t shortest_held = 25;     // samples
constexpr std::size_t longest_by_chance = 3;  // of nine tenths of all stretches of equal values
constexpr double fewest_steps = 3;            // of the angle, passed meanwhile: the joint moves

/// Does the joint move from sample @p first up to @p last? A flicker of the encoder is no motion.
bool moves(const std::vector<double>& q_rad, std::size_t first, std::size_t last) {
  double low = q_rad[first], high = low, step = 0;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double change = std::abs(q_rad[i] - q_rad[i - 1]);
    if (change > 0 && (step == 0 || change < step)) step = change;
    low = std::min(low, q_rad[i]);
    high = std::max(high, q_rad[i]);
  }
  return step > 0 && high - low > (fewest_steps - 0.5) * step;
}

/// Samples held, of a recording whose torque changes at nearly every other one; nothing of one
/// whose torque is too coarse, or sampled too slowly, for that to show.
std::optional<std::size_t> held_samples(const joint::Recording& r) {
  const std::vector<double>& t = r.torque_Nm;
  if (t.empty()) return std::nullopt;
  const auto [low, high] = std::minmax_element(t.begin(), t.end());
  std::vector<std::size_t> lengths;
  std::size_t held = 0;
  for (std::size_t first = 0, last = 0; first < t.size(); first = last) {
    while (last < t.size() && t[last] == t[first]) ++last;
    lengths.push_back(last - first);
    const bool may_be_clipped = t[first] == *low || t[first] == *high;
    if (last - first < shortest_held || may_be_clipped) continue;
    if (moves(r.q_rad, first, last)) held += last - first;
  }
  if (lengths.size() < 2) return std::nullopt;
  const auto most = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() * 9 / 10);
  std::nth_element(lengths.begin(), most, lengths.end());
  return *most <= longest_by_chance ? std::optional(held) : std::nullopt;
}

}  // namespace

DataCheck check_torque_held(const CheckedDataset& data) {
  constexpr double most_percent = 5;
  DataCheck check;
  check.name = CheckName::torque_held;
  if (!data.has_torque) {
    return not_applicable(check.name, {"not_applicable.no_torque"});
  }
  check.measure = {"measure.held_torque"};
  check.unit = percent_sign;
  check.at_most = 0;
  for (const CheckedRecording& r : data.recordings) {
    const std::optional<std::size_t> held = held_samples(*r.recording);
    if (!held) continue;
    const double percent =
        100 * static_cast<double>(*held) / static_cast<double>(r.recording->size());
    (void)take_if_worst(check, percent, r.recording->name);
  }
  if (!check.measured) return not_applicable(check.name, {"not_applicable.torque_in_steps"});
  if (*check.measured == 0) return passed_by_all(check, {"torque_held.nowhere"});
  check.found = {"torque_held.percent", {{"percent", *check.measured}}};
  check.state = passed_or_warns_up_to(most_percent, check);
  check.consequence = {"torque_held.is_of_before"};
  check.experiment = {"torque_held.see_log"};
  return check;
}

DataCheck check_torque_noise(const CheckedDataset& data) {
  constexpr double warning_percent = 50;
  constexpr double most_percent = 80;
  DataCheck check;
  check.name = CheckName::torque_noise;
  if (!data.has_torque) {
    return not_applicable(check.name, {"not_applicable.no_torque"});
  }
  check.measure = {"measure.white_noise"};
  check.unit = percent_sign;
  check.at_most = warning_percent;
  for (const joint::Role role :
       {joint::Role::rough_sweep, joint::Role::oscillation, joint::Role::constant_speed}) {
    const auto recordings = data.with_role(role);
    if (recordings.empty()) continue;
    TorqueScatter scatter;
    for (const CheckedRecording* r : recordings) scatter.add(r->recording->torque_Nm);
    const double percent = scatter.white_percent();
    const bool is_one = recordings.size() == 1;
    if (take_if_worst(check, percent,
                      is_one ? recordings.front()->recording->name : joint::to_string(role))) {
      check.is_of_whole_role = !is_one;
    }
  }
  if (!check.measured) {
    return not_applicable(check.name, {"not_applicable.no_sweep_oscillation_or_run"});
  }
  check.found = {"torque_noise.white", {{"white_percent", *check.measured}}};
  check.state = passed_or_warns_up_to(most_percent, check);
  if (check.state == CheckState::passed) return check;
  check.consequence = {"torque_noise.signal_drowns"};
  check.experiment = {"torque_noise.record_longer"};
  return check;
}

// The step of the torque against the friction it has to show.

DataCheck check_torque_step(const CheckedDataset& data) {
  constexpr double warning_percent = 10;
  constexpr double most_percent = 25;
  DataCheck check;
  check.name = CheckName::torque_step;
  if (!data.has_torque) {
    return not_applicable(check.name, {"not_applicable.no_torque"});
  }
  check.measure = {"measure.torque_step_of_friction"};
  check.unit = percent_sign;
  check.at_most = warning_percent;
  double worst_step = 0;
  double its_friction = 0;
  for (const joint::Role role :
       {joint::Role::rough_sweep, joint::Role::oscillation, joint::Role::constant_speed}) {
    const auto recordings = data.with_role(role);
    const DirectionDifference d = direction_difference(recordings, true);
    if (d.common_bins == 0 || d.friction_Nm == 0) continue;
    for (const CheckedRecording* r : recordings) {
      const double step = motion::common_step(r->recording->torque_Nm);
      const double percent = 100 * step / std::abs(d.friction_Nm);
      if (!take_if_worst(check, percent, r->recording->name)) continue;
      worst_step = step;
      its_friction = std::abs(d.friction_Nm);
    }
  }
  if (!check.measured) {
    return not_applicable(check.name, {"not_applicable.no_common_angles"});
  }
  if (worst_step == 0) {
    return passed_by_all(check, {"torque_step.continuous"});
  }
  check.found = {"torque_step.against_friction",
                 {{"step_Nm", worst_step}, {"friction_Nm", its_friction}}};
  check.state = passed_or_warns_up_to(most_percent, check);
  if (check.state == CheckState::passed) return check;
  check.consequence = {"torque_step.friction_in_few_steps"};
  check.experiment = {"torque_step.record_finer"};
  return check;
}

// Clipping: the torque stays flat at its extreme value.

namespace {

constexpr std::size_t shortest_run = 3;    // samples in a row that make a flat stretch
constexpr std::size_t fewest_flat = 6;     // a single short stretch is chance, in a log of steps
constexpr std::size_t fewest_levels = 20;  // a torque of fewer values is coarse, not clipped
constexpr double against_neighbours = 5;   // times as many samples as the values beside it
constexpr double beside_share = 0.02;      // of the range: what counts as beside the extreme

struct Extreme {
  double value{};
  std::size_t flat_samples{};  ///< In sequences of at least three at exactly that value.
  std::size_t beside{};        ///< Samples close to the value, but not at it.
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

/// The torque of the useful part of a recording: a run may well start at the drive's limit.
std::vector<double> torque_of(const CheckedRecording& r) {
  const std::vector<double>& torque = r.recording->torque_Nm;
  if (r.recording->role != joint::Role::constant_speed || r.motion.plateaus.empty()) return torque;
  std::vector<double> used;
  for (const motion::Plateau& plateau : r.motion.plateaus) {
    used.insert(used.end(), torque.begin() + static_cast<std::ptrdiff_t>(plateau.first),
                torque.begin() + static_cast<std::ptrdiff_t>(plateau.last));
  }
  return used;
}

/// Both ends of the range, each only if values close to it are rare.
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
    if (extreme.flat_samples < fewest_flat ||
        flat < against_neighbours * static_cast<double>(extreme.beside) / 2) {
      continue;
    }
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
  check.name = CheckName::torque_saturation;
  if (!data.has_torque) {
    return not_applicable(check.name, {"not_applicable.no_torque"});
  }
  check.measure = {"measure.clipped_samples"};
  check.unit = percent_sign;
  check.at_most = most_percent;
  double value_Nm = 0;
  std::size_t clipped = 0;
  for (const CheckedRecording& r : data.recordings) {
    if (r.recording->role == joint::Role::break_away) continue;  // a ramp may well end at the limit
    const Saturation s = saturation_of(torque_of(r));
    if (s.percent > most_percent) ++clipped;
    if (!take_if_worst(check, s.percent, r.recording->name)) continue;
    value_Nm = s.value_Nm;
  }
  if (!check.measured) return not_applicable(check.name, {"not_applicable.no_recording"});
  const TorqueCeiling ceiling = clipped > 0 ? TorqueCeiling{} : torque_ceiling(data.recordings);
  if (clipped == 0 && ceiling.speeds == 0) {
    return passed_by_all(check, {"torque_saturation.none"});
  }
  check.state = CheckState::fails;
  check.found = clipped > 0
                    ? Statement{"torque_saturation.clipped",
                                {{"flat_percent", *check.measured},
                                 {"extreme_Nm", value_Nm},
                                 {"recordings", clipped}}}
                    : Statement{"torque_saturation.same_at_all_speeds",
                                {{"speeds", ceiling.speeds}, {"torque_Nm", ceiling.torque_Nm}}};
  check.consequence = {"torque_saturation.peaks_cut_off"};
  check.experiment = {"torque_saturation.widen_range"};
  return check;
}

}  // namespace tribolog::method::checks
