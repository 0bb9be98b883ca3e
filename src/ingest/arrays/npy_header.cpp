#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/closest_match.h"
#include "base/error.h"
#include "base/utf8.h"
#include "ingest/arrays/byte_order.h"
#include "ingest/arrays/npy.h"

namespace tribolog::ingest::arrays {

namespace {

constexpr std::size_t most_dimensions = 64;
constexpr int deepest_record = 16;
constexpr std::uint64_t largest_element = std::uint64_t{1} << 40;  // bytes

bool is_padding(const std::string& name, const NpyType& type) {
  if (!name.empty() || type.is_record) return false;
  const std::string& simple = type.fields.front().type;
  return simple.size() > 1 && simple[1] == 'V';
}

/// The elements of a type side by side, `shape` of them.
bool make_array(const std::vector<std::uint64_t>& shape, NpyType& type) {
  std::vector<NpyDimension> dimensions(shape.size());
  for (std::size_t k = shape.size(); k-- > 0;) {
    dimensions[k] = {shape[k], type.bytes};
    if (type.bytes > 0 && shape[k] > largest_element / type.bytes) return false;
    type.bytes *= shape[k];
  }
  for (NpyField& field : type.fields) {
    field.within.insert(field.within.begin(), dimensions.begin(), dimensions.end());
    if (field.within.size() > most_dimensions) return false;
  }
  return true;
}

class TypeReader {
 public:
  explicit TypeReader(PythonText& text) : text_(text) {}

  // NOLINTNEXTLINE(misc-no-recursion): as deep as records are nested, which is bounded
  std::optional<NpyType> take_type(int depth) {
    std::string simple;
    if (text_.take('[')) return depth < deepest_record ? take_fields(depth) : std::nullopt;
    if (!text_.take_text(simple)) return std::nullopt;
    const std::uint64_t bytes = bytes_of_type(simple).value_or(0);
    if (bytes > largest_element) return std::nullopt;
    return NpyType{{{"", simple, 0}}, false, bytes};
  }

 private:
  // NOLINTNEXTLINE(misc-no-recursion)
  std::optional<NpyType> take_fields(int depth) {
    NpyType record;
    record.is_record = true;
    while (!text_.take(']')) {
      std::string name;
      if (!text_.take('(') || !take_name(name) || !text_.take(',')) return std::nullopt;
      std::optional<NpyType> type = take_type(depth + 1);
      if (!type || !take_shape_and_end(*type)) return std::nullopt;
      if (!append(name, std::move(*type), record)) return std::nullopt;
      if (!text_.take(',')) {
        if (!text_.take(']')) return std::nullopt;
        break;
      }
    }
    return record;
  }

  /// 'name', or ('title', 'name').
  bool take_name(std::string& name) {
    if (!text_.take('(')) return text_.take_text(name);
    return text_.take_text(name) && text_.take(',') && text_.take_text(name) && text_.take(')');
  }

  /// Behind a field's type.
  bool take_shape_and_end(NpyType& type) {
    if (text_.take(')')) return true;
    std::vector<std::uint64_t> shape;
    if (!text_.take(',')) return false;
    if (text_.take(')')) return true;
    return take_npy_shape(text_, shape) && text_.take(')') && make_array(shape, type);
  }

  static bool append(const std::string& name, NpyType type, NpyType& record) {
    if (!is_padding(name, type)) {
      for (NpyField& field : type.fields) {
        field.name = field.name.empty() ? name : name + "." + field.name;
        field.offset += record.bytes;
        record.fields.push_back(std::move(field));
      }
    }
    record.bytes += type.bytes;
    return record.bytes <= largest_element;
  }

  PythonText& text_;
};

}  // namespace

std::optional<std::uint64_t> bytes_of_type(const std::string& type) {
  constexpr std::string_view kinds_in_place = "biufcmMSUVa";
  if (type.size() < 3 || kinds_in_place.find(type[1]) == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view size = std::string_view(type).substr(2);
  std::uint64_t bytes{};
  const auto [end, error] = std::from_chars(size.data(), size.data() + size.size(), bytes);
  if (error != std::errc() || (end != size.data() + size.size() && *end != '[')) {
    return std::nullopt;
  }
  constexpr std::uint64_t bytes_of_character = 4;
  return type[1] == 'U' ? bytes_of_character * std::min(bytes, largest_element) : bytes;
}

std::optional<NpyType> take_npy_type(PythonText& text) { return TypeReader(text).take_type(0); }

bool take_npy_shape(PythonText& text, std::vector<std::uint64_t>& shape) {
  if (!text.take('(')) return false;
  while (!text.take(')')) {
    std::uint64_t side{};
    if (shape.size() == most_dimensions || !text.take_number(side)) return false;
    shape.push_back(side);
    if (!text.take(',')) return text.take(')');
  }
  return true;
}

namespace {

/// Longest text that is read: NumPy's own bound for a header that it evaluates.
constexpr std::size_t longest_header = 10'000;

/// Of the Python dictionary {'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }.
bool read_dictionary(PythonText text, NpyHeader& header) {
  bool has_type = false;
  bool has_order = false;
  bool has_shape = false;
  if (!text.take('{')) return false;
  while (!text.take('}')) {
    std::string key;
    if (!text.take_text(key) || !text.take(':')) return false;
    if (key == "descr" && !has_type) {
      std::optional<NpyType> type = take_npy_type(text);
      has_type = type.has_value();
      if (!type) return false;
      header.type = *std::move(type);
    } else if (key == "fortran_order" && !has_order) {
      header.fortran_order = text.take("True");
      has_order = header.fortran_order || text.take("False");
      if (!has_order) return false;
    } else if (key == "shape" && !has_shape) {
      has_shape = take_npy_shape(text, header.shape);
      if (!has_shape) return false;
    } else {
      return false;
    }
    if (!text.take(',') && !text.take('}')) return false;
    if (text.is_at_end()) break;
  }
  return has_type && has_order && has_shape && text.is_at_end();
}

}  // namespace

NpyHeader read_npy_header(std::string_view bytes, const std::string& name,
                          const std::string& file) {
  const auto refuse = [&](const std::string& what) {
    throw InputError({file, 0, 0}, {"array " + in_quotes(name) + ": " + what, "", "", ""});
  };
  if (bytes.size() < 10 || !bytes.starts_with("\x93NUMPY")) refuse("no NumPy array");
  const auto version = static_cast<unsigned char>(bytes[6]);
  if (version < 1 || version > 3) {
    refuse("NumPy format version " + std::to_string(version) + " is not known");
  }
  const std::size_t start = version == 1 ? 10 : 12;
  if (bytes.size() < start) refuse("cut off in its header");
  const std::size_t length =
      version == 1 ? number_at<std::uint16_t>(bytes, 8) : number_at<std::uint32_t>(bytes, 8);
  if (length > bytes.size() - start) refuse("cut off in its header");
  if (length > longest_header) {
    refuse("its header has " + std::to_string(length) + " bytes, more than 10000");
  }
  NpyHeader header;
  header.bytes = start + length;
  // Only version 3 is UTF-8.
  const std::string_view text = bytes.substr(start, length);
  const std::string in_utf8 = version < 3 ? utf8_of_latin1(text) : std::string(text);
  if (first_broken_utf8(in_utf8) || !read_dictionary(PythonText(in_utf8), header)) {
    refuse("its header is damaged");
  }
  return header;
}

}  // namespace tribolog::ingest::arrays
