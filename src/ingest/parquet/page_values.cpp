#include "ingest/parquet/page_values.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <type_traits>

#include "ingest/parquet/compact_protocol.h"
#include "ingest/parquet/level_runs.h"

namespace tribolog::ingest::parquet {
namespace {

[[noreturn]] void refuse_encoding() {
  throw UnreadableParquet("damaged: a column is in an encoding that its type does not have");
}

/// @return its length, taken off with what follows it.
std::string_view take_counted(std::string_view& bytes) {
  std::uint32_t length = 0;
  if (bytes.size() < sizeof length) refuse_short_page();
  std::memcpy(&length, bytes.data(), sizeof length);
  bytes.remove_prefix(sizeof length);
  if (length > bytes.size()) refuse_short_page();
  const std::string_view taken = bytes.substr(0, length);
  bytes.remove_prefix(length);
  return taken;
}

/// Values that stand one behind the other. @param bytes long enough.
template <class Stored, class Number>
void append(std::string_view bytes, std::size_t count, std::vector<Number>& to) {
  const std::size_t before = to.size();
  to.resize(before + count);
  Number* next = to.data() + before;
  if constexpr (std::is_same_v<Stored, Number>) {
    if (count > 0) std::memcpy(next, bytes.data(), count * sizeof(Number));
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    Stored stored;
    std::memcpy(&stored, bytes.data() + i * sizeof stored, sizeof stored);
    next[i] = static_cast<Number>(stored);
  }
}

void append_booleans(std::string_view bytes, std::size_t count, std::vector<double>& to) {
  if (bytes.size() < (count + bits_per_byte - 1) / bits_per_byte) refuse_short_page();
  for (std::size_t i = 0; i < count; ++i) {
    const auto byte = static_cast<std::uint8_t>(bytes[i / bits_per_byte]);
    to.push_back((byte >> (i % bits_per_byte)) & 1U);
  }
}

/// Nanoseconds of the day and the Julian day, as Impala and Spark write a time.
/// @throw UnreadableParquet: a time that 64 bits of nanoseconds do not hold.
std::int64_t from_int96(std::string_view bytes) {
  constexpr std::int64_t julian_day_of_1970 = 2'440'588;
  constexpr std::int64_t day_ns = 86'400'000'000'000;
  constexpr std::int64_t most_days = std::numeric_limits<std::int64_t>::max() / day_ns - 1;
  std::int64_t of_day = 0;
  std::uint32_t julian_day = 0;
  std::memcpy(&of_day, bytes.data(), sizeof of_day);
  std::memcpy(&julian_day, bytes.data() + sizeof of_day, sizeof julian_day);
  const std::int64_t day = static_cast<std::int64_t>(julian_day) - julian_day_of_1970;
  if (std::abs(day) > most_days || of_day < 0 || of_day > day_ns) {
    throw UnreadableParquet("a column of INT96 holds a time that is not within 1678 to 2261");
  }
  return day * day_ns + of_day;
}

void append_int96(std::string_view bytes, std::size_t count, std::vector<std::int64_t>& to) {
  constexpr std::size_t width = 12;
  for (std::size_t i = 0; i < count; ++i) to.push_back(from_int96(bytes.substr(i * width, width)));
}

/// A two's complement from its highest byte on.
double from_big_endian(std::string_view bytes) {
  constexpr double byte_values = 256;
  if (bytes.empty()) return 0;
  const bool is_negative = (static_cast<std::uint8_t>(bytes.front()) & 0x80U) != 0;
  long double number = 0;  // its magnitude less one where it is negative: the bits turned over
  for (const char c : bytes) {
    const auto byte = static_cast<std::uint8_t>(c);
    number = number * byte_values + (is_negative ? 0xFF - byte : byte);
  }
  return static_cast<double>(is_negative ? -number - 1 : number);
}

}  // namespace

double from_real16(std::uint16_t bits) {
  constexpr unsigned mantissa_bits = 10;
  constexpr int bias = 15;
  constexpr unsigned special = 31;
  const unsigned exponent = (bits >> mantissa_bits) & special;
  const unsigned mantissa = bits & 0x3FFU;
  const double sign = (bits & 0x8000U) != 0 ? -1 : 1;
  if (exponent == special) {
    return mantissa != 0 ? std::numeric_limits<double>::quiet_NaN()
                         : sign * std::numeric_limits<double>::infinity();
  }
  const double whole = exponent == 0 ? mantissa : mantissa + (1U << mantissa_bits);
  const int power =
      static_cast<int>(std::max(exponent, 1U)) - bias - static_cast<int>(mantissa_bits);
  return sign * std::ldexp(whole, power);
}

std::size_t ValueDecoder::fixed_width() const {
  constexpr std::size_t int96_bytes = 12;
  switch (column_.type) {
    case PhysicalType::int32:
    case PhysicalType::real32:
      return sizeof(float);
    case PhysicalType::int64:
    case PhysicalType::real64:
      return sizeof(double);
    case PhysicalType::int96:
      return int96_bytes;
    case PhysicalType::fixed_bytes:
      return static_cast<std::size_t>(column_.type_bytes);
    case PhysicalType::boolean:
    case PhysicalType::bytes:
      break;
  }
  refuse_encoding();
}

double ValueDecoder::number_in(std::string_view bytes) {
  if (column_.logical == LogicalType::text) return texts_.number_of(bytes);
  if (column_.logical == LogicalType::decimal) return from_big_endian(bytes);
  std::uint16_t bits = 0;
  std::memcpy(&bits, bytes.data(), std::min(sizeof bits, bytes.size()));
  return from_real16(bits);
}

void ValueDecoder::plain_bytes(std::string_view bytes, std::size_t count, Numbers& to) {
  for (std::size_t i = 0; i < count; ++i) to.reals.push_back(number_in(take_counted(bytes)));
}

void ValueDecoder::plain_fixed_bytes(std::string_view bytes, std::size_t count, Numbers& to) {
  const std::size_t width = fixed_width();
  for (std::size_t i = 0; i < count; ++i) {
    to.reals.push_back(number_in(bytes.substr(i * width, width)));
  }
}

void ValueDecoder::plain(std::string_view bytes, std::size_t count, Numbers& to) {
  if (column_.type == PhysicalType::boolean) return append_booleans(bytes, count, to.reals);
  if (column_.type == PhysicalType::bytes) return plain_bytes(bytes, count, to);
  if (count > bytes.size() / fixed_width()) refuse_short_page();
  const bool is_unsigned = column_.logical == LogicalType::unsigned_integer;
  switch (column_.type) {
    case PhysicalType::int32:
      return is_unsigned ? append<std::uint32_t>(bytes, count, to.reals)
                         : append<std::int32_t>(bytes, count, to.reals);
    case PhysicalType::int64:
      return append<std::int64_t>(bytes, count, to.integers);
    case PhysicalType::int96:
      return append_int96(bytes, count, to.integers);
    case PhysicalType::real32:
      return append<float>(bytes, count, to.reals);
    case PhysicalType::real64:
      return append<double>(bytes, count, to.reals);
    default:
      return plain_fixed_bytes(bytes, count, to);
  }
}

void ValueDecoder::set_dictionary(const PageHeader& page, std::string_view bytes) {
  if (page.encoding != Encoding::plain && page.encoding != Encoding::plain_dictionary) {
    throw UnreadableParquet("damaged: a dictionary is in an encoding that it cannot have");
  }
  dictionary_ = {};
  plain(bytes, page.values, dictionary_);
  has_dictionary_ = true;
}

namespace {

/// @throw UnreadableParquet: a place behind its end.
template <class Number>
void look_up(const std::vector<std::uint32_t>& places, const std::vector<Number>& dictionary,
             std::vector<Number>& to) {
  std::uint32_t last = 0;
  for (const std::uint32_t place : places) last = std::max(last, place);
  if (!places.empty() && last >= dictionary.size()) {
    throw UnreadableParquet("damaged: a page names a place that its dictionary does not have");
  }
  const std::size_t before = to.size();
  to.resize(before + places.size());
  Number* next = to.data() + before;
  for (std::size_t i = 0; i < places.size(); ++i) next[i] = dictionary[places[i]];
}

}  // namespace

void ValueDecoder::places(std::string_view bytes, std::size_t count, Numbers& to) {
  if (!has_dictionary_) throw UnreadableParquet("damaged: a column's dictionary is missing");
  places_.resize(count);
  if (count > 0) {
    if (bytes.empty()) refuse_short_page();
    const auto width = static_cast<std::uint8_t>(bytes.front());
    RunReader(bytes.substr(1), width).read(places_.data(), count);
  }
  if (column_.storage == Storage::integer)
    return look_up(places_, dictionary_.integers, to.integers);
  look_up(places_, dictionary_.reals, to.reals);
}

void ValueDecoder::deltas(std::string_view bytes, std::size_t count, Numbers& to) {
  std::size_t used = 0;
  const std::vector<std::int64_t> values = read_deltas(bytes, count, used);
  if (column_.type == PhysicalType::int64) {
    to.integers.insert(to.integers.end(), values.begin(), values.end());
    return;
  }
  if (column_.type != PhysicalType::int32) refuse_encoding();
  const bool is_unsigned = column_.logical == LogicalType::unsigned_integer;
  for (const std::int64_t value : values) {
    const auto bits = static_cast<std::uint32_t>(value);
    to.reals.push_back(is_unsigned ? bits : static_cast<double>(static_cast<std::int32_t>(bits)));
  }
}

namespace {

std::size_t as_length(std::int64_t length, std::size_t most) {
  if (length < 0 || static_cast<std::uint64_t>(length) > most) refuse_short_page();
  return static_cast<std::size_t>(length);
}

}  // namespace

void ValueDecoder::delta_lengths(std::string_view bytes, std::size_t count, Numbers& to) {
  if (column_.type != PhysicalType::bytes) refuse_encoding();
  std::size_t used = 0;
  const std::vector<std::int64_t> lengths = read_deltas(bytes, count, used);
  bytes.remove_prefix(used);
  for (const std::int64_t stated : lengths) {
    const std::size_t length = as_length(stated, bytes.size());
    to.reals.push_back(number_in(bytes.substr(0, length)));
    bytes.remove_prefix(length);
  }
}

/// Each text begins as the one before it does, so far as is stated.
void ValueDecoder::delta_bytes(std::string_view bytes, std::size_t count, Numbers& to) {
  constexpr std::size_t longest_text = std::size_t{1} << 20;
  const bool is_fixed = column_.type == PhysicalType::fixed_bytes;
  if (column_.type != PhysicalType::bytes && !is_fixed) refuse_encoding();
  std::size_t used = 0;
  const std::vector<std::int64_t> kept = read_deltas(bytes, count, used);
  bytes.remove_prefix(used);
  const std::vector<std::int64_t> lengths = read_deltas(bytes, count, used);
  bytes.remove_prefix(used);
  std::string value;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t length = as_length(lengths[i], bytes.size());
    value.resize(as_length(kept[i], value.size()));
    value += bytes.substr(0, length);
    bytes.remove_prefix(length);
    const bool can_be = is_fixed ? value.size() == fixed_width() : value.size() <= longest_text;
    if (!can_be) throw UnreadableParquet("damaged: a text of a page has an impossible length");
    to.reals.push_back(number_in(value));
  }
}

