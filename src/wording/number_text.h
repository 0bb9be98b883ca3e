#pragma once
// Numbers in the words of captions and labels: as many digits as the interval lets stand.

#include <cstddef>
#include <string>
#include <vector>

#include "statistics/estimate.h"
#include "wording/axis_scale.h"
#include "wording/rounding.h"

namespace tribolog::wording {

/// The value to the place that shows `largest` with so many digits: members of one list.
std::string to_place(double value, double largest, int digits);

/// "3.8832 N·m"; degrees without the space: "−22.23°".
std::string with_unit(double value_in_si, const AxisScale& scale, int digits);

/// "5.0 mN·m", or "below 1 µN·m" where the size is under a floor that no drive resolves: the
/// rounding of a computer is no result. For "%" the floor is in percent.
std::string size_words(double size_in_si, double floor, const std::string& si_unit);

/// What is meant by nothing: smaller differences are the computer's own.
inline constexpr double torque_floor_Nm = 1e-6;
inline constexpr double percent_floor = 1e-3;

/// "3.8832 ± 0.0043 N·m", the interval to two digits and the value to the same place. Where the
/// interval is lopsided: "3.883 N·m (3.879 to 3.899)". Without an interval: five digits.
std::string with_interval(const statistics::Estimate& estimate, const AxisScale& scale);

/// The value alone, rounded to where its interval begins: "3.883 N·m".
std::string rounded(const statistics::Estimate& estimate, const AxisScale& scale);

/// The day alone: "2026-01-31" of "2026-01-31T12:00:00Z". A shorter text stays as it is.
std::string date_of(const std::string& utc);

/// "1 run", "20 runs"
std::string counted(std::size_t count, const std::string& singular);

/// "A, B and C"
std::string listed(const std::vector<std::string>& words);

}  // namespace tribolog::wording
