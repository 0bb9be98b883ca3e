// libFuzzer: whatever bytes an MDF 4 file has, it is read or refused in one clear line.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/check_tables.h"
#include "fuzz/outcomes.h"
#include "ingest/measurement/measurement_readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  tribolog::fuzz::read_or_refuse([&] {
    tribolog::fuzz::check_tables(tribolog::ingest::measurement::parse_mdf(bytes, "fuzz.mf4"));
  });
  return 0;
}
