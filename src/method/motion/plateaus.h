#pragma once
// Where a recording moves at constant speed. Found from the angle itself (local slope), because
// logged speeds are often filtered, delayed or wrongly scaled.

#include <cstddef>
#include <vector>

#include "joint/recording.h"

namespace tribolog {

struct Plateau {
  std::size_t first{};   ///< Index of the first sample.
  std::size_t last{};    ///< One past the last.
  double speed_rad_s{};  ///< Mean joint speed, signed.
  [[nodiscard]] std::size_t size() const { return last - first; }
};

/// A recording cut by its motion. The four counts add up to the recording's size.
struct MotionSegments {
  std::vector<Plateau> plateaus;    ///< In the order of time.
  std::vector<double> speed_rad_s;  ///< Local slope of the angle, one per sample.
  std::vector<double> acceleration_rad_s2;
  std::size_t samples_on_plateaus{};
  std::size_t samples_at_rest{};
  std::size_t samples_accelerating{};  ///< Speeding up, slowing down, reversing.
  std::size_t samples_trimmed{};       ///< Cut off a plateau's ends as settling.
  double fastest_rad_s{};              ///< Largest |local slope|.
  std::size_t window{};                ///< Samples that a local slope is made from.
  /// Share of the moving samples that lies on plateaus; low for a sine.
  [[nodiscard]] double plateau_share() const;
};

struct PlateauOptions {
  double tolerance{0.02};       ///< Largest relative deviation of speed on a plateau.
  double shortest_share{0.03};  ///< Of the recording's duration.
  std::size_t fewest_samples{20};
  double rest_share{0.02};  ///< Of the fastest speed: slower is rest.
};

MotionSegments find_plateaus(const Recording& recording, const PlateauOptions& options = {});

}  // namespace tribolog
