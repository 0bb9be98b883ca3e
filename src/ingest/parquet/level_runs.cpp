#include "ingest/parquet/level_runs.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

#include "ingest/parquet/compact_protocol.h"

namespace tribolog::ingest::parquet {
namespace {

constexpr unsigned most_run_bits = 32;
constexpr unsigned word_bits = 64;
static_assert(std::endian::native == std::endian::little, "bytes are taken as they stand");

/// Eight bytes from here on; those behind the end are 0.
std::uint64_t word_at(std::string_view bytes, std::size_t at) {
  std::uint64_t word = 0;
  if (at + sizeof word <= bytes.size()) {
    std::memcpy(&word, bytes.data() + at, sizeof word);
  } else if (at < bytes.size()) {
    std::memcpy(&word, bytes.data() + at, bytes.size() - at);
  }
  return word;
}

std::uint64_t low_bits(unsigned width) {
  return width >= word_bits ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
}

/// @param width up to 64.
std::uint64_t bits_at(std::string_view bytes, std::size_t bit, unsigned width) {
  const std::size_t at = bit / bits_per_byte;
  const unsigned shift = static_cast<unsigned>(bit % bits_per_byte);
  std::uint64_t value = word_at(bytes, at) >> shift;
  if (shift + width > word_bits) {
    value |= word_at(bytes, at + sizeof value) << (word_bits - shift);
  }
  return value & low_bits(width);
}

/// @param bytes what it takes is taken off.
std::uint64_t take_varint(std::string_view& bytes) {
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift < word_bits; shift += 7) {
    if (bytes.empty()) refuse_short_page();
    const auto next = static_cast<std::uint8_t>(bytes.front());
    bytes.remove_prefix(1);
    value |= static_cast<std::uint64_t>(next & 0x7FU) << shift;
    if ((next & 0x80U) == 0) return value;
  }
  throw UnreadableParquet("damaged: a number of a page has more than 64 bits");
}

std::string_view take_bytes(std::string_view& bytes, std::uint64_t count) {
  if (count > bytes.size()) refuse_short_page();
  const std::string_view taken = bytes.substr(0, static_cast<std::size_t>(count));
  bytes.remove_prefix(taken.size());
  return taken;
}

std::uint64_t from_zigzag(std::uint64_t number) { return (number >> 1U) ^ (~(number & 1U) + 1U); }

}  // namespace

void refuse_short_page() { throw UnreadableParquet("damaged: a page ends before its values do"); }

unsigned bits_of(std::uint32_t most) { return static_cast<unsigned>(std::bit_width(most)); }

RunReader::RunReader(std::string_view bytes, unsigned width) : bytes_(bytes), width_(width) {
  if (width > most_run_bits) {
    throw UnreadableParquet("damaged: numbers of a page are packed in more than 32 bits");
  }
}

void RunReader::start_run() {
  const std::uint64_t head = take_varint(bytes_);
  const std::uint64_t length = head >> 1U;
  is_packed_ = (head & 1U) != 0;
  if (length == 0) throw UnreadableParquet("damaged: a page has a run without values");
  if (!is_packed_) {
    left_ = static_cast<std::size_t>(length);
    const unsigned bytes = (width_ + bits_per_byte - 1) / bits_per_byte;
    number_ = static_cast<std::uint32_t>(word_at(take_bytes(bytes_, bytes), 0));
    return;
  }
  // Groups of eight; the last one's bytes may be cut where its values are not needed.
  const std::uint64_t groups = std::min<std::uint64_t>(length, std::uint64_t{1} << 32);
  left_ = static_cast<std::size_t>(groups * bits_per_byte);
  packed_ = take_bytes(bytes_, std::min<std::uint64_t>(groups * width_, bytes_.size()));
  if (width_ > 0) left_ = std::min(left_, packed_.size() * bits_per_byte / width_);
  if (left_ == 0) refuse_short_page();
  bit_ = 0;
}

namespace {

constexpr std::size_t group = 8;

/// Eight numbers of a known width, which a compiler makes eight shifts of.
/// @param bytes so many as the numbers have, and eight more.
template <unsigned width>
void unpack_group(const char* bytes, std::uint32_t* to) {
  for (unsigned k = 0; k < group; ++k) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes + k * width / bits_per_byte, sizeof word);
    to[k] = static_cast<std::uint32_t>(word >> (k * width % bits_per_byte)) &
            static_cast<std::uint32_t>((std::uint64_t{1} << width) - 1);
  }
}

using UnpackGroup = void (*)(const char*, std::uint32_t*);

template <unsigned... widths>
constexpr std::array<UnpackGroup, sizeof...(widths)> unpackers(
    std::integer_sequence<unsigned, widths...>) {
  return {&unpack_group<widths>...};
}

constexpr auto unpack_by_width =
    unpackers(std::make_integer_sequence<unsigned, most_run_bits + 1>());

}  // namespace

