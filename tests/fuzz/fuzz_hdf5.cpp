// libFuzzer: whatever bytes an HDF5 file has, it is read or refused in one clear line.

#include <cstdint>

#include "check_tables.h"
#include "file_in_memory.h"

#include "error.h"
#include "ingest/arrays/hdf5_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static tribolog::fuzz::FileInMemory file;
  try {
    tribolog::fuzz::check_tables(tribolog::read_hdf5(file.holding(data, size)));
  } catch (const tribolog::InputError&) {
  }
  return 0;
}
