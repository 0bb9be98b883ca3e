#pragma once
// Where a recording moves at constant speed. Found from the angle itself (local slope), because
// logged speeds are often filtered, delayed or wrongly scaled.

#include <cstddef>
#include <string>
#include <vector>

#include "joint/dataset.h"
#include "joint/recording.h"

namespace tribolog::method::motion {

/// Speeds whose relative difference is smaller count as one: of runs in both directions, of runs at
/// one commanded speed.
inline constexpr double same_speed = 0.03;

struct Plateau {
  std::size_t first{};   ///< Index of the first sample.
  std::size_t last{};    ///< One past the last.
  double speed_rad_s{};  ///< Mean joint speed, signed.
  [[nodiscard]] std::size_t size() const { return last - first; }
};

/// A recording segmented by its motion. The four counts add up to the recording's size.
struct MotionSegments {
  std::vector<Plateau> plateaus;    ///< In the order of time.
  std::vector<double> speed_rad_s;  ///< Local slope of the angle, one per sample.
  std::vector<double> acceleration_rad_s2;
  std::size_t samples_on_plateaus{};
  std::size_t samples_at_rest{};
  std::size_t samples_accelerating{};  ///< Speeding up, slowing down, reversing.
  std::size_t samples_trimmed{};       ///< Settling: cut off a plateau's ends, overshoots.
  double fastest_rad_s{};              ///< Largest |local slope|.
  std::size_t window{};                ///< Number of samples that a local slope is computed from.
  /// Share of the moving samples that lie on plateaus; low for a sine.
  [[nodiscard]] double plateau_share() const;
};

struct PlateauOptions {
  double tolerance{0.02};       ///< Largest relative deviation of speed on a plateau.
  double shortest_share{0.03};  ///< Of the recording's duration.
  std::size_t fewest_samples{20};
  double rest_share{0.02};  ///< Of the fastest speed: slower counts as rest.
};

MotionSegments find_plateaus(const joint::Recording& recording, const PlateauOptions& options = {});

// How the speed of each recording is found. Never from a logged speed: that is often filtered,
// delayed or wrongly scaled, and the angle contains all the information; the checks on the data
// compare the logged speed with it.

struct SpeedSource {
  std::string recording;
  joint::Role role{};
  bool is_logged{};      ///< A speed is logged too.
  std::size_t window{};  ///< Number of samples that a local slope of the angle is computed from.
  double window_s{};     ///< Their duration at the median interval.
  double cut_off_Hz{};   ///< -3 dB of that derivative; see sampled_signal.h.
};

/// One for each recording with two or more samples.
std::vector<SpeedSource> speed_sources(const std::vector<joint::Recording>& recordings);

}  // namespace tribolog::method::motion
