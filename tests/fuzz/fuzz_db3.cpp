// libFuzzer: whatever bytes a rosbag2 database has, it is read or refused in one clear line.

#include <cstdint>

#include "fuzz/check_tables.h"
#include "fuzz/file_in_memory.h"
#include "fuzz/outcomes.h"
#include "ingest/bags/bag_readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static tribolog::fuzz::FileInMemory file;
  tribolog::fuzz::read_or_refuse([&] {
    tribolog::fuzz::check_tables(tribolog::ingest::bags::read_rosbag_db3(file.holding(data, size)));
  });
  return 0;
}
