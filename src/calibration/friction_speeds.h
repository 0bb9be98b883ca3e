#pragma once
// Friction at speeds of the motor: a few of them for a table, either side of the gear, and where it
// is usable.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "calibration/quantity_verdict.h"

namespace tribolog::calibration {

/// Of a list, enough for a table that people read.
inline constexpr std::size_t speeds_of_a_table = 5;

/// At the joint: speed / |n|, torque × |n|.
FrictionAtSpeed at_joint(FrictionAtSpeed at_motor, double gear_ratio);

/// So many of them, evenly spaced in the logarithm of the speed from the first to the last: of each
/// the nearest that is there, none twice. @param speeds_rad_s rising, > 0.
/// @return their indices, rising.
std::vector<std::size_t> evenly_in_log(const std::vector<double>& speeds_rad_s, std::size_t count);
std::vector<FrictionAtSpeed> evenly_in_log(const std::vector<FrictionAtSpeed>& all,
                                           std::size_t count);

// Friction of two calibrations is compared at the same speeds, whatever was recorded at: at 1, 3
// and 10 rad/s of the motor and so on. An archive keeps it as quantities of these names.

/// Of those speeds the ones from the first to the last recorded, between two recorded ones by a
/// power of the speed; the verdict is the worse of the two.
/// @param all rising speed.
std::vector<FrictionAtSpeed> at_standard_speeds(const std::vector<FrictionAtSpeed>& all);

/// "friction_at_10" [rad/s].
std::string friction_name(double speed_rad_s);

/// The speed in such a name [rad/s]; nothing for another quantity's.
std::optional<double> speed_of_friction(const std::string& name);

/// With those speeds that the manifest states and that lie between the recorded ones, marked.
/// @param speeds_rad_s of the motor.
std::vector<FrictionAtSpeed> with_stated_speeds(std::vector<FrictionAtSpeed> all,
                                                const std::vector<double>& speeds_rad_s);

/// Marks them in friction that was read from a file.
void mark_stated_speeds(const std::vector<double>& speeds_rad_s, std::vector<FrictionAtSpeed>& all);

/// Those that a table shows: the stated ones or, where none is stated, so many of all.
std::vector<FrictionAtSpeed> of_a_table(const std::vector<FrictionAtSpeed>& all,
                                        std::size_t count = speeds_of_a_table);

struct SpeedRange {
  double low_rad_s{};
  double high_rad_s{};
};

/// The stretches without a speed that is not usable, rising; where there are more than `most`,
/// those of the most speeds.
std::vector<SpeedRange> usable_ranges(const std::vector<FrictionAtSpeed>& all, std::size_t most);

}  // namespace tribolog::calibration
