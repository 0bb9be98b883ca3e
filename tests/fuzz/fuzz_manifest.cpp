// libFuzzer: whatever a manifest holds, it is read or refused in one clear line.

#include <cstdint>
#include <string_view>

#include "fuzz/outcomes.h"
#include "ingest/manifest/manifest_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tribolog::fuzz::read_or_refuse([&] {
    (void)tribolog::ingest::manifest::parse_manifest({reinterpret_cast<const char*>(data), size},
                                                     "fuzz.toml");
  });
  return 0;
}
