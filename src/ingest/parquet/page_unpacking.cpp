#include "ingest/parquet/page_unpacking.h"

#include <array>
#include <bit>
#include <cstring>
#include <new>

#include <fmt/format.h>
#include <libdeflate.h>
#include <lz4.h>
#include <zstd.h>

#include "base/program_module.h"
#include "ingest/parquet/compact_protocol.h"
#include "ingest/parquet/file_metadata.h"

namespace tribolog::ingest::parquet {
namespace {

constexpr std::array codec_names = {"none",   "snappy", "gzip", "LZO",
                                    "brotli", "LZ4",    "zstd", "LZ4 (raw)"};

/// What a page may state: so many bytes, and so many for each that is stored.
constexpr std::size_t any_page_bytes = std::size_t{1} << 26;
constexpr std::size_t most_per_byte = 1100;
constexpr std::size_t largest_page_bytes = std::size_t{1} << 30;

bool may_unpack_to(std::size_t bytes, std::size_t stored) {
  return bytes <= largest_page_bytes &&
         (bytes <= any_page_bytes || (bytes - any_page_bytes) / most_per_byte <= stored);
}

/// @throw UnreadableParquet: a library is missing.
const PageCodecs& page_codecs(const char* codec) {
  static const PageCodecs codecs = [&] {
    try {
      void* const give =
          function_of({"tribolog_parquet", TRIBOLOG_PARQUET_PACKAGES}, "tribolog_page_codecs");
      PageCodecs given{};
      reinterpret_cast<decltype(&tribolog_page_codecs)>(give)(given);
      return given;
    } catch (const MissingModule& missing) {
      throw UnreadableParquet(fmt::format("Parquet compressed with {} cannot be read here", codec),
                              "", missing.what());
    }
  }();
  return codecs;
}

/// One gzip member, or several, of which each gives what is left of `bytes` at most.
bool unpack_gzip(std::string_view stored, char* to, std::size_t bytes) {
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> state(
      libdeflate_alloc_decompressor(), &libdeflate_free_decompressor);
  if (!state) throw std::bad_alloc();
  std::size_t filled = 0;
  while (!stored.empty()) {
    std::size_t in = 0;
    std::size_t out = 0;
    const auto result = libdeflate_gzip_decompress_ex(state.get(), stored.data(), stored.size(),
                                                      to + filled, bytes - filled, &in, &out);
    if (result != LIBDEFLATE_SUCCESS || in == 0) return false;
    filled += out;
    stored.remove_prefix(in);
  }
  return filled == bytes;
}

bool unpack_zstd(std::string_view stored, char* to, std::size_t bytes) {
  const std::size_t got = ZSTD_decompress(to, bytes, stored.data(), stored.size());
  return ZSTD_isError(got) == 0 && got == bytes;
}

bool unpack_lz4_raw(std::string_view stored, char* to, std::size_t bytes) {
  const int got = LZ4_decompress_safe(stored.data(), to, static_cast<int>(stored.size()),
                                      static_cast<int>(bytes));
  return got >= 0 && static_cast<std::size_t>(got) == bytes;
}

std::uint32_t big_endian_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < sizeof number; ++i) {
    number = (number << 8U) | static_cast<std::uint8_t>(bytes[at + i]);
  }
  return number;
}

/// As Hadoop frames it: the lengths of each block, unpacked and stored, in front of it.
bool unpack_lz4_hadoop(std::string_view stored, char* to, std::size_t bytes) {
  constexpr std::size_t head = 2 * sizeof(std::uint32_t);
  std::size_t filled = 0;
  while (stored.size() >= head) {
    const std::size_t unpacked = big_endian_at(stored, 0);
    const std::size_t packed = big_endian_at(stored, sizeof(std::uint32_t));
    stored.remove_prefix(head);
    if (packed > stored.size() || unpacked > bytes - filled) return false;
    if (!unpack_lz4_raw(stored.substr(0, packed), to + filled, unpacked)) return false;
    filled += unpacked;
    stored.remove_prefix(packed);
  }
  return stored.empty() && filled == bytes;
}

bool unpack(Codec codec, std::string_view stored, char* to, std::size_t bytes) {
  switch (codec) {
    case Codec::snappy:
      return page_codecs("snappy").unpack_snappy(stored, to, bytes);
    case Codec::gzip:
      return unpack_gzip(stored, to, bytes);
    case Codec::brotli:
      return page_codecs("brotli").unpack_brotli(stored, to, bytes);
    case Codec::lz4:  // what is called so was written in both ways
      return unpack_lz4_hadoop(stored, to, bytes) || unpack_lz4_raw(stored, to, bytes);
    case Codec::zstd:
      return unpack_zstd(stored, to, bytes);
    case Codec::lz4_raw:
      return unpack_lz4_raw(stored, to, bytes);
    case Codec::none:
    case Codec::lzo:
      break;
  }
  throw UnreadableParquet("is Parquet compressed with LZO, which is not read", "",
                          "write it with snappy, gzip, brotli, LZ4 or zstd");
}

}  // namespace

char* PageBytes::room_for(std::size_t bytes) {
  if (bytes <= room_ && bytes_) return bytes_.get();
  bytes_.reset();
  bytes_.reset(new char[bytes + 1]);  // not filled with zeros
  room_ = bytes;
  return bytes_.get();
}

std::string_view unpack_page(std::int64_t codec, std::string_view stored,
                             std::size_t unpacked_bytes, PageBytes& room) {
  if (codec < 0 || codec >= static_cast<std::int64_t>(codec_names.size())) {
    throw UnreadableParquet(fmt::format("damaged: compressed with an unknown codec {}", codec));
  }
  if (static_cast<Codec>(codec) == Codec::none) {
    if (stored.size() != unpacked_bytes) {
      throw UnreadableParquet("damaged: a page that is not compressed states two lengths");
    }
    return stored;
  }
  if (!may_unpack_to(unpacked_bytes, stored.size())) {
    throw UnreadableParquet(fmt::format("damaged: a page of {} bytes states to unpack to {}",
                                        stored.size(), unpacked_bytes));
  }
  char* const to = room.room_for(unpacked_bytes);
  if (unpacked_bytes == 0 && stored.empty()) return {};
  if (!unpack(static_cast<Codec>(codec), stored, to, unpacked_bytes)) {
    throw UnreadableParquet(fmt::format("damaged: a page does not unpack to its {} bytes by {}",
                                        unpacked_bytes,
                                        codec_names[static_cast<std::size_t>(codec)]));
  }
  return {to, unpacked_bytes};
}

}  // namespace tribolog::ingest::parquet
