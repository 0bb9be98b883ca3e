#pragma once
// Internal to the checks: the recordings with what several checks need to know about them.

#include <string>
#include <vector>

#include "joint/dataset.h"
#include "method/motion/moving_part.h"
#include "method/motion/plateaus.h"

namespace tribolog::method::checks {

inline const std::string pure_number{"1"};
inline const std::string percent_sign{"%"};
inline const std::string kelvin{"K"};

struct CheckedRecording {
  const joint::Recording* recording{};
  motion::MotionSegments motion;
  std::vector<motion::Stroke> strokes;  ///< Empty: the joint does not move.
  double lowest_rad{};
  double highest_rad{};
  double interval_s{};      ///< Median time from sample to sample.
  double angle_step_rad{};  ///< 0: continuous.
  bool step_is_of_print{};  ///< See AngleStep.

  /// Sweep or run: travels over a range, neither oscillates nor starts from rest.
  [[nodiscard]] bool travels() const {
    return recording->role != joint::Role::oscillation &&
           recording->role != joint::Role::break_away;
  }
  [[nodiscard]] double range_rad() const { return highest_rad - lowest_rad; }
  /// The useful part of the recording: the plateaus of a run at constant speed, else its strokes. A
  /// run's start, stop and return do not count.
  [[nodiscard]] std::vector<motion::Stroke> ways() const;
};

struct CheckedDataset {
  const joint::Manifest* manifest{};
  const std::vector<joint::InputFile>* inputs{};  ///< Of a simulated joint: empty.
  std::vector<CheckedRecording> recordings;
  bool has_torque{};

  [[nodiscard]] std::vector<const CheckedRecording*> with_role(joint::Role role) const;
  /// Whether the manifest states that there is none.
  [[nodiscard]] bool has_no_gravity() const {
    return manifest != nullptr && manifest->known_gravity &&
           manifest->known_gravity->amplitude_Nm() == 0;
  }
  [[nodiscard]] bool has_role(joint::Role role) const { return !with_role(role).empty(); }
};

CheckedDataset look_at(const joint::Dataset& dataset);

}  // namespace tribolog::method::checks
