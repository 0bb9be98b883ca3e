#pragma once
// Room for long columns, in pages of megabytes where the system has them: a first touch of every
// four kilobytes costs as much as reading the numbers that go there.

#include <cstddef>
#include <vector>

namespace tribolog {

/// Room for `count` values, as std::vector::reserve. Memory that is not used is not taken.
void reserve_in_large_pages(std::vector<double>& values, std::size_t count);

}  // namespace tribolog
