#include "ingest/bags/cdr_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include <fmt/format.h>

namespace tribolog::ingest::bags {
namespace {

constexpr std::size_t encapsulation_bytes = 4;

bool is_little_endian(std::string_view message) {
  if (message.size() < encapsulation_bytes) {
    throw MessageError(fmt::format("has {} bytes, too few for CDR", message.size()));
  }
  const auto first = static_cast<unsigned char>(message[0]);
  const auto second = static_cast<unsigned char>(message[1]);
  if (first != 0 || second > 1) {
    throw MessageError(fmt::format(
        "starts with 0x{:02x}{:02x}, not with 0x0000 or 0x0001 of plain CDR", first, second));
  }
  return second == 1;
}

}  // namespace

std::size_t size_of(Primitive kind) {
  constexpr std::array<std::size_t, 11> sizes = {1, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes.at(static_cast<std::size_t>(kind));
}

CdrReader::CdrReader(std::string_view message, Serialization how)
    : before_body_(how == Serialization::cdr ? encapsulation_bytes : 0),
      aligns_(how == Serialization::cdr) {
  const bool is_little = how == Serialization::ros1 || is_little_endian(message);
  swaps_ = is_little != (std::endian::native == std::endian::little);
  body_ = message.substr(before_body_);
}

std::size_t CdrReader::byte() const { return before_body_ + at_; }

std::string_view CdrReader::take(std::size_t bytes) {
  if (bytes > bytes_left()) {
    throw MessageError(fmt::format("ends too early: {} bytes wanted at its byte {}, {} left", bytes,
                                   byte(), bytes_left()));
  }
  const std::string_view taken = body_.substr(at_, bytes);
  at_ += bytes;
  return taken;
}

void CdrReader::align(std::size_t size) {
  if (aligns_) (void)take((size - at_ % size) % size);
}

template <class T>
T CdrReader::raw() {
  align(sizeof(T));
  std::array<char, sizeof(T)> bytes{};
  std::memcpy(bytes.data(), take(sizeof(T)).data(), sizeof(T));
  if (swaps_) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<T>(bytes);
}

double CdrReader::number(Primitive kind) {
  switch (kind) {
    case Primitive::boolean:
      return raw<std::uint8_t>() != 0 ? 1 : 0;
    case Primitive::int8:
      return raw<std::int8_t>();
    case Primitive::uint8:
      return raw<std::uint8_t>();
    case Primitive::int16:
      return raw<std::int16_t>();
    case Primitive::uint16:
      return raw<std::uint16_t>();
    case Primitive::int32:
      return raw<std::int32_t>();
    case Primitive::uint32:
      return raw<std::uint32_t>();
    case Primitive::int64:
      return static_cast<double>(raw<std::int64_t>());
    case Primitive::uint64:
      return static_cast<double>(raw<std::uint64_t>());
    case Primitive::float32:
      return raw<float>();
    case Primitive::float64:
      break;
  }
  return raw<double>();
}

std::int32_t CdrReader::int32() { return raw<std::int32_t>(); }

std::uint32_t CdrReader::uint32() { return raw<std::uint32_t>(); }

std::string_view CdrReader::string() {
  std::string_view text = take(uint32());
  if (aligns_ && text.ends_with('\0')) text.remove_suffix(1);
  return text;
}

std::size_t CdrReader::sequence_length() {
  const std::uint32_t length = uint32();
  if (length > bytes_left()) {
    throw MessageError(
        fmt::format("states {} elements before its byte {}, but only {} bytes are left", length,
                    byte(), bytes_left()));
  }
  return length;
}

void CdrReader::skip(Primitive kind, std::size_t count) {
  if (count == 0) return;
  align(size_of(kind));
  if (count > bytes_left()) (void)take(count);
  (void)take(count * size_of(kind));
}

}  // namespace tribolog::ingest::bags
