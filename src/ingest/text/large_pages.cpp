#include "ingest/text/large_pages.h"

#include <cstdint>

#include <sys/mman.h>

namespace tribolog {

void reserve_in_large_pages(std::vector<double>& values, std::size_t count) {
  constexpr std::uintptr_t page = std::uintptr_t{1} << 21;
  values.reserve(count);
  const auto begin = reinterpret_cast<std::uintptr_t>(values.data());
  const std::uintptr_t first = (begin + page - 1) / page * page;
  const std::uintptr_t last = (begin + values.capacity() * sizeof(double)) / page * page;
  // A wish: whether the system grants it changes the speed alone.
  if (last > first) (void)madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
}

}  // namespace tribolog
