// libFuzzer: whatever bytes a Parquet file has, it is read or refused in one clear line.

#include <cstdint>
#include <string_view>

#include "fuzz/check_tables.h"
#include "fuzz/outcomes.h"
#include "ingest/parquet/parquet_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  tribolog::fuzz::read_or_refuse([&] {
    tribolog::fuzz::check_tables(tribolog::ingest::parquet::parse_parquet(bytes, "a.parquet"));
  });
  return 0;
}
