#include "calibration/reading_name.h"

#include <array>
#include <cstddef>

namespace tribolog::calibration {
namespace {

/// In the order of the enumeration.
constexpr std::array keys{"A",
                          "B",
                          "C",
                          "D",
                          "E",
                          "F",
                          "A_steady",
                          "B_steady",
                          "AB",
                          "CD",
                          "EF",
                          "midline",
                          "model",
                          "fit",
                          "q_peak",
                          "bristle_stiffness",
                          "static_torque",
                          "sweep_friction",
                          "coulomb",
                          "viscous",
                          "asperity_torque",
                          "stribeck_speed",
                          "stribeck_power",
                          "viscous_coefficient",
                          "viscous_power",
                          "break_away"};

}  // namespace

std::string to_string(ReadingName name) { return keys.at(static_cast<std::size_t>(name)); }

std::optional<method::hysteresis::Estimator> estimator_of(ReadingName name) {
  return method::hysteresis::estimator_of(to_string(name));
}

}  // namespace tribolog::calibration
