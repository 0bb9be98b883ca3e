#pragma once
// One recording of one joint: what was measured, in SI, every signal on a stated side.

#include <cstddef>
#include <string>
#include <vector>

#include "base/statement.h"

namespace tribolog::joint {

/// What the joint was made to do. A recording has one role; a dataset any number of each.
enum class Role {
  rough_sweep,     ///< Slow motion over the joint's range.
  precise_sweep,   ///< Slow motion close around the gravity peak.
  oscillation,     ///< Micro-oscillation, within or just beyond pre-sliding.
  constant_speed,  ///< One or more plateaus of constant speed.
  break_away,      ///< From rest, torque rising slowly until the joint slides.
  /// Read elsewhere: points of the friction curve, no recording (FrictionPoints).
  friction_points,
};

std::string to_string(Role role);

/// Why a row of the file is not among the samples.
struct SkippedRows {
  Statement reason;  ///< Outside the window, a gap in a column, ...
  std::size_t count{};
};

/// All vectors are as long as t_s, except the optional ones, which may be empty.
struct Recording {
  std::string name;  ///< Of its file, without the folders that all recordings share.
  Role role{};
  std::vector<double> t_s;            ///< Time [s], strictly increasing.
  std::vector<double> q_rad;          ///< Joint angle [rad], arm side.
  std::vector<double> dq_rad_s;       ///< Logged joint speed [rad/s], arm side; empty: not logged.
  std::vector<double> torque_Nm;      ///< Driving torque T [N·m], motor side; empty: not recorded.
  std::vector<double> z_rad;          ///< Mean bristle deflection [rad], motor side; usually empty.
  std::vector<double> dz_rad_s;       ///< Its rate [rad/s], motor side; usually empty.
  std::vector<double> temperature_C;  ///< Of the motor or the gear [°C]; usually empty.
  /// Gravity that the other joints' motion changes, by a description of the arm [N·m, motor side]:
  /// subtracted from torque_Nm; usually empty.
  std::vector<double> others_gravity_Nm{};
  /// Angles of the other joints that move in the session, in the order of Manifest::other_joints
  /// [rad]; of one that this log has not, an empty one. Empty: none moves, or a description tells
  /// their gravity.
  std::vector<std::vector<double>> others_q_rad{};
  std::size_t rows_read{};           ///< Data rows in the file.
  std::vector<SkippedRows> skipped;  ///< rows_read = size() + the sum of these counts.

  [[nodiscard]] std::size_t size() const { return t_s.size(); }
};

/// Points of the friction curve that another tool, a test stand or a publication gives: friction
/// alone, for gravity was taken off before or there is none. Vectors are as long as speed_rad_s,
/// but the last two, which may be empty.
struct FrictionPoints {
  std::string name;                   ///< As of a recording.
  std::vector<double> speed_rad_s;    ///< Signed, motor side [rad/s]; none is 0.
  std::vector<double> torque_Nm;      ///< Friction torque, motor side; of the speed's sign.
  std::vector<double> temperature_C;  ///< [°C]
  std::vector<double> load_Nm;        ///< Torque that loads the gear, motor side.
  std::size_t rows_read{};
  std::vector<SkippedRows> skipped;  ///< rows_read = size() + the sum of these counts.

  [[nodiscard]] std::size_t size() const { return speed_rad_s.size(); }
};

}  // namespace tribolog::joint
