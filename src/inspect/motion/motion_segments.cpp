#include "inspect/motion/motion_segments.h"

#include <algorithm>
#include <cmath>

#include "base/enum_text.h"
#include "inspect/motion/angle_trace.h"
#include "inspect/motion/strokes_and_ramps.h"
#include "method/motion/plateaus.h"

namespace tribolog::inspect::motion {
namespace {

constexpr double smallest_travel = 1e-3;      // of the widest: single strokes below are settling
constexpr double smallest_varying = 0.05;     // of the widest: smaller ones need no mention
constexpr std::size_t fewest_samples = 20;    // that the reader of recordings takes
constexpr double smallest_travel_floors = 6;  // of the noise floor
constexpr double small_beside_range =
    0.02;  // an oscillation that needs fewer strokes to be recognised
constexpr std::size_t few_strokes = 3;
constexpr std::size_t several_strokes = 5;
constexpr double slow_period_s = 5;            // steady strokes to and fro, slower: runs, not an
                                               // oscillation
constexpr double shortest_sweep_period_s = 2;  // a faster sine is no slow sweep
constexpr double shortest_end_rest = 0.015;    // of the motion beside it; shorter is its start
constexpr double least_plateau_share = 0.6;    // of a stroke made of several speeds
constexpr double driven_share = 0.2;           // of the effort's range: it does not rest yet
constexpr double largest_drift = 0.01;         // of the widest motion: more is no rest
constexpr std::size_t fewest_steps = 3;        // of a stair of speeds
constexpr double least_step_ratio = 1.5;       // of its fastest speed to its slowest
constexpr double least_single_share = 0.4;     // of a stroke with one speed; a sine has 0.2
constexpr double shortest_rest = 1e-3;         // of the recording

double spread(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

class MotionCutter {
 public:
  explicit MotionCutter(const AngleTrace& trace) : trace_(trace) {}

  std::vector<MotionSegment> cut() {
    if (trace_.size() < 2) return {};
    floor_ = noise_floor(trace_.q_rad);
    range_ = spread(trace_.q_rad);
    for (const StrokeFamily& family : find_strokes(trace_, floor_)) {
      for (StrokeGroup& group : group_strokes(trace_, family, widest_oscillation_rad)) {
        (is_oscillation(group) ? oscillations_ : others_).push_back(std::move(group));
      }
    }
    for (const StrokeGroup& group : oscillations_) add(MotionKind::oscillation, group);
    add_ramps();
    for (const StrokeGroup& group : others_) add_other(group);
    in_order_of_time();
    take_short_ends();
    add_rests();
    return std::move(segments_);
  }

 private:
  [[nodiscard]] double seconds(std::size_t first, std::size_t last) const {
    return trace_.t_s[last] - trace_.t_s[first];
  }

  /// Ramps that break away in turns leave the joint at rest for most of the time between.
  [[nodiscard]] bool stands_mostly(const StrokeGroup& group) const {
    constexpr std::size_t slices = 50;
    constexpr double standing = 0.02;  // of the travel
    constexpr std::size_t most_standing = slices / 2;
    const std::size_t samples = group.last() - group.first() + 1;
    if (samples < 4 * slices) return false;
    std::size_t at_rest = 0;
    for (std::size_t k = 0; k < slices; ++k) {
      const auto slice = trace_.q_rad.begin() + static_cast<std::ptrdiff_t>(group.first());
      const auto [low, high] =
          std::minmax_element(slice + static_cast<std::ptrdiff_t>(k * samples / slices),
                              slice + static_cast<std::ptrdiff_t>((k + 1) * samples / slices));
      if (*high - *low < standing * group.travel_rad()) ++at_rest;
    }
    return at_rest > most_standing;
  }

  [[nodiscard]] bool is_oscillation(const StrokeGroup& group) const {
    const std::size_t strokes = group.strokes.size();
    const double travel = group.travel_rad();
    if (group.is_irregular || travel > widest_oscillation_rad) return false;
    if (travel < smallest_travel_floors * floor_) return false;
    const double period_s = 2 * seconds(group.first(), group.last()) / static_cast<double>(strokes);
    if (group.is_steady && period_s > slow_period_s) return false;
    if (stands_mostly(group)) return false;
    return strokes >= several_strokes ||
           (strokes >= few_strokes && travel <= small_beside_range * range_);
  }

  [[nodiscard]] bool is_slow(const StrokeGroup& group) const {
    const double stroke_s =
        seconds(group.first(), group.last()) / static_cast<double>(group.strokes.size());
    return 2 * stroke_s >= shortest_sweep_period_s;
  }

  [[nodiscard]] bool is_free(std::size_t first, std::size_t last) const {
    return std::none_of(segments_.begin(), segments_.end(),
                        [&](const MotionSegment& s) { return first < s.last && s.first < last; });
  }

  MotionSegment segment(MotionKind kind, std::size_t first, std::size_t last) const {
    MotionSegment s;
    s.kind = kind;
    s.first = first;
    s.last = last;
    s.from_s = trace_.t_s[first];
    s.to_s = trace_.t_s[last];
    const auto [low, high] =
        std::minmax_element(trace_.q_rad.begin() + static_cast<std::ptrdiff_t>(first),
                            trace_.q_rad.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    s.lowest_rad = *low;
    s.highest_rad = *high;
    return s;
  }

  void add(MotionKind kind, const StrokeGroup& group) {
    if (!is_free(group.first(), group.last())) return;
    MotionSegment s = segment(kind, group.first(), group.last());
    s.strokes = group.strokes.size();
    s.speed_rad_s = group.speed_rad_s();
    s.is_steady = group.is_steady;
    if (s.strokes == 1) s.direction = group.strokes.front().travel_rad > 0 ? 1 : -1;
    if (s.strokes >= few_strokes) {
      // From turn to turn: the first and the last stroke may be parts.
      const std::size_t from = group.strokes.front().last;
      const std::size_t to = group.strokes.back().first;
      const double whole = static_cast<double>(s.strokes - 2);
      if (seconds(from, to) > 0) s.frequency_Hz = whole / 2 / seconds(from, to);
    }
    segments_.push_back(s);
  }

  /// The torque also rises while a run begins; creep and slips under a ramp are shorter than it.
  [[nodiscard]] bool starts_a_motion(const TorqueRamp& ramp) const {
    return std::any_of(others_.begin(), others_.end(), [&](const StrokeGroup& group) {
      return (group.is_steady || group.strokes.size() > 1) && group.first() < ramp.last &&
             ramp.first < group.last() &&
             seconds(group.first(), group.last()) > seconds(ramp.first, ramp.last);
    });
  }

  /// Where no oscillation is: a ramp's creep and slips look like strokes.
  void add_ramps() {
    std::vector<MotionSegment> taken = segments_;
    std::sort(taken.begin(), taken.end(),
              [](const MotionSegment& a, const MotionSegment& b) { return a.first < b.first; });
    const TorqueRampFinder ramps(trace_, floor_);
    const NoisyRampFinder ramps_in_noise(trace_, floor_);
    std::size_t first = 0;
    const auto take = [&](const TorqueRamp& ramp) {
      MotionSegment s = segment(MotionKind::break_away_ramp, ramp.first, ramp.last);
      s.effort_rate = ramp.rate;
      s.joint_slid = ramp.joint_slid;
      segments_.push_back(s);
    };
    const auto look_until = [&](std::size_t last) {
      for (const TorqueRamp& ramp : ramps.between(first, last)) {
        if (!starts_a_motion(ramp)) take(ramp);
      }
      for (const TorqueRamp& ramp : ramps_in_noise.between(first, last)) {
        if (is_free(ramp.first, ramp.last)) take(ramp);
      }
    };
    for (const MotionSegment& s : taken) {
      look_until(s.first);
      first = std::max(first, s.last);
    }
    look_until(trace_.size() - 1);
  }

  void add_other(const StrokeGroup& group) {
    const double travel = group.travel_rad();
    if (travel < smallest_travel * range_ || travel < smallest_travel_floors * floor_) return;
    if (group.last() - group.first() + 1 < fewest_samples || group.is_irregular) {
      add_varying(group);
    } else if (add_staircases(group)) {
      return;
    } else if (group.is_steady) {
      add(MotionKind::constant_speed, group);
    } else if (group.strokes.size() > 1 && is_slow(group)) {
      add(MotionKind::slow_sweep, group);
    } else if (group.strokes.size() > 1 || !add_plateaus(group)) {
      add_varying(group);
    }
  }

  /// Small ones are settling and tremor, and stay with the rest.
  void add_varying(const StrokeGroup& group) {
    if (group.travel_rad() >= smallest_varying * range_) add(MotionKind::varying, group);
  }

  [[nodiscard]] method::motion::MotionSegments plateaus_between(std::size_t first,
                                                                std::size_t last) const {
    const auto part = [&](const std::vector<double>& v) {
      return std::vector<double>(v.begin() + static_cast<std::ptrdiff_t>(first),
                                 v.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    };
    joint::Recording stroke;
    stroke.t_s = part(trace_.t_s);
    stroke.q_rad = part(trace_.q_rad);
    return method::motion::find_plateaus(stroke);
  }

  void add_runs(std::size_t first, const std::vector<method::motion::Plateau>& plateaus) {
    for (const method::motion::Plateau& plateau : plateaus) {
      MotionSegment s =
          segment(MotionKind::constant_speed, first + plateau.first, first + plateau.last - 1);
      s.strokes = 1;
      s.is_steady = true;
      s.speed_rad_s = std::abs(plateau.speed_rad_s);
      s.direction = plateau.speed_rad_s > 0 ? 1 : -1;
      segments_.push_back(s);
    }
  }

  /// A stroke that runs at several speeds one after the other, or at one in a part of it.
  bool add_plateaus(const StrokeGroup& group) {
    if (!is_free(group.first(), group.last())) return false;
    const method::motion::MotionSegments found = plateaus_between(group.first(), group.last());
    const double least = found.plateaus.size() > 1 ? least_plateau_share : least_single_share;
    if (found.plateaus.empty() || found.plateau_share() < least) return false;
    add_runs(group.first(), found.plateaus);
    return true;
  }

  /// There and back, each way up and down a stair of speeds: by its travel alone the fastest of
  /// them would pass for the stroke's one speed.
  bool add_staircases(const StrokeGroup& group) {
    if (group.strokes.size() > 2 || !is_free(group.first(), group.last())) return false;
    std::vector<method::motion::MotionSegments> found;
    for (const AngleStroke& stroke : group.strokes) {
      found.push_back(plateaus_between(stroke.first, stroke.last));
      const auto& plateaus = found.back().plateaus;
      if (plateaus.size() < fewest_steps) return false;
      const auto [slowest, fastest] =
          std::minmax_element(plateaus.begin(), plateaus.end(), [](const auto& a, const auto& b) {
            return std::abs(a.speed_rad_s) < std::abs(b.speed_rad_s);
          });
      if (std::abs(fastest->speed_rad_s) < least_step_ratio * std::abs(slowest->speed_rad_s)) {
        return false;
      }
    }
    for (std::size_t k = 0; k < found.size(); ++k) {
      add_runs(group.strokes[k].first, found[k].plateaus);
    }
    return true;
  }

  void in_order_of_time() {
    std::sort(segments_.begin(), segments_.end(),
              [](const MotionSegment& a, const MotionSegment& b) { return a.first < b.first; });
  }

  [[nodiscard]] double effort_spread(std::size_t first, std::size_t last) const {
    if (trace_.effort.empty()) return 0;
    return spread({trace_.effort.begin() + static_cast<std::ptrdiff_t>(first),
                   trace_.effort.begin() + static_cast<std::ptrdiff_t>(last) + 1});
  }

  /// What lies before the first motion or behind the last, if it is hardly anything; with an
  /// oscillation, the last stroke in which it sticks while the torque goes on.
  void take_short_ends() {
    if (segments_.empty()) return;
    const auto is_short = [&](std::size_t from, std::size_t to, const MotionSegment& s) {
      if (seconds(from, to) < shortest_end_rest * s.duration_s()) return true;
      return s.kind == MotionKind::oscillation && seconds(from, to) < 0.5 / s.frequency_Hz &&
             effort_spread(from, to) > driven_share * effort_spread(s.first, s.last);
    };
    MotionSegment& front = segments_.front();
    if (is_short(0, front.first, front)) {
      front.first = 0;
      front.from_s = trace_.t_s.front();
    }
    MotionSegment& back = segments_.back();
    if (is_short(back.last, trace_.size() - 1, back)) {
      back.last = trace_.size() - 1;
      back.to_s = trace_.t_s.back();
    }
  }

  void add_rests() {
    std::vector<MotionSegment> rests;
    std::size_t first = 0;
    const double shortest_s = shortest_rest * seconds(0, trace_.size() - 1);
    const auto rest_until = [&](std::size_t last) {
      if (last > first && seconds(first, last) > shortest_s) {
        MotionSegment s = segment(MotionKind::rest, first, last);
        const double still = std::max(smallest_travel_floors * floor_, largest_drift * range_);
        if (s.travel_rad() > still) s.kind = MotionKind::varying;
        rests.push_back(s);
      }
    };
    for (const MotionSegment& s : segments_) {
      rest_until(s.first);
      first = s.last;
    }
    rest_until(trace_.size() - 1);
    segments_.insert(segments_.end(), rests.begin(), rests.end());
    in_order_of_time();
  }

  const AngleTrace& trace_;
  double floor_{};
  double range_{};
  std::vector<StrokeGroup> oscillations_;
  std::vector<StrokeGroup> others_;
  std::vector<MotionSegment> segments_;
};

}  // namespace

std::string to_string(MotionKind kind) {
  constexpr EnumTexts<MotionKind> texts("rest", "constant speed", "slow sweep", "oscillation",
                                        "break-away ramp", "other motion");
  return std::string(texts.of(kind));
}

std::vector<MotionSegment> cut_by_motion(const AngleTrace& trace) {
  return MotionCutter(trace).cut();
}

}  // namespace tribolog::inspect::motion
