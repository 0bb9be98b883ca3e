#pragma once
// The entries of a zip archive, stored or deflated, with zip64 as NumPy writes it.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog {

struct ZipEntry {
  std::string name;
  std::uint16_t method{};  ///< 0 stored, 8 deflated.
  std::uint16_t flags{};
  std::uint32_t crc{};
  std::uint64_t packed_bytes{};
  std::uint64_t bytes{};
  std::uint64_t local_header{};  ///< Offset in the archive.
};

/// The entries by the directory at the archive's end.
/// @throw InputError where it is missing (a truncated file) or contradicts the archive's size.
std::vector<ZipEntry> list_zip(std::string_view archive, const std::string& file);

/// One entry's bytes; its stated size is believed only as far as its packed size can hold it.
/// @throw InputError naming the entry: encrypted, packed in another way, cut off, wrong checksum.
std::string unpack_zip_entry(std::string_view archive, const ZipEntry& entry,
                             const std::string& file);

}  // namespace tribolog
