#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/byte_order.h"
#include "ingest/measurement/mdf_channels.h"

namespace tribolog::ingest::measurement {
namespace {

using arrays::number_at;

/// The bits of a field of any width, in at most 9 bytes, one byte at a time.
std::uint64_t gathered_bits(const char* bytes, const MdfField& field) {
  const std::size_t count = field.bytes();
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t place = field.is_big_endian ? count - 1 - i : i;
    const std::uint64_t byte = static_cast<unsigned char>(bytes[place]);
    if (i < 8) low |= byte << (8 * i);
    if (i == 8) high = byte;
  }
  std::uint64_t bits = low >> field.bit;
  if (high != 0 && field.bit > 0) bits |= high << (64U - field.bit);
  if (field.bits < 64) bits &= (std::uint64_t{1} << field.bits) - 1;
  return bits;
}

/// The bits of a field as an integer.
std::uint64_t bits_at(const char* bytes, const MdfField& field) {
  const std::string_view all(bytes, field.bytes());
  // Most stand in whole numbers.
  if (field.bits == 64 && field.bit == 0) {
    return number_at<std::uint64_t>(all, 0, field.is_big_endian);
  }
  if (field.bits == 32 && field.bit == 0) {
    return number_at<std::uint32_t>(all, 0, field.is_big_endian);
  }
  if (field.bits == 16 && field.bit == 0) {
    return number_at<std::uint16_t>(all, 0, field.is_big_endian);
  }
  return gathered_bits(bytes, field);
}

std::int64_t with_sign(std::uint64_t bits, std::uint32_t width) {
  const std::uint64_t sign = std::uint64_t{1} << (width - 1);
  return static_cast<std::int64_t>((bits ^ sign) - sign);
}

/// IEEE 754 binary16.
double half(std::uint64_t bits) {
  const auto exponent = static_cast<int>((bits >> 10U) & 0x1fU);
  const auto fraction = static_cast<double>(bits & 0x3ffU);
  double value = 0;
  if (exponent == 31) {
    value = fraction == 0 ? std::numeric_limits<double>::infinity() : NAN;
  } else {
    value = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(fraction + 1024, exponent - 25);
  }
  return (bits & 0x8000U) != 0 ? -value : value;
}

double real_of(std::uint64_t bits, std::uint32_t width) {
  if (width == 64) return std::bit_cast<double>(bits);
  if (width == 32) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
  return half(bits);
}

class RawValues {
 public:
  explicit RawValues(const MdfField& field) : field_(field) {}

  double at(const char* record) {
    const std::uint64_t bits = bits_at(record + field_.byte, field_);
    if (field_.number == MdfNumber::real) return real_of(bits, field_.bits);
    const double value = field_.number == MdfNumber::signed_integer
                             ? static_cast<double>(with_sign(bits, field_.bits))
                             : static_cast<double>(bits);
    was_rounded_ = was_rounded_ || std::abs(value) >= arrays::first_rounded_integer;
    return value;
  }
  [[nodiscard]] bool was_rounded() const { return was_rounded_; }

 private:
  MdfField field_;
  bool was_rounded_{};
};

bool is_invalid(const char* record, std::size_t data_bytes, const MdfField& field) {
  if (!field.may_be_invalid) return false;
  const auto byte = static_cast<unsigned char>(record[data_bytes + field.invalid / 8]);
  return ((byte >> (field.invalid % 8)) & 1U) != 0;
}

}  // namespace

std::vector<double> values_of(const MdfChannel& channel, std::string_view records,
                              std::size_t stride, std::size_t data_bytes, bool& was_rounded) {
  std::vector<double> values(records.size() / stride);
  const MdfConversion* const conversion = channel.conversion.conversion.get();
  const bool is_integer = !channel.field || channel.field->number != MdfNumber::real;
  RawValues raw(channel.field.value_or(MdfField{}));
  for (std::size_t row = 0; row < values.size(); ++row) {
    const char* const record = records.data() + row * stride;
    if (channel.field && is_invalid(record, data_bytes, *channel.field)) {
      values[row] = std::numeric_limits<double>::quiet_NaN();
      continue;
    }
    const double value = channel.field ? raw.at(record) : static_cast<double>(row);
    values[row] = conversion != nullptr ? conversion->value(value, is_integer) : value;
  }
  was_rounded = was_rounded || raw.was_rounded();
  return values;
}

}  // namespace tribolog::ingest::measurement