void RunReader::unpack(std::uint32_t* to, std::size_t count) {
  std::size_t i = 0;
  for (; i < count; ++i, bit_ += width_) {
    const std::size_t at = bit_ / bits_per_byte;
    const bool is_group = bit_ % bits_per_byte == 0 && count - i >= group &&
                          at + width_ + sizeof(std::uint64_t) <= packed_.size();
    if (is_group) {
      unpack_by_width[width_](packed_.data() + at, to + i);
      i += group - 1;
      bit_ += (group - 1) * width_;
    } else {
      to[i] = static_cast<std::uint32_t>(bits_at(packed_, bit_, width_));
    }
  }
}

void RunReader::read(std::uint32_t* to, std::size_t count) {
  while (count > 0) {
    if (left_ == 0) start_run();
    const std::size_t now = std::min(left_, count);
    if (is_packed_) {
      unpack(to, now);
    } else {
      std::fill_n(to, now, number_);
    }
    to += now;
    count -= now;
    left_ -= now;
  }
}

bool RunReader::skip_run_of(std::uint32_t number, std::size_t count) {
  if (count == 0) return true;
  if (left_ == 0) start_run();
  if (is_packed_ || number_ != number || left_ < count) return false;
  left_ -= count;
  return true;
}

void read_bit_packed(std::string_view bytes, unsigned width, std::uint32_t* to, std::size_t count) {
  if (width > 0 && count > bytes.size() * bits_per_byte / width) refuse_short_page();
  std::size_t bit = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t value = 0;
    for (unsigned k = 0; k < width; ++k, ++bit) {
      const auto byte = static_cast<std::uint8_t>(bytes[bit / bits_per_byte]);
      value = (value << 1U) | ((byte >> (bits_per_byte - 1 - bit % bits_per_byte)) & 1U);
    }
    to[i] = value;
  }
}

namespace {

struct DeltaHead {
  std::size_t miniblocks{};
  std::size_t per_miniblock{};
};

DeltaHead take_delta_head(std::string_view& bytes) {
  constexpr std::uint64_t largest_block = std::uint64_t{1} << 24;
  constexpr std::uint64_t most_miniblocks = std::uint64_t{1} << 16;
  const std::uint64_t block = take_varint(bytes);
  const std::uint64_t miniblocks = take_varint(bytes);
  const bool can_be = block > 0 && block <= largest_block && miniblocks > 0 &&
                      miniblocks <= most_miniblocks && block % miniblocks == 0 &&
                      block / miniblocks % bits_per_byte == 0;
  if (!can_be) throw UnreadableParquet("damaged: a page of differences has impossible blocks");
  return {static_cast<std::size_t>(miniblocks), static_cast<std::size_t>(block / miniblocks)};
}

/// Adds differences until there are `count` values, or the miniblock ends.
void add_miniblock(std::string_view packed, unsigned width, std::uint64_t least, std::size_t count,
                   std::vector<std::int64_t>& values) {
  auto value = static_cast<std::uint64_t>(values.back());
  std::size_t bit = 0;
  for (std::size_t i = 0; i < count; ++i, bit += width) {
    value += least + bits_at(packed, bit, width);
    values.push_back(static_cast<std::int64_t>(value));
  }
}

}  // namespace

std::vector<std::int64_t> read_deltas(std::string_view bytes, std::size_t count,
                                      std::size_t& used) {
  const std::size_t all = bytes.size();
  const DeltaHead head = take_delta_head(bytes);
  if (take_varint(bytes) != count) {
    throw UnreadableParquet("damaged: a page of differences has another number of values");
  }
  std::vector<std::int64_t> values;
  const std::uint64_t first = from_zigzag(take_varint(bytes));
  if (count > 0) values.push_back(static_cast<std::int64_t>(first));
  while (values.size() < count) {
    const std::uint64_t least = from_zigzag(take_varint(bytes));
    const std::string_view widths = take_bytes(bytes, head.miniblocks);
    for (std::size_t k = 0; k < head.miniblocks && values.size() < count; ++k) {
      const auto width = static_cast<std::uint8_t>(widths[k]);
      if (width > word_bits) throw UnreadableParquet("damaged: differences of more than 64 bits");
      const std::size_t now = std::min(head.per_miniblock, count - values.size());
      // The last one may be cut where its values are not needed.
      const std::size_t least_bytes = (now * width + bits_per_byte - 1) / bits_per_byte;
      const std::size_t whole = head.per_miniblock / bits_per_byte * width;
      if (least_bytes > bytes.size()) refuse_short_page();
      add_miniblock(take_bytes(bytes, std::min(whole, bytes.size())), width, least, now, values);
    }
  }
  used = all - bytes.size();
  return values;
}

}  // namespace tribolog::ingest::parquet
