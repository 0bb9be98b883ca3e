#include <cstddef>
#include <cstdint>
#include <string_view>

#include <brotli/decode.h>
#include <snappy.h>

#include "ingest/parquet/page_unpacking.h"

namespace tribolog::ingest::parquet_codecs {
namespace {

bool unpack_snappy(std::string_view stored, char* to, std::size_t bytes) {
  std::size_t stated = 0;
  return snappy::GetUncompressedLength(stored.data(), stored.size(), &stated) && stated == bytes &&
         snappy::RawUncompress(stored.data(), stored.size(), to);
}

bool unpack_brotli(std::string_view stored, char* to, std::size_t bytes) {
  std::size_t got = bytes;
  const auto result =
      BrotliDecoderDecompress(stored.size(), reinterpret_cast<const std::uint8_t*>(stored.data()),
                              &got, reinterpret_cast<std::uint8_t*>(to));
  return result == BROTLI_DECODER_RESULT_SUCCESS && got == bytes;
}

}  // namespace
}  // namespace tribolog::ingest::parquet_codecs

void tribolog_page_codecs(tribolog::ingest::parquet::PageCodecs& codecs) {
  codecs = {&tribolog::ingest::parquet_codecs::unpack_snappy,
            &tribolog::ingest::parquet_codecs::unpack_brotli};
}
