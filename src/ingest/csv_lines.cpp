#include "ingest/csv_lines.h"

#include <array>

#include "error.h"

namespace tribolog {
namespace {

using namespace std::string_view_literals;

struct BinaryFormat {
  std::string_view start;
  std::string_view name;
};

constexpr std::array formats = {
    BinaryFormat{"\x1f\x8b"sv, "gzip"},
    BinaryFormat{"BZh"sv, "bzip2"},
    BinaryFormat{"\xfd"
                 "7zXZ"sv,
                 "xz"},
    BinaryFormat{"\x28\xb5\x2f\xfd"sv, "zstd"},
    BinaryFormat{"PK\x03\x04"sv, "zip (also .xlsx and .npz)"},
    BinaryFormat{"\x89PNG"sv, "PNG"},
    BinaryFormat{"\x7f"
                 "ELF"sv,
                 "ELF"},
    BinaryFormat{"\x89MCAP"sv, "MCAP"},
    BinaryFormat{"#ROSBAG V"sv, "rosbag"},
    BinaryFormat{"\x89HDF"sv, "HDF5"},
    BinaryFormat{"PAR1"sv, "Parquet"},
    BinaryFormat{"SQLite format 3"sv, "SQLite (also .db3 bags)"},
    BinaryFormat{"\x93NUMPY"sv, "NumPy"},
    BinaryFormat{"MATLAB 5.0 MAT"sv, "MATLAB"},
};

[[noreturn]] void refuse(const std::string& file, const std::string& what,
                         const std::string& hint) {
  throw InputError({file, 0, 0}, {what, "", "a text file of columns", hint});
}

bool is_utf16(std::string_view bytes) {
  const bool has_mark = bytes.starts_with("\xff\xfe"sv) || bytes.starts_with("\xfe\xff"sv);
  return has_mark || (bytes.size() >= 4 && (bytes[0] == 0) != (bytes[1] == 0) &&
                      (bytes[0] == 0) == (bytes[2] == 0) && (bytes[1] == 0) == (bytes[3] == 0));
}

/// Neither blank nor a comment.
bool is_row(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && line[first] != '#';
}

}  // namespace

std::string_view text_of_log(std::string_view bytes, const std::string& file) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
  if (bytes.empty()) throw InputError({file, 0, 0}, {"file is empty", "", "", ""});
  for (const BinaryFormat& format : formats) {
    if (!bytes.starts_with(format.start)) continue;
    refuse(file, "is a binary file: " + std::string(format.name), "export or unpack it as CSV");
  }
  if (is_utf16(bytes)) {
    refuse(file, "looks like UTF-16 (byte 0)", "convert it: iconv -f UTF-16 -t UTF-8");
  }
  if (const std::size_t nul = bytes.find('\0'); nul != std::string_view::npos) {
    refuse(file, "binary data at byte " + std::to_string(nul), "");
  }
  return bytes;
}

bool RowCursor::next() {
  while (!rest_.empty()) {
    next_line();
    if (is_row(row_)) return true;
  }
  return false;
}

void RowCursor::pass(std::size_t bytes, std::size_t lines, bool any_lf, bool any_cr_lf) {
  rest_.remove_prefix(bytes);
  line_ += static_cast<long>(lines);
  kinds_ |= (any_lf ? 1U : 0U) | (any_cr_lf ? 2U : 0U);
}

void RowCursor::next_line() {
  ++line_;
  const std::size_t lf = rest_.find('\n');
  std::size_t end = lf == std::string_view::npos ? rest_.size() : lf;
  std::size_t next = lf == std::string_view::npos ? end : lf + 1;
  const std::size_t cr = rest_.substr(0, end).find('\r');
  if (cr != std::string_view::npos) {
    const bool is_cr_lf = cr + 1 == end && next > end;
    end = cr;
    if (!is_cr_lf) next = cr + 1;
    kinds_ |= is_cr_lf ? 2U : 4U;
  } else if (next > end) {
    kinds_ |= 1U;
  }
  has_line_end_ = next > end;
  row_ = rest_.substr(0, end);
  rest_.remove_prefix(next);
}

}  // namespace tribolog
