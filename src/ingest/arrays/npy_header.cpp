#include "ingest/arrays/npy_header.h"

#include <optional>
#include <utility>

#include "base/closest_match.h"
#include "base/error.h"
#include "base/utf8.h"
#include "ingest/arrays/byte_order.h"
#include "ingest/arrays/python_text.h"

namespace tribolog {
namespace {

/// Longest text that is read: NumPy's own bound for a header that it evaluates.
constexpr std::size_t longest_text = 10'000;

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
  if (length > longest_text) {
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

}  // namespace tribolog
