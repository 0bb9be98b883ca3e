#include "ingest/arrays/npy_array.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "ingest/arrays/byte_order.h"
#include "ingest/arrays/npy_header.h"
#include "ingest/arrays/npy_type.h"
#include "ingest/arrays/npy_values.h"

namespace tribolog {
namespace {

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

}  // namespace tribolog
