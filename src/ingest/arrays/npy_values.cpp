#include "ingest/arrays/npy_values.h"

#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

#include "ingest/arrays/byte_order.h"

namespace tribolog {
namespace {

/// IEEE 754 binary16: 1 bit sign, 5 bits exponent, 10 bits fraction.
double half_precision(std::uint16_t bits) {
  const int exponent = (bits >> 10) & 31;
  const int fraction = bits & 1023;
  const double size = exponent == 31  ? (fraction == 0 ? std::numeric_limits<double>::infinity()
                                                       : std::numeric_limits<double>::quiet_NaN())
                      : exponent == 0 ? std::ldexp(fraction, -24)
                                      : std::ldexp(1024 + fraction, exponent - 25);
  return (bits & 0x8000) != 0 ? -size : size;
}

/// Where the values of a field lie: rows x columns of them, at these distances.
struct Places {
  std::string_view bytes;
  std::uint64_t first{};
  NpyDimension rows{1, 0};
  NpyDimension columns{1, 0};

  /// Calls `use` with the offset of each value, columns fastest.
  template <class Use>
  void visit(Use use) const {
    for (std::uint64_t r = 0; r < rows.size; ++r) {
      const std::uint64_t row = first + r * rows.stride;
      for (std::uint64_t c = 0; c < columns.size; ++c) {
        use(static_cast<std::size_t>(row + c * columns.stride));
      }
    }
  }
};

/// Dimensions of length 1 have no places of their own; no more than two others may be there.
Places places_of(std::string_view bytes, std::uint64_t first,
                 const std::vector<NpyDimension>& dimensions) {
  Places places{bytes, first};
  for (const NpyDimension& d : dimensions) {
    if (d.size == 1) continue;
    places.rows = places.columns;
    places.columns = d;
  }
  return places;
}

template <class Number>
void convert(const Places& places, bool big_endian, NamedArray& array) {
  places.visit([&](std::size_t at) {
    const auto value = static_cast<double>(number_at<Number>(places.bytes, at, big_endian));
    array.values.push_back(value);
    if constexpr (std::is_integral_v<Number> && sizeof(Number) == 8) {
      array.was_rounded = array.was_rounded || std::abs(value) >= first_rounded_integer;
    }
  });
}

void convert_halves(const Places& places, bool big_endian, NamedArray& array) {
  places.visit([&](std::size_t at) {
    array.values.push_back(half_precision(number_at<std::uint16_t>(places.bytes, at, big_endian)));
  });
}

void convert_times(const Places& places, bool big_endian, NamedArray& array) {
  constexpr auto not_a_time = std::numeric_limits<std::int64_t>::min();
  places.visit([&](std::size_t at) {
    const auto count = number_at<std::int64_t>(places.bytes, at, big_endian);
    const auto value = static_cast<double>(count);
    const bool is_gap = count == not_a_time;
    array.values.push_back(is_gap ? std::numeric_limits<double>::quiet_NaN() : value);
    array.was_rounded = array.was_rounded || (!is_gap && std::abs(value) >= first_rounded_integer);
  });
}

}  // namespace

std::optional<NpyNumberType> npy_number_type(const std::string& type) {
  if (type.size() < 3 || std::string_view("<>|=").find(type[0]) == std::string_view::npos) {
    return std::nullopt;
  }
  const bool big_endian =
      type[0] == '>' || (type[0] == '=' && std::endian::native == std::endian::big);
  NpyNumberType result{big_endian, type[1], 0, ""};
  const std::string size = type.substr(2);
  for (const char* unit : {"s", "ms", "us", "ns"}) {
    if ((result.kind == 'M' || result.kind == 'm') && size == fmt::format("8[{}]", unit)) {
      result.bytes = 8;
      result.unit = std::string(unit);
      return result;
    }
  }
  const std::string_view sizes = result.kind == 'f'                         ? "248"
                                 : result.kind == 'i' || result.kind == 'u' ? "1248"
                                 : result.kind == 'b'                       ? "1"
                                                                            : "";
  if (size.size() != 1 || sizes.find(size[0]) == std::string_view::npos) return std::nullopt;
  result.bytes = static_cast<std::size_t>(size[0] - '0');
  return result;
}

void append_npy_values(const NpyNumberType& type, std::string_view bytes, std::uint64_t first,
                       const std::vector<NpyDimension>& dimensions, NamedArray& array) {
  const Places places = places_of(bytes, first, dimensions);
  const bool big = type.big_endian;
  switch (type.kind) {
    case 'f':
      if (type.bytes == 8) return convert<double>(places, big, array);
      if (type.bytes == 4) return convert<float>(places, big, array);
      return convert_halves(places, big, array);
    case 'i':
      if (type.bytes == 8) return convert<std::int64_t>(places, big, array);
      if (type.bytes == 4) return convert<std::int32_t>(places, big, array);
      if (type.bytes == 2) return convert<std::int16_t>(places, big, array);
      return convert<std::int8_t>(places, big, array);
    case 'M':
    case 'm':
      return convert_times(places, big, array);
    default:  // 'u', and 'b' as one byte of 0 or 1
      if (type.bytes == 8) return convert<std::uint64_t>(places, big, array);
      if (type.bytes == 4) return convert<std::uint32_t>(places, big, array);
      if (type.bytes == 2) return convert<std::uint16_t>(places, big, array);
      return convert<std::uint8_t>(places, big, array);
  }
}

}  // namespace tribolog
