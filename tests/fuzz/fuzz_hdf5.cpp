// libFuzzer: whatever bytes an HDF5 file has, it is read or refused in one clear line.

#include <cstdint>

#include <hdf5.h>

#include "fuzz/check_tables.h"
#include "fuzz/file_in_memory.h"
#include "fuzz/outcomes.h"
#include "ingest/arrays/array_readers.h"

// The library frees its table of half a megabyte with every file, and page by page gets it anew:
// two thirds of the time. Here it keeps it; lists of buffers keep what they keep elsewhere.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  constexpr int mebibyte = 1 << 20;
  const auto limits_set =
      H5set_free_list_limits(-1, -1, 4 * mebibyte, mebibyte / 4, 16 * mebibyte, mebibyte);
  return limits_set < 0 ? 1 : 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static tribolog::fuzz::FileInMemory file;
  tribolog::fuzz::read_or_refuse([&] {
    tribolog::fuzz::check_tables(tribolog::ingest::arrays::read_hdf5(file.holding(data, size)));
  });
  return 0;
}
