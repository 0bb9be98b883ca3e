#pragma once
// The motions of a plan, joint side: each starts and ends at rest, with speed and acceleration that
// do not jump.

#include <memory>

#include "simulate/motion.h"

namespace tribolog::plan {

/// A motion from rest to rest; before 0 and behind its duration it stands.
class PlannedMotion : public simulate::Motion {
 public:
  [[nodiscard]] virtual double duration_s() const = 0;
};

/// Stands at an angle.
std::shared_ptr<const PlannedMotion> hold(double angle_rad, double duration_s);

/// From one angle to another, with smooth starts and stops; on a way too short for the speed,
/// slower. With `back` the same way back.
/// @param rest_s before, between and after.
/// @throw std::invalid_argument if speed or acceleration is not > 0, or the angles are the same.
std::shared_ptr<const PlannedMotion> travel(double from_rad, double to_rad, double speed_rad_s,
                                            double acceleration_rad_s2, bool back, double rest_s);

/// Whole cycles of a sine about a centre, with its speed rising from rest before them and falling
/// to rest behind: q = centre + amplitude sin(2 pi f (t - ease_s)) between ease_s and
/// duration - ease_s.
class EasedSine final : public PlannedMotion {
 public:
  /// @param ease_s length of each transition, > 0 and at most a fifth of a period.
  /// @param cycles a whole number >= 1.
  /// @throw std::invalid_argument quoting the value and the rule.
  EasedSine(double centre_rad, double amplitude_rad, double frequency_Hz, int cycles,
            double ease_s);

  [[nodiscard]] double angle(double t_s) const override;
  [[nodiscard]] double speed(double t_s) const override;
  [[nodiscard]] double acceleration(double t_s) const override;
  [[nodiscard]] double duration_s() const override { return duration_s_; }
  [[nodiscard]] double ease_s() const { return ease_s_; }
  /// Angles at which it starts and ends; each is off the centre by what the transition travels.
  [[nodiscard]] double start_rad() const;
  [[nodiscard]] double end_rad() const;
  /// No acceleration of such a motion is larger.
  static double largest_acceleration_rad_s2(double amplitude_rad, double frequency_Hz,
                                            double ease_s);

 private:
  /// Travel of the transition from its start up to a time in it.
  [[nodiscard]] double eased_way(double t_s) const;

  double centre_rad_;
  double amplitude_rad_;
  double omega_rad_s_;
  double ease_s_;
  double duration_s_;
};

}  // namespace tribolog::plan
