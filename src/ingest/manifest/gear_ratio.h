#pragma once
// A gear ratio as catalogues write it.

#include <string_view>

namespace tribolog::ingest::manifest {

/// Motor turns to turns of the joint: 101 of "101:1", "101" or "202 : 2".
/// @throw std::invalid_argument: it is not a ratio, or the wrong way round ("1:101"), with what
/// would be
///        right in words.
double parse_gear_ratio(std::string_view text);

}  // namespace tribolog::ingest::manifest
