// Stick-slip: in slow motion the joint rests, springs on in the same direction, and rests again.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "method/checks/check_list.h"

namespace tribolog {
namespace {

constexpr double rest_share = 0.1;      // of the stroke's mean speed: slower is rest
constexpr double burst_share = 1.5;     // faster is a burst
constexpr double steps_in_window = 20;  // of the encoder, at the mean speed
constexpr std::size_t fewest_samples_in_window = 5;

/// Times that a stroke stops and springs on.
std::size_t stops_within(const CheckedRecording& r, const Stroke& stroke) {
  const Recording& log = *r.recording;
  const double duration = log.t_s[stroke.last] - log.t_s[stroke.first];
  if (!(duration > 0)) return 0;
  const double mean = stroke.travel_rad / duration;
  const auto window =
      std::max(fewest_samples_in_window,
               static_cast<std::size_t>(steps_in_window * r.angle_step_rad / mean / r.interval_s));
  bool rested = false;
  bool burst_before = false;
  std::size_t stops = 0;
  // The ends of a stroke are at rest anyhow, so a rest counts between two bursts only.
  for (std::size_t i = stroke.first; i + window <= stroke.last; ++i) {
    const double speed = stroke.direction * (log.q_rad[i + window] - log.q_rad[i]) /
                         (log.t_s[i + window] - log.t_s[i]);
    if (speed > burst_share * mean) {
      if (burst_before && rested) ++stops;
      burst_before = true;
      rested = false;
    } else if (speed < rest_share * mean) {
      rested = true;
    }
  }
  return stops;
}

}  // namespace

DataCheck check_stick_slip(const CheckedDataset& data) {
  constexpr double most_stops = 4;
  DataCheck check;
  check.name = "stick_slip";
  check.title = "No stick-slip";
  check.measure = "stops within one stroke, each followed by a burst";
  check.unit = pure_number;
  check.at_most = most_stops;
  std::size_t affected = 0;
  for (const CheckedRecording& r : data.recordings) {
    if (!r.travels()) continue;
    std::size_t stops = 0;
    for (const Stroke& stroke : r.strokes) stops = std::max(stops, stops_within(r, stroke));
    const auto count = static_cast<double>(stops);
    if (count > most_stops) ++affected;
    take_if_worst(check, count, r.recording->name);
  }
  if (!check.measured) return not_applicable(check.name, check.title, "no sweep or run");
  if (affected == 0) {
    return passed_by_all(check, "the joint moves on without stopping");
  }
  check.state = CheckState::fails;
  check.found =
      fmt::format("the joint stops and springs on {:.0f} times in one stroke; {} affected",
                  *check.measured, recordings_in_words(affected));
  check.consequence =
      "the torque is that of sticking and of sliding in turn, at no one speed: "
      "friction at this speed is not what the mean of it says";
  check.experiment =
      "move faster than the speed at which the joint sticks, or make the speed "
      "control stiffer";
  return check;
}

}  // namespace tribolog