/// The first bytes of all values, then the second ones, and so on.
void ValueDecoder::byte_streams(std::string_view bytes, std::size_t count, Numbers& to) {
  const std::size_t width = fixed_width();
  if (count > bytes.size() / width) refuse_short_page();
  std::string together(count * width, '\0');
  for (std::size_t k = 0; k < width; ++k) {
    const char* stream = bytes.data() + k * count;
    for (std::size_t i = 0; i < count; ++i) together[i * width + k] = stream[i];
  }
  plain(together, count, to);
}

void ValueDecoder::decode(Encoding encoding, std::string_view bytes, std::size_t count,
                          Numbers& to) {
  switch (encoding) {
    case Encoding::plain:
      return plain(bytes, count, to);
    case Encoding::plain_dictionary:
    case Encoding::dictionary:
      return places(bytes, count, to);
    case Encoding::runs:
      if (column_.type != PhysicalType::boolean) refuse_encoding();
      places_.resize(count);
      RunReader(take_counted(bytes), 1).read(places_.data(), count);
      to.reals.insert(to.reals.end(), places_.begin(), places_.end());
      return;
    case Encoding::bit_packed:
      refuse_encoding();
    case Encoding::delta:
      return deltas(bytes, count, to);
    case Encoding::delta_length:
      return delta_lengths(bytes, count, to);
    case Encoding::delta_bytes:
      return delta_bytes(bytes, count, to);
    case Encoding::byte_streams:
      return byte_streams(bytes, count, to);
  }
}

}  // namespace tribolog::ingest::parquet
