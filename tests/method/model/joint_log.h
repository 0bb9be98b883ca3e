#pragma once
// A joint whose truth is known, and what it logs: sweeps and runs with gravity, inertia, friction
// and any of the small effects that the catalogue of the model has (method/model/effects.h).

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "joint/recording.h"
#include "method/model/model_quantities.h"

namespace tribolog::test {

/// Coefficients of the effects, in sizes of the joint's largest torque and its friction where the
/// catalogue counts so; 0: absent.
struct SmallEffects {
  double offset{};        ///< Of the largest torque.
  double offset_drift{};  ///< The same, at the session's end; the negative at its begin.
  double gain_drift{};    ///< Of gravity, likewise.
  double square{};        ///< Of M |M| / top.
  double cube{};          ///< Of M^3 / top^2.
  double gain_of_speed{};
  double gain_of_runs{};
  double tool{};  ///< Of gravity, in the runs.
  double lag_s{};
  double asymmetry_of_speed{};    ///< Of the friction, times v / fastest in both directions.
  double asymmetry_of_dip{};      ///< Times exp(-v / dip speed).
  double load{};                  ///< Friction per torque of gravity, beyond the mean one of runs.
  std::array<double, 5> place{};  ///< Friction over the angle, in cosines of half waves.
  double spring{};                ///< Of the largest torque, at the range's end.
  double angle_scale{};
  double peak_drift_rad{};
  std::array<double, 4> harmonics{};  ///< cos, sin of 2 and 3 times the angle from the peak.
  std::array<double, 6> waves{};      ///< Torque over the angle, half waves 3 to 8.
  std::array<double, 3> warm_up{};    ///< Of friction: exp(-age/0.12), exp(-age/0.4), age.
  double session{};                   ///< Friction of this session over that of all.
  double recording{};                 ///< Of friction: standard deviation between recordings.
  double tare{};                      ///< Of the largest torque, likewise.
  double motor_turn{};                ///< Of friction, once a turn of the motor.

  /// Each drawn at one standard deviation of its prior.
  static SmallEffects draw(std::uint64_t seed, double friction_of_top);
};

/// Motor side; angles of the joint.
struct KnownJoint {
  double gear_ratio{50};
  double gravity_Nm{1.0};
  double q_peak_rad{0.4};
  double inertia_kgm2{2e-3};
  double coulomb_Nm{0.25};
  double viscous_Nms_rad{0.004};
  double bend_Nm{};  ///< Times sqrt(v / 45 rad/s): no law of the model is exact about it.
  double dip_Nm{};
  double dip_speed_rad_s{4};
  double noise_Nm{0.01};
  SmallEffects effects{};

  [[nodiscard]] double friction_Nm(double speed_rad_s) const;
};

/// What is recorded; speeds and angles of the joint.
struct Session {
  double dt_s{0.005};
  double low_rad{-1.3};
  double high_rad{1.0};
  double run_way_rad{0.8};
  double acceleration_rad_s2{2};
  int sweeps{2};
  double sweep_speed_rad_s{0.3};
  std::vector<double> run_speeds_rad_s{0.05, 0.1, 0.2, 0.35, 0.6, 0.9};
  bool up{true};
  bool down{true};
};

struct JointLog {
  std::vector<joint::Recording> recordings;
  [[nodiscard]] std::vector<const joint::Recording*> all() const;
  /// As identify() calls it.
  [[nodiscard]] method::model::ModelResult identified(double gear_ratio,
                                                      bool has_gravity = true) const;
};

JointLog record(const KnownJoint& joint, const Session& session, std::uint64_t seed);

/// That at the speed nearest to `speed_rad_s`. @throw std::out_of_range if there is none.
const method::model::ModelQuantity& friction_at(const method::model::ModelResult& result,
                                                double speed_rad_s);
const method::model::ModelQuantity& found(const method::model::ModelResult& result,
                                          joint::Quantity quantity);
const method::model::ModelEffect& found(const method::model::ModelResult& result,
                                        const std::string& effect);

inline double half_width(const method::model::ModelQuantity& q) { return (q.high - q.low) / 2; }
inline bool holds(const method::model::ModelQuantity& q, double truth) {
  return q.low <= truth && truth <= q.high;
}

}  // namespace tribolog::test
