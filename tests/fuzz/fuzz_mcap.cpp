// libFuzzer: whatever bytes an MCAP log has, with messages in CDR, JSON or protobuf or of ROS 1, it
// is read or refused in one clear line.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/check_tables.h"
#include "fuzz/outcomes.h"
#include "ingest/bags/bag_readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::uint64_t largest_record_bytes = std::uint64_t{1} << 16;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  tribolog::fuzz::read_or_refuse([&] {
    tribolog::fuzz::check_tables(
        tribolog::ingest::bags::read_mcap_bytes(bytes, "fuzz.mcap", largest_record_bytes));
  });
  return 0;
}
