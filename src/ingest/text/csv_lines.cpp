#include "ingest/text/csv_lines.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "base/error.h"
#include "ingest/log/log_format.h"

namespace tribolog::ingest::text {

namespace {

/// Longest unread rest in front of which what was read ahead is put; a longer one is moved.
constexpr std::size_t lead_bytes = std::size_t{1} << 21;

}  // namespace

void refuse_nul(std::string_view text, std::uint64_t first_byte, const std::string& file) {
  const std::size_t at = text.find('\0');
  if (at == std::string_view::npos) return;
  throw InputError({file, 0, 0}, {"binary data at byte " + std::to_string(first_byte + at), "",
                                  "a text file of columns", ""});
}

std::size_t TextWindow::fill(char* to, std::size_t wanted) {
  std::size_t filled = 0;
  while (!at_end_ && filled < wanted) {
    const std::size_t got = source_.read(to + filled, wanted - filled);
    at_end_ = got == 0;
    // What a log starts with is judged as a whole (start_of_text).
    if (is_read_on_) refuse_nul({to + filled, got}, bytes_read_, file_);
    filled += got;
    bytes_read_ += got;
  }
  return filled;
}

void TextWindow::read_ahead(std::size_t bytes) {
  if (at_end_ || failure_ || ahead_.filled > 0) return;
  if (ahead_.room < lead_bytes + bytes) {
    ahead_.bytes.reset(new char[lead_bytes + bytes]);  // not filled with zeros
    ahead_.room = lead_bytes + bytes;
  }
  try {
    ahead_.filled = fill(ahead_.bytes.get() + lead_bytes, bytes);
  } catch (...) {
    failure_ = std::current_exception();
  }
}

std::string_view TextWindow::take_ahead(std::string_view unread) {
  if (failure_) std::rethrow_exception(failure_);
  if (ahead_.filled == 0) return unread;
  const std::size_t filled = std::exchange(ahead_.filled, 0);
  const std::size_t all = unread.size() + filled;
  if (unread.size() <= lead_bytes) {
    char* const begin = ahead_.bytes.get() + lead_bytes - unread.size();
    if (!unread.empty()) std::memcpy(begin, unread.data(), unread.size());
    std::swap(bytes_, ahead_.bytes);
    std::swap(room_, ahead_.room);
    return {begin, all};
  }
  make_room(unread, all);
  std::memcpy(bytes_.get() + unread.size(), ahead_.bytes.get() + lead_bytes, filled);
  return {bytes_.get(), all};
}

std::string_view TextWindow::read_on(std::string_view unread, std::size_t wanted_bytes) {
  unread = take_ahead(unread);
  if (at_end_ || unread.size() >= wanted_bytes) return unread;
  // A small file gets a small window; one more byte, so that its end is seen.
  const std::uint64_t likely_rest =
      source_.likely_bytes() - std::min(source_.likely_bytes(), bytes_read_);
  std::size_t filled = unread.size();
  make_room(unread,
            std::max<std::size_t>(std::min<std::uint64_t>(wanted_bytes, filled + likely_rest + 1),
                                  filled + 1));
  while (!at_end_ && filled < wanted_bytes) {
    if (filled == room_) make_room({bytes_.get(), filled}, std::min(2 * room_ + 1, wanted_bytes));
    filled += fill(bytes_.get() + filled, std::min(room_, wanted_bytes) - filled);
  }
  is_read_on_ = true;
  return {bytes_.get(), filled};
}

void TextWindow::make_room(std::string_view unread, std::size_t bytes) {
  if (bytes <= room_) {
    if (!unread.empty()) std::memmove(bytes_.get(), unread.data(), unread.size());
    return;
  }
  // Not filled with zeros: a large window would be written twice.
  std::unique_ptr<char[]> larger(new char[bytes]);
  if (!unread.empty()) std::memcpy(larger.get(), unread.data(), unread.size());
  bytes_ = std::move(larger);
  room_ = bytes;
}

namespace {

using namespace std::string_view_literals;

constexpr std::string_view export_it = "export or unpack it as CSV";
// The distributions have no library for these, and no package of pyarrow; Debian has one for
// Feather as it was in 2016.
constexpr std::string_view by_feather =
    "in a Python with pandas and pyarrow (pip install pandas pyarrow): python3 -c \"import pandas; "
    "pandas.read_feather('LOG').to_csv('LOG.csv')\"";
constexpr std::string_view by_old_feather =
    "apt-get install python3-feather-format; /usr/bin/python3 -c \"import feather; "
    "feather.read_dataframe('LOG').to_csv('LOG.csv')\"";
constexpr std::string_view by_stream =
    "in a Python with pandas and pyarrow (pip install pandas pyarrow): python3 -c \"import "
    "pyarrow; "
    "pyarrow.ipc.open_stream('LOG').read_pandas().to_csv('LOG.csv')\"";

constexpr std::string_view by_ulog = "pip install pyulog; ulog2csv LOG";
// No command of rerun's writes a table; its server gives one. The clock of the log comes first.
constexpr std::string_view by_rerun =
    "in a Python with rerun (pip install 'rerun-sdk[catalog]'): python3 -c \"import os; from "
    "rerun.server import Server; s = Server(datasets={'log': [os.path.abspath('LOG')]}); d = "
    "s.client().get_dataset('log'); n = sorted((i.name for i in d.schema().index_columns()), "
    "key=lambda n: n.startswith('log_'))[0]; d.reader(index=n).to_pandas().map(lambda v: "
    "v.total_seconds() if hasattr(v, 'total_seconds') else v[0] if hasattr(v, 'shape') and v.shape "
    "else v).to_csv('LOG.csv', index=False)\"";

struct BinaryFormat {
  std::string_view start;
  std::string_view name;
  std::string_view hint{export_it};
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
    BinaryFormat{"ARROW1"sv, "Arrow (also .feather)", by_feather},
    BinaryFormat{"FEA1"sv, "Feather (of 2016)", by_old_feather},
    BinaryFormat{"\xff\xff\xff\xff"sv, "Arrow (a stream)", by_stream},
    BinaryFormat{"SQLite format 3"sv, "SQLite (also .db3 bags)"},
    BinaryFormat{"\x93NUMPY"sv, "NumPy"},
    BinaryFormat{"MATLAB 5.0 MAT"sv, "MATLAB"},
    BinaryFormat{"ULog\x01\x12\x35"sv, "ULog (PX4)", by_ulog},
    BinaryFormat{"RRF2"sv, "Rerun (.rrd)", by_rerun},
    BinaryFormat{"RRF1"sv, "Rerun (.rrd)", by_rerun},
    BinaryFormat{"RRF0"sv, "Rerun (.rrd)", by_rerun},
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

}  // namespace

bool starts_comment(std::string_view text) {
  constexpr std::array gaps = {"#N/A"sv, "#n/a"sv, "#NA"sv};
  if (!text.starts_with('#')) return text.starts_with('%') || text.starts_with("//");
  return std::none_of(gaps.begin(), gaps.end(),
                      [&](std::string_view gap) { return text.starts_with(gap); });
}

std::string_view start_of_text(std::string_view bytes, const std::string& file) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
  if (bytes.empty()) throw InputError({file, 0, 0}, {"file is empty", "", "", ""});
  for (const BinaryFormat& format : formats) {
    if (!bytes.starts_with(format.start)) continue;
    refuse(file, "is a binary file: " + std::string(format.name), std::string(format.hint));
  }
  if (log::is_zarr_metadata(bytes)) {
    throw InputError({file, 0, 0},
                     {"is a file of a Zarr store, not a log", "", "", std::string(log::by_zarr)});
  }
  if (is_utf16(bytes)) {
    refuse(file, "looks like UTF-16 (byte 0)", "convert it: iconv -f UTF-16 -t UTF-8");
  }
  refuse_nul(bytes, 0, file);
  return bytes;
}

void refuse_long_line(const std::string& file, long line) {
  throw InputError({file, line, 0}, {"line is longer than 1 MiB", "", "a text file of columns",
                                     "do its rows end with line ends?"});
}

void RowCursor::go_to_line(long line, const std::string& file) {
  while (line_ + 1 < line && !rest_.empty()) next_line();
  if (line_ + 1 < line || rest_.empty()) {
    throw InputError({file, line_, 0}, {"the log ends in front of its header", "",
                                        "the header in line " + std::to_string(line),
                                        "header_line states the line of the columns' names"});
  }
}

bool RowCursor::next() {
  comments_ = {};
  while (!rest_.empty()) {
    next_line();
    const std::size_t first = row_.find_first_not_of(" \t");
    if (first == std::string_view::npos) continue;
    if (!starts_comment(row_.substr(first))) return true;
    comments_ = {comments_[1], row_.substr(first)};
  }
  return false;
}

void RowCursor::pass(std::size_t bytes, std::size_t lines, bool any_lf, bool any_cr_lf) {
  rest_.remove_prefix(bytes);
  walked_ += bytes;
  line_ += static_cast<long>(lines);
  kinds_ |= (any_lf ? 1U : 0U) | (any_cr_lf ? 2U : 0U);
}

void RowCursor::read_on(std::size_t bytes) {
  if (!may_go_on() || rest_.size() >= bytes) return;
  row_ = {};
  comments_ = {};
  rest_ = window_->read_on(rest_, bytes);
}

void RowCursor::read_ahead(std::size_t bytes) {
  if (may_go_on()) window_->read_ahead(bytes);
}

std::size_t RowCursor::next_lf() {
  // Once for each LF, not once for each line: lines may end with CR alone.
  if (lf_at_ && *lf_at_ >= walked_) return *lf_at_ - walked_;
  const std::size_t found = rest_.find('\n', std::max(searched_, walked_) - walked_);
  if (found == std::string_view::npos) {
    lf_at_.reset();
    searched_ = walked_ + rest_.size();
    return rest_.size();
  }
  lf_at_ = walked_ + found;
  searched_ = *lf_at_ + 1;
  return found;
}

void RowCursor::next_line() {
  ++line_;
  row_ = {};
  std::size_t end = next_lf();
  std::size_t cr = rest_.substr(0, end).find('\r');
  // A CR at the very end may be followed by LF; and the line behind tells whether this is the last.
  while (may_go_on() && (cr == std::string_view::npos || cr + 1 >= rest_.size()) &&
         end + 1 >= rest_.size()) {
    if (rest_.size() > longest_line_bytes) {
      refuse_long_line(window_->file(), line_);
    }
    comments_ = {};
    rest_ = window_->read_on(rest_, std::max(2 * rest_.size(), longest_line_bytes));
    end = next_lf();
    cr = rest_.substr(0, end).find('\r');
  }
  std::size_t next = end < rest_.size() ? end + 1 : end;
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
  walked_ += next;
}

}  // namespace tribolog::ingest::text
