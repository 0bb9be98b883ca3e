#include "ingest/arrays/npy_array.h"

#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "error.h"
#include "ingest/arrays/byte_order.h"
#include "ingest/arrays/npy_header.h"
#include "ingest/closest_match.h"

namespace tribolog {
namespace {

/// "<f8" in parts; "<M8[ns]" with its unit.
struct NumberType {
  bool big_endian{};
  char kind{};
  std::size_t bytes{};
  std::string unit;
};

std::optional<NumberType> number_type(const std::string& type) {
  if (type.size() < 3 || std::string_view("<>|=").find(type[0]) == std::string_view::npos) {
    return std::nullopt;
  }
  const bool big_endian =
      type[0] == '>' || (type[0] == '=' && std::endian::native == std::endian::big);
  NumberType result{big_endian, type[1], 0, ""};
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

std::string why_left_out(const std::string& type) {
  if (type.empty()) return "it holds records of several fields";
  const char kind = type.size() > 1 ? type[1] : '\0';
  if (kind == 'O') return "it holds Python objects (pickled), which are not read for safety";
  if (kind == 'c') return "it holds complex numbers";
  if (kind == 'U' || kind == 'S' || kind == 'T') return "it holds texts";
  return fmt::format("its type {} is not known", in_quotes(type));
}

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

template <class Number>
void convert(std::string_view bytes, bool big_endian, NamedArray& array) {
  for (std::size_t i = 0; i < array.values.size(); ++i) {
    const auto value = number_at<Number>(bytes, i * sizeof(Number), big_endian);
    array.values[i] = static_cast<double>(value);
    if constexpr (std::is_integral_v<Number> && sizeof(Number) == 8) {
      array.was_rounded = array.was_rounded || std::abs(array.values[i]) >= first_rounded_integer;
    }
  }
}

void convert_times(std::string_view bytes, bool big_endian, NamedArray& array) {
  constexpr auto not_a_time = std::numeric_limits<std::int64_t>::min();
  for (std::size_t i = 0; i < array.values.size(); ++i) {
    const auto count = number_at<std::int64_t>(bytes, i * sizeof(std::int64_t), big_endian);
    const auto value = static_cast<double>(count);
    const bool is_gap = count == not_a_time;
    array.values[i] = is_gap ? std::numeric_limits<double>::quiet_NaN() : value;
    array.was_rounded = array.was_rounded || (!is_gap && std::abs(value) >= first_rounded_integer);
  }
}

void convert_all(const NumberType& type, std::string_view bytes, NamedArray& array) {
  const bool big = type.big_endian;
  switch (type.kind) {
    case 'f':
      if (type.bytes == 8) return convert<double>(bytes, big, array);
      if (type.bytes == 4) return convert<float>(bytes, big, array);
      for (std::size_t i = 0; i < array.values.size(); ++i) {
        array.values[i] = half_precision(number_at<std::uint16_t>(bytes, 2 * i, big));
      }
      return;
    case 'i':
      if (type.bytes == 8) return convert<std::int64_t>(bytes, big, array);
      if (type.bytes == 4) return convert<std::int32_t>(bytes, big, array);
      if (type.bytes == 2) return convert<std::int16_t>(bytes, big, array);
      return convert<std::int8_t>(bytes, big, array);
    case 'M':
    case 'm':
      return convert_times(bytes, big, array);
    default:  // 'u', and 'b' as one byte of 0 or 1
      if (type.bytes == 8) return convert<std::uint64_t>(bytes, big, array);
      if (type.bytes == 4) return convert<std::uint32_t>(bytes, big, array);
      if (type.bytes == 2) return convert<std::uint16_t>(bytes, big, array);
      return convert<std::uint8_t>(bytes, big, array);
  }
}

/// A single text of type S or U, with what is not ASCII as '?'.
std::optional<std::string> single_text(const NpyHeader& header, std::string_view values) {
  if (!header.shape.empty() || header.type.size() < 3) return std::nullopt;
  const char kind = header.type[1];
  if (kind != 'S' && kind != 'U') return std::nullopt;
  const std::size_t step = kind == 'U' ? 4 : 1;
  std::string text;
  for (std::size_t at = 0; at + step <= values.size(); at += step) {
    const std::uint32_t c = kind == 'U'
                                ? number_at<std::uint32_t>(values, at, header.type[0] == '>')
                                : static_cast<unsigned char>(values[at]);
    if (c == 0) break;
    text += c < 128 ? static_cast<char>(c) : '?';
  }
  return text;
}

}  // namespace

void add_npy_array(std::string_view bytes, const std::string& name, const std::string& file,
                   FileArrays& found) {
  const NpyHeader header = read_npy_header(bytes, name, file);
  const std::string_view values = bytes.substr(header.bytes);
  const auto type = number_type(header.type);
  if (!type) {
    if (const auto text = single_text(header, values)) {
      found.texts.emplace_back(name, *text);
    } else {
      found.leave_out(name, why_left_out(header.type));
    }
    return;
  }
  NamedArray array;
  array.name = name;
  array.unit = type->unit;
  array.by_columns = header.fortran_order;
  const std::uint64_t values_before = found.values;
  if (!shape_array(header.shape, array, found)) return;
  const std::uint64_t count = found.values - values_before;
  if (values.size() != count * type->bytes) {
    throw InputError({file, 0, 0}, {"array " + in_quotes(name) + " is damaged or cut off",
                                    fmt::format("{} bytes of values", values.size()),
                                    fmt::format("{}", count * type->bytes), ""});
  }
  array.values.resize(count);
  convert_all(*type, values, array);
  found.arrays.push_back(std::move(array));
}

}  // namespace tribolog
