#pragma once
// How many resamples of the bootstrap a user may ask for.

#include <cstddef>
#include <cstdint>
#include <string>

namespace tribolog {

/// Fewest resamples from which the ends of a 95 % interval can be read.
inline constexpr std::size_t fewest_resamples = 100;
inline constexpr std::size_t most_resamples = 1000000;

/// 0 (no bootstrap), or from the fewest to the most.
bool resamples_are_allowed(std::uint64_t resamples);
/// "0 (closed forms alone), or 100 to 1000000"
std::string allowed_resamples_in_words();

}  // namespace tribolog
