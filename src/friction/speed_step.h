#pragma once
// A short piece of prescribed motion, as friction models advance over it.

namespace tribolog::friction {

/// -1, 0 or 1.
inline double direction_of(double speed_rad_s) {
  return speed_rad_s > 0 ? 1.0 : speed_rad_s < 0 ? -1.0 : 0.0;
}

/// Speed over a step, as the parabola through its start, middle and end. None of the three is of
/// opposite sign to another: a motion is cut at its reversals before models see it.
struct SpeedStep {
  double start_rad_s{};
  double middle_rad_s{};
  double end_rad_s{};
  double duration_s{};

  /// Signed way [rad]; exact for the parabola.
  [[nodiscard]] double path_rad() const {
    return duration_s / 6 * (start_rad_s + 4 * middle_rad_s + end_rad_s);
  }
  /// -1, 0 or 1.
  [[nodiscard]] double direction() const {
    return direction_of(start_rad_s + middle_rad_s + end_rad_s);
  }
  /// At a share (0..1) of the duration.
  [[nodiscard]] double speed_rad_s(double share) const {
    const double rise = end_rad_s - start_rad_s;
    const double bend = 2 * (start_rad_s + end_rad_s - 2 * middle_rad_s);
    const double inside = share * (share - 1);
    return start_rad_s + rise * share + bend * inside;
  }
  /// The piece between two shares of the duration.
  [[nodiscard]] SpeedStep part(double from, double to) const {
    return {speed_rad_s(from), speed_rad_s((from + to) / 2), speed_rad_s(to),
            (to - from) * duration_s};
  }
};

}  // namespace tribolog::friction
