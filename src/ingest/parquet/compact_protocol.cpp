#include "ingest/parquet/compact_protocol.h"

#include <limits>

#include <fmt/format.h>

namespace tribolog::ingest::parquet {
namespace {

constexpr int deepest = 32;

[[noreturn]] void refuse_type() {
  throw UnreadableParquet("damaged: a field of the metadata is of another type than it has to be");
}

[[noreturn]] void refuse_cut_metadata() {
  throw UnreadableParquet("damaged: the metadata end inside of a field");
}

ThriftType type_of(unsigned number) {
  if (number > static_cast<unsigned>(ThriftType::structure)) {
    throw UnreadableParquet("damaged: the metadata have a field of an unknown type");
  }
  return static_cast<ThriftType>(number);
}

}  // namespace

std::uint8_t CompactReader::byte() {
  if (at_ >= bytes_.size()) refuse_cut_metadata();
  return static_cast<std::uint8_t>(bytes_[at_++]);
}

std::uint64_t CompactReader::varint() {
  constexpr unsigned most_bits = 64;
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift < most_bits; shift += 7) {
    const std::uint8_t next = byte();
    value |= static_cast<std::uint64_t>(next & 0x7FU) << shift;
    if ((next & 0x80U) == 0) return value;
  }
  throw UnreadableParquet("damaged: a number of the metadata has more than 64 bits");
}

void CompactReader::pass(std::uint64_t bytes) {
  if (bytes > bytes_.size() - at_) refuse_cut_metadata();
  at_ += static_cast<std::size_t>(bytes);
}

std::optional<ThriftField> CompactReader::next_field(std::int32_t& last_id) {
  const std::uint8_t head = byte();
  const ThriftType type = type_of(head & 0x0FU);
  if (type == ThriftType::stop) return std::nullopt;
  const unsigned step = head >> 4U;
  const std::int64_t id =
      step != 0 ? last_id + static_cast<std::int64_t>(step) : integer(ThriftType::i16);
  if (id < 0 || id > std::numeric_limits<std::int16_t>::max()) {
    throw UnreadableParquet("damaged: the metadata have a field with an impossible number");
  }
  last_id = static_cast<std::int32_t>(id);
  return ThriftField{last_id, type};
}

std::int64_t CompactReader::integer(ThriftType type) {
  if (type == ThriftType::byte) return static_cast<std::int8_t>(byte());
  if (type < ThriftType::i16 || type > ThriftType::i64) refuse_type();
  const std::uint64_t zigzag = varint();
  return static_cast<std::int64_t>((zigzag >> 1U) ^ (~(zigzag & 1U) + 1U));
}

std::int64_t CompactReader::count(ThriftType type, std::int64_t most, const char* what) {
  const std::int64_t value = integer(type);
  if (value < 0 || value > most) {
    throw UnreadableParquet(fmt::format("damaged: {} of {} cannot be", what, value));
  }
  return value;
}

std::string_view CompactReader::text(ThriftType type) {
  if (type != ThriftType::binary) refuse_type();
  const std::uint64_t length = varint();
  const std::size_t begin = at_;
  pass(length);
  return bytes_.substr(begin, static_cast<std::size_t>(length));
}

bool CompactReader::boolean(ThriftType type) {
  if (type != ThriftType::yes && type != ThriftType::no) refuse_type();
  return type == ThriftType::yes;
}

ThriftList CompactReader::list(ThriftType type) {
  if (type != ThriftType::list && type != ThriftType::set) refuse_type();
  constexpr unsigned size_follows = 15;
  const std::uint8_t head = byte();
  const std::uint64_t size = (head >> 4U) == size_follows ? varint() : head >> 4U;
  // Each element takes a byte at least.
  if (size > bytes_.size() - at_) refuse_cut_metadata();
  return {static_cast<std::size_t>(size), type_of(head & 0x0FU)};
}

void CompactReader::skip(ThriftType type, int depth) {
  if (depth > deepest) throw UnreadableParquet("damaged: the metadata are nested too deeply");
  switch (type) {
    case ThriftType::stop:
    case ThriftType::yes:
    case ThriftType::no:
      return;
    case ThriftType::byte:
      return pass(1);
    case ThriftType::i16:
    case ThriftType::i32:
    case ThriftType::i64:
      return static_cast<void>(varint());
    case ThriftType::real:
      return pass(sizeof(double));
    case ThriftType::binary:
      return static_cast<void>(text(type));
    case ThriftType::list:
    case ThriftType::set: {
      const ThriftList elements = list(type);
      return skip_elements(elements.size, elements.type, depth);
    }
    case ThriftType::map:
      return skip_map(depth);
    case ThriftType::structure:
      std::int32_t last_id = 0;
      while (const auto field = next_field(last_id)) skip(field->type, depth + 1);
      return;
  }
}

void CompactReader::skip_elements(std::uint64_t size, ThriftType type, int depth) {
  for (std::uint64_t i = 0; i < size; ++i) {
    // Outside of a structure a boolean is a byte.
    const bool is_boolean = type == ThriftType::yes || type == ThriftType::no;
    skip(is_boolean ? ThriftType::byte : type, depth + 1);
  }
}

void CompactReader::skip_map(int depth) {
  const std::uint64_t size = varint();
  if (size == 0) return;
  if (size > bytes_.size() - at_) refuse_cut_metadata();
  const std::uint8_t types = byte();
  for (std::uint64_t i = 0; i < size; ++i) {
    skip_elements(1, type_of(types >> 4U), depth);
    skip_elements(1, type_of(types & 0x0FU), depth);
  }
}

}  // namespace tribolog::ingest::parquet
