#pragma once
// Texts that are the same but for the last digits of their numbers, which differ from one
// mathematics library to another.

#include <string>

namespace tribolog::test {

/// "" where each number of one is that of the other, within `share` of it or 1, and all else is the
/// same; otherwise what stands at the first difference.
std::string difference(const std::string& a, const std::string& b, double share);

}  // namespace tribolog::test
