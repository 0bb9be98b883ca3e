#pragma once
// Prescribed motion of the motor shaft over time, and where it turns round.

#include <span>
#include <vector>

namespace tribolog::simulate {

/// Angle [rad], speed [rad/s] and acceleration [rad/s^2] as functions of time [s].
class Motion {
 public:
  virtual ~Motion() = default;
  [[nodiscard]] virtual double angle(double t_s) const = 0;
  [[nodiscard]] virtual double speed(double t_s) const = 0;
  [[nodiscard]] virtual double acceleration(double t_s) const = 0;
  /// Speeds at t0, t0 + dt, ...; a motion that can do better than one call each overrides it.
  virtual void speeds(double t0_s, double dt_s, std::span<double> out) const;
};

/// angle = centre + sum of amplitude_k sin(2 pi k f t + phase_k), k = 1, 2, ...
class HarmonicMotion final : public Motion {
 public:
  struct Harmonic {
    double cosine{};  ///< Factor of cos(2 pi k f t).
    double sine{};    ///< Factor of sin(2 pi k f t).
  };
  /// @throw std::invalid_argument if the frequency is not > 0 or there is no harmonic.
  HarmonicMotion(double centre_rad, double frequency_Hz, std::vector<Harmonic> harmonics);
  /// centre + amplitude sin(2 pi f t)
  static HarmonicMotion sine(double centre_rad, double amplitude_rad, double frequency_Hz);

  [[nodiscard]] double angle(double t_s) const override;
  [[nodiscard]] double speed(double t_s) const override;
  [[nodiscard]] double acceleration(double t_s) const override;
  void speeds(double t0_s, double dt_s, std::span<double> out) const override;

 private:
  double centre_rad_;
  double omega_rad_s_;
  std::vector<Harmonic> harmonics_;
};

/// Rest, smooth start, constant speed, smooth stop, rest; then the same way back if asked for.
/// The ramps are raised cosines of speed: no step in acceleration.
class TravelMotion final : public Motion {
 public:
  struct Plan {
    double from_rad{};
    double to_rad{};
    double speed_rad_s{};          ///< > 0
    double acceleration_rad_s2{};  ///< > 0, the largest within a ramp.
    bool back{true};
    double rest_s{0.1};  ///< Before, between and after.
  };
  /// @throw Refusal if the way is too short to reach the speed.
  explicit TravelMotion(const Plan& plan);

  [[nodiscard]] double angle(double t_s) const override;
  [[nodiscard]] double speed(double t_s) const override;
  [[nodiscard]] double acceleration(double t_s) const override;
  [[nodiscard]] double duration_s() const;
  /// Way of one ramp [rad] for a speed and a largest acceleration.
  static double ramp_way_rad(double speed_rad_s, double acceleration_rad_s2);

 private:
  struct Phase;  // one stroke's kinematics at a time within it
  [[nodiscard]] Phase at(double t_s) const;

  Plan plan_;
  double ramp_s_;
  double cruise_s_;
};

// Where a prescribed motion turns round.

/// Is one of the three speeds forward and another one backward?
inline bool reverses(double w0, double wm, double w1) {
  return (w0 > 0 || wm > 0 || w1 > 0) && (w0 < 0 || wm < 0 || w1 < 0);
}

/// Time [s] in [a, b] at which the speed changes sign, by bisection to the last bit; the speed is
/// asked for only where its sign is in doubt.
/// @param negative_first whether the motion is backward before. It is the caller's to say: where
/// the reversal is at `a` itself, the speed there may have either sign by rounding.
double reversal_time(const Motion& motion, double a_s, double b_s, bool negative_first);

// A motion of the joint as its motor sees it.

/// Refers to the joint's motion, which must outlive it.
class MotorSide final : public Motion {
 public:
  MotorSide(const Motion& joint, double gear_ratio) : joint_(joint), n_(gear_ratio) {}
  [[nodiscard]] double angle(double t_s) const override { return n_ * joint_.angle(t_s); }
  [[nodiscard]] double speed(double t_s) const override { return n_ * joint_.speed(t_s); }
  [[nodiscard]] double acceleration(double t_s) const override {
    return n_ * joint_.acceleration(t_s);
  }

 private:
  const Motion& joint_;
  double n_;
};

}  // namespace tribolog::simulate
