#include "ingest/arrays/npy_header.h"

#include <charconv>

#include "error.h"
#include "ingest/arrays/byte_order.h"
#include "ingest/closest_match.h"

namespace tribolog {
namespace {

/// Longest text that is read: NumPy's own bound for a header that it evaluates.
constexpr std::size_t longest_text = 10'000;
constexpr std::size_t most_dimensions = 64;

/// Walks the Python dictionary {'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }.
class DictionaryText {
 public:
  explicit DictionaryText(std::string_view text) : rest_(text) {}

  bool take(char c) {
    skip_blanks();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  bool take(std::string_view word) {
    skip_blanks();
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  bool take_text(std::string& text) {
    skip_blanks();
    if (rest_.empty() || (rest_.front() != '\'' && rest_.front() != '"')) return false;
    const std::size_t end = rest_.find(rest_.front(), 1);
    if (end == std::string_view::npos) return false;
    text = rest_.substr(1, end - 1);
    rest_.remove_prefix(end + 1);
    return true;
  }
  bool take_number(std::uint64_t& number) {
    skip_blanks();
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
    if (error != std::errc()) return false;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    (void)take('L');  // Python 2 wrote 3L
    return true;
  }
  /// A list with all that is nested in it, as the fields of a record.
  bool skip_list() {
    if (!take('[')) return false;
    for (int depth = 1; depth > 0;) {
      std::string ignored;
      if (take_text(ignored)) continue;
      if (rest_.empty()) return false;
      depth += rest_.front() == '[' ? 1 : rest_.front() == ']' ? -1 : 0;
      rest_.remove_prefix(1);
    }
    return true;
  }
  bool is_at_end() {
    skip_blanks();
    return rest_.empty();
  }

 private:
  void skip_blanks() {
    const std::size_t first = rest_.find_first_not_of(" \n\t\r");
    rest_.remove_prefix(first == std::string_view::npos ? rest_.size() : first);
  }
  std::string_view rest_;
};

bool read_shape(DictionaryText& text, std::vector<std::uint64_t>& shape) {
  if (!text.take('(')) return false;
  while (!text.take(')')) {
    std::uint64_t side{};
    if (shape.size() == most_dimensions || !text.take_number(side)) return false;
    shape.push_back(side);
    if (!text.take(',')) return text.take(')');
  }
  return true;
}

bool read_dictionary(DictionaryText text, NpyHeader& header) {
  bool has_type = false;
  bool has_order = false;
  bool has_shape = false;
  if (!text.take('{')) return false;
  while (!text.take('}')) {
    std::string key;
    if (!text.take_text(key) || !text.take(':')) return false;
    if (key == "descr" && !has_type) {
      has_type = text.take_text(header.type) || text.skip_list();
      if (!has_type) return false;
    } else if (key == "fortran_order" && !has_order) {
      header.fortran_order = text.take("True");
      has_order = header.fortran_order || text.take("False");
      if (!has_order) return false;
    } else if (key == "shape" && !has_shape) {
      has_shape = read_shape(text, header.shape);
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
  if (!read_dictionary(DictionaryText(bytes.substr(start, length)), header)) {
    refuse("its header is damaged");
  }
  return header;
}

}  // namespace tribolog
