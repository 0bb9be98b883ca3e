#pragma once
// Logs that are written faster than the robot sends: each sample stands in several rows.

#include <cstddef>
#include <optional>
#include <vector>

namespace tribolog::ingest::dataset {

struct HeldRows {
  std::vector<std::size_t> kept;  ///< The first row of each sample.
  std::size_t rows_per_sample{};  ///< Median.
};

/// Rows in which all signals repeat the row before, where signals change together and at every
/// second row or more rarely. A coarse encoder beside a noisy torque is none: they change apart.
/// @param rows of the signals, in the order of time. @param signals two or more.
/// @return nothing where samples are not held.
std::optional<HeldRows> find_held_rows(const std::vector<std::size_t>& rows,
                                       const std::vector<const std::vector<double>*>& signals);

}  // namespace tribolog::ingest::dataset
