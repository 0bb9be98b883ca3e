#pragma once
// What an export is made of: one archived calibration.

#include <optional>
#include <string>
#include <vector>

#include "calibration/archived_calibration.h"
#include "calibration/friction_speeds.h"
#include "joint/drive.h"
#include "joint/quantity.h"

namespace tribolog::exports::results {

struct ArchivedJoint {
  calibration::Entry entry;
  bool is_archived{true};                         ///< Else its file alone is there.
  std::vector<calibration::Quantity> quantities;  ///< SI, motor side.
  std::string calibration;  ///< The file of `tribolog identify`; empty: not archived.

  /// @return nullptr if it is not archived, or without an estimate.
  [[nodiscard]] const calibration::Quantity* found(joint::Quantity quantity) const;
  /// The torque constant was not known: torques are numbers of amperes.
  [[nodiscard]] bool is_in_amperes() const;
};

/// What an export for a simulator may do beyond the usual.
struct SimulatorOptions {
  bool doubtful_too{};  ///< Also numbers whose verdict is not usable.
  joint::Side side{joint::Side::joint};
  /// Speeds of the joint over which a poorer law is to be the best; absent: all that are usable.
  std::optional<calibration::SpeedRange> range_rad_s;
  /// Inertia of all that the joint moves about its axis [kg·m²], joint side: that of the links in
  /// the simulator's model.
  std::optional<double> arm_inertia_kgm2;
};

// What every export says about itself, in the comments of its format.

/// Robot, joint, date and id, what it was made with, gear ratio and the conversions between the
/// sides. No line holds a line break or a character that hides; else names stand as they are, and
/// each format still has to take care of what ends its comments.
std::vector<std::string> comment_lines(const ArchivedJoint& joint);

/// One line with an estimate: "Coulomb torque at the joint: 44.96 N·m (95 %: 41.85 to 48.22),
/// usable; archived × n".
std::string estimate_line(const calibration::Quantity& quantity, double gear_ratio,
                          joint::Side side);

/// The shortest that reads back to the same double. @param number finite.
std::string shortest(double number);

/// Text on one line, in which nothing hides.
std::string one_line(const std::string& text);

}  // namespace tribolog::exports::results
