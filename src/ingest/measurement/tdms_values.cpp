#include "ingest/measurement/tdms_values.h"

#include <cmath>

#include "ingest/arrays/byte_order.h"

namespace tribolog::ingest::measurement {
namespace {

template <class Number>
double number_of_bytes(const char* bytes, bool is_big_endian) {
  return static_cast<double>(arrays::number_at<Number>({bytes, sizeof(Number)}, 0, is_big_endian));
}

}  // namespace

double tdms_number(TdmsType type, const char* bytes, bool is_big_endian) {
  switch (type) {
    case TdmsType::int8:
      return number_of_bytes<std::int8_t>(bytes, is_big_endian);
    case TdmsType::int16:
      return number_of_bytes<std::int16_t>(bytes, is_big_endian);
    case TdmsType::int32:
      return number_of_bytes<std::int32_t>(bytes, is_big_endian);
    case TdmsType::int64:
      return number_of_bytes<std::int64_t>(bytes, is_big_endian);
    case TdmsType::uint8:
      return number_of_bytes<std::uint8_t>(bytes, is_big_endian);
    case TdmsType::uint16:
      return number_of_bytes<std::uint16_t>(bytes, is_big_endian);
    case TdmsType::uint32:
      return number_of_bytes<std::uint32_t>(bytes, is_big_endian);
    case TdmsType::uint64:
      return number_of_bytes<std::uint64_t>(bytes, is_big_endian);
    case TdmsType::float32:
    case TdmsType::float32_with_unit:
      return number_of_bytes<float>(bytes, is_big_endian);
    case TdmsType::float64:
    case TdmsType::float64_with_unit:
      return number_of_bytes<double>(bytes, is_big_endian);
    case TdmsType::boolean:
      return *bytes != 0 ? 1 : 0;
    default:
      return NAN;
  }
}

TdmsTime tdms_time(const char* bytes, bool is_big_endian) {
  const std::string_view both(bytes, 16);
  return {arrays::number_at<std::int64_t>(both, is_big_endian ? 0 : 8, is_big_endian),
          arrays::number_at<std::uint64_t>(both, is_big_endian ? 8 : 0, is_big_endian)};
}

double seconds_between(const TdmsTime& from, const TdmsTime& to) {
  constexpr int fraction_bits = 64;
  // Two's complement: right wherever the difference fits.
  const auto seconds = static_cast<std::int64_t>(static_cast<std::uint64_t>(to.seconds) -
                                                 static_cast<std::uint64_t>(from.seconds));
  const bool is_behind = to.fraction >= from.fraction;
  const std::uint64_t apart = is_behind ? to.fraction - from.fraction : from.fraction - to.fraction;
  const double fraction = std::ldexp(static_cast<double>(apart), -fraction_bits);
  return static_cast<double>(seconds) + (is_behind ? fraction : -fraction);
}

}  // namespace tribolog::ingest::measurement
