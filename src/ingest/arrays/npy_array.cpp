#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/byte_order.h"
#include "ingest/arrays/npy.h"

namespace tribolog::ingest::arrays {

// Numbers and times of a NumPy array, from their places in its bytes to doubles.

namespace {

/// "<f8" in parts; "<M8[ns]" with its unit.
struct NpyNumberType {
  bool big_endian{};
  char kind{};
  std::size_t bytes{};
  std::string unit;
};

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

/// nullopt where it is no type of numbers, booleans or times that is read.
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

/// Appends the values of an array's dimensions, the last one fastest, to `array.values`.
/// @param first offset of the first value; the caller has checked that all lie in `bytes`.
/// @param dimensions of which no more than two are longer than 1.
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

std::string why_left_out(const std::string& type) {
  const char kind = type.size() > 1 ? type[1] : '\0';
  if (kind == 'O') return "it holds Python objects (pickled), which are not read for safety";
  if (kind == 'c') return "it holds complex numbers";
  if (kind == 'U' || kind == 'S' || kind == 'T') return "it holds texts";
  return fmt::format("its type {} is not known", in_quotes(type));
}

/// A text of type S or U, with what is not ASCII as '?'.
std::optional<std::string> text_at(const std::string& type, std::string_view bytes) {
  const char kind = type.size() > 1 ? type[1] : '\0';
  if (kind != 'S' && kind != 'U') return std::nullopt;
  const std::size_t step = kind == 'U' ? 4 : 1;
  std::string text;
  for (std::size_t at = 0; at + step <= bytes.size(); at += step) {
    const std::uint32_t c = kind == 'U' ? number_at<std::uint32_t>(bytes, at, type[0] == '>')
                                        : static_cast<unsigned char>(bytes[at]);
    if (c == 0) break;
    text += c < 128 ? static_cast<char>(c) : '?';
  }
  return text;
}

/// Dimensions of the array as a whole: its own, those of the last field value within it fastest.
std::vector<NpyDimension> dimensions_of(const NpyHeader& header, const NpyField& field) {
  std::vector<NpyDimension> all(header.shape.size());
  std::uint64_t stride = header.type.bytes;
  for (std::size_t k = all.size(); k-- > 0;) {
    all[k] = {header.shape[k], stride};
    stride *= header.shape[k];
  }
  all.insert(all.end(), field.within.begin(), field.within.end());
  return all;
}

class FieldReader {
 public:
  FieldReader(const NpyHeader& header, std::string_view values, FileArrays& found)
      : header_(header), values_(values), found_(found) {}

  void read(const NpyField& field, const std::string& name) {
    const std::vector<NpyDimension> dimensions = dimensions_of(header_, field);
    const auto type = npy_number_type(field.type);
    if (!type) return read_text(field, name, dimensions);
    std::vector<std::uint64_t> shape;
    for (const NpyDimension& d : dimensions) shape.push_back(d.size);
    NamedArray array;
    array.name = name;
    array.unit = type->unit;
    if (!shape_array(shape, array, found_)) return;
    // Fortran's order is that of the elements; what is within one is in C's.
    array.by_columns = header_.fortran_order && field_is_single(field);
    array.values.reserve(array.rows * array.columns);
    append_npy_values(*type, values_, field.offset, dimensions, array);
    found_.arrays.push_back(std::move(array));
  }

 private:
  static bool field_is_single(const NpyField& field) {
    return std::all_of(field.within.begin(), field.within.end(),
                       [](const NpyDimension& d) { return d.size == 1; });
  }

  void read_text(const NpyField& field, const std::string& name,
                 const std::vector<NpyDimension>& dimensions) {
    const auto text =
        dimensions.empty()
            ? text_at(field.type,
                      values_.substr(field.offset, bytes_of_type(field.type).value_or(0)))
            : std::nullopt;
    if (text) {
      found_.texts.emplace_back(name, *text);
    } else {
      found_.leave_out(name, why_left_out(field.type));
    }
  }

  const NpyHeader& header_;
  std::string_view values_;
  FileArrays& found_;
};

/// Bytes of all values; nullopt where no file holds so many.
std::optional<std::uint64_t> bytes_of_values(const NpyHeader& header) {
  std::uint64_t bytes = header.type.bytes;
  for (const std::uint64_t side : header.shape) {
    if (side > 0 && bytes > std::numeric_limits<std::uint64_t>::max() / side) return std::nullopt;
    bytes *= side;
  }
  return bytes;
}

/// The field whose size the header does not tell: then nothing behind it can be found.
const NpyField* field_of_unknown_size(const NpyType& type) {
  const auto field = std::find_if(type.fields.begin(), type.fields.end(), [](const NpyField& f) {
    return !bytes_of_type(f.type).has_value();
  });
  return field == type.fields.end() ? nullptr : &*field;
}

}  // namespace

void add_npy_array(std::string_view bytes, const std::string& name, const std::string& file,
                   RecordNames names, FileArrays& found) {
  const NpyHeader header = read_npy_header(bytes, name, file);
  const std::string_view values = bytes.substr(header.bytes);
  if (const NpyField* unknown = field_of_unknown_size(header.type)) {
    return found.leave_out(name, why_left_out(unknown->type));
  }
  const auto expected = bytes_of_values(header);
  if (!expected || values.size() != *expected) {
    throw InputError({file, 0, 0},
                     {"array " + in_quotes(name) + " is damaged or cut off",
                      fmt::format("{} bytes of values", values.size()),
                      expected ? fmt::format("{}", *expected) : "more than a file can hold", ""});
  }
  if (header.type.fields.empty()) return found.leave_out(name, "its records have no fields");
  const std::string prefix = names == RecordNames::by_field ? "" : name + ".";
  FieldReader reader(header, values, found);
  for (const NpyField& field : header.type.fields) {
    reader.read(field, header.type.is_record ? prefix + field.name : name);
  }
}

}  // namespace tribolog::ingest::arrays
