#pragma once
// The bytes of a page as they were before they were compressed.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

namespace tribolog::ingest::parquet {

/// Bytes that nobody has filled yet: a page claims many, and few may come.
class PageBytes {
 public:
  /// At least so many; what they held is lost.
  char* room_for(std::size_t bytes);

 private:
  std::unique_ptr<char[]> bytes_;
  std::size_t room_{};
};

/// @param codec as the file numbers it.
/// @param unpacked_bytes as the page states it.
/// @param room where they are put unless they stand uncompressed already.
/// @throw UnreadableParquet: damaged, stating more than the bytes can give, of a codec that is not
///        read, or one whose library is missing.
std::string_view unpack_page(std::int64_t codec, std::string_view stored,
                             std::size_t unpacked_bytes, PageBytes& room);

// What the module tribolog_parquet reads, by the libraries of snappy and brotli.

struct PageCodecs {
  /// Fills all of `to`. @return false: damaged, or of another length.
  bool (*unpack_snappy)(std::string_view stored, char* to, std::size_t bytes);
  bool (*unpack_brotli)(std::string_view stored, char* to, std::size_t bytes);
};

}  // namespace tribolog::ingest::parquet

/// What the module gives to the program.
extern "C" __attribute__((visibility("default"))) void tribolog_page_codecs(
    tribolog::ingest::parquet::PageCodecs& codecs);
