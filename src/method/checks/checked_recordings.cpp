#include "method/checks/checked_recordings.h"

#include <algorithm>
#include <cmath>

#include "method/motion/encoder_resolution.h"
#include "statistics/order_statistics.h"

namespace tribolog::method::checks {
namespace {

// A reversal counts where the angle runs back by this share of its range, or by a few steps of the
// encoder: less is noise.
constexpr double share_of_a_turn = 0.05;
constexpr double steps_of_a_turn = 4;

CheckedRecording look_at(const joint::Recording& r, double gear_ratio) {
  CheckedRecording out;
  out.recording = &r;
  out.motion = motion::find_plateaus(r);
  if (r.size() < 2) return out;
  const auto [low, high] = std::minmax_element(r.q_rad.begin(), r.q_rad.end());
  out.lowest_rad = *low;
  out.highest_rad = *high;
  out.interval_s = statistics::median_interval(r.t_s);
  const motion::AngleStep step = motion::angle_step(r.q_rad, gear_ratio);
  out.angle_step_rad = step.step_rad;
  out.step_is_of_print = step.is_of_the_print;
  const double noise =
      std::max(share_of_a_turn * out.range_rad(), steps_of_a_turn * out.angle_step_rad);
  if (out.range_rad() > noise) out.strokes = motion::find_strokes(r.q_rad, noise);
  return out;
}

}  // namespace

std::vector<motion::Stroke> CheckedRecording::ways() const {
  if (recording->role != joint::Role::constant_speed || motion.plateaus.empty()) return strokes;
  std::vector<motion::Stroke> plateaus;
  for (const motion::Plateau& plateau : motion.plateaus) {
    const std::size_t last = plateau.last - 1;
    plateaus.push_back({plateau.first, last, plateau.speed_rad_s > 0 ? 1.0 : -1.0,
                        std::abs(recording->q_rad[last] - recording->q_rad[plateau.first])});
  }
  return plateaus;
}

std::vector<const CheckedRecording*> CheckedDataset::with_role(joint::Role role) const {
  std::vector<const CheckedRecording*> found;
  for (const CheckedRecording& r : recordings) {
    if (r.recording->role == role) found.push_back(&r);
  }
  return found;
}

CheckedDataset look_at(const joint::Dataset& dataset) {
  CheckedDataset out;
  out.manifest = &dataset.manifest;
  out.inputs = &dataset.inputs;
  out.has_torque = dataset.manifest.drive.kind() != joint::EffortKind::none;
  const double n = dataset.manifest.drive.gear_ratio();
  for (const joint::Recording& r : dataset.recordings) out.recordings.push_back(look_at(r, n));
  return out;
}

}  // namespace tribolog::method::checks
