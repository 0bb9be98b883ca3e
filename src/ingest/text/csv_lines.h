#pragma once
// A log as lines of text, of which a part is in memory.

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/input_file.h"

namespace tribolog::ingest::text {

/// @param first_byte of the text in the file.
/// @throw InputError for a NUL byte.
void refuse_nul(std::string_view text, std::uint64_t first_byte, const std::string& file);

class TextWindow {
 public:
  /// @param file its name, for messages. Both have to live on.
  TextWindow(ByteSource& source, const std::string& file) : source_(source), file_(file) {}

  /// Reads on until `unread` and what follows it are as long as wanted, or the source ends.
  /// @param unread the end of what was returned last; empty at first. All other views of the text
  /// have no meaning any more.
  /// @throw InputError for a NUL byte from the second call on, and whatever the source throws.
  std::string_view read_on(std::string_view unread, std::size_t wanted_bytes);

  /// Reads so many bytes behind those returned last, for the next read_on(). What was returned last
  /// keeps its meaning, and may be read meanwhile by other threads. Nothing is thrown here.
  void read_ahead(std::size_t bytes);

  /// Nothing comes behind what was returned last.
  [[nodiscard]] bool at_end() const { return at_end_ && ahead_.filled == 0 && !failure_; }
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  /// Bytes that were read ahead, with room in front of them for what is unread then.
  struct Ahead {
    std::unique_ptr<char[]> bytes;
    std::size_t room{0};
    std::size_t filled{0};
  };

  /// From the source to `to`. @return how many; fewer only at the end.
  std::size_t fill(char* to, std::size_t wanted);
  std::string_view take_ahead(std::string_view unread);
  void make_room(std::string_view unread, std::size_t bytes);

  ByteSource& source_;
  const std::string& file_;
  std::unique_ptr<char[]> bytes_;
  std::size_t room_{0};
  Ahead ahead_;
  std::exception_ptr failure_;  ///< Of reading ahead; due when its bytes are asked for.
  std::uint64_t bytes_read_{0};
  bool at_end_{false};
  bool is_read_on_{false};
};

// A log as lines of text.

/// Refuses what does not start as a text of lines and returns it without its byte order mark.
/// @throw InputError: the file is empty, UTF-16, holds a NUL byte, or starts as a known binary
/// format does (gzip, zip,
///        PNG, ELF, MCAP, rosbag, HDF5, Parquet, Arrow, SQLite, NumPy, MATLAB), with what to run
///        where no library reads it.
std::string_view start_of_text(std::string_view first_bytes, const std::string& file);

/// A longer line is refused: memory stays bounded whatever stands in a file.
inline constexpr std::size_t longest_line_bytes = std::size_t{1} << 20;
/// @throw InputError that says so.
[[noreturn]] void refuse_long_line(const std::string& file, long line);

/// Whether a line that starts so is a comment: "#", "%" and "//", but for "#N/A" and the like,
/// which are gaps.
/// @param text from the line's first byte that is no blank on.
bool starts_comment(std::string_view text);

/// Walks the rows of a text: lines that are neither blank nor comments. A line ends with LF, CR LF
/// or CR, also mixed.
class RowCursor {
 public:
  /// Over a text that is in memory as a whole.
  explicit RowCursor(std::string_view text) : rest_(text) {}
  /// The text is the start of this window, which is read on as need be.
  void go_on_in(TextWindow& window) { window_ = &window; }

  /// Passes the lines in front of this one unread. @throw InputError as next(), or there are fewer.
  void go_to_line(long line, const std::string& file);
  /// Goes to the next row. @return false at the end of the text.
  /// @throw InputError for a line of more than a mebibyte, and whatever the window throws.
  bool next();
  /// Goes on to `bytes` further on, behind as many whole lines.
  /// @param any_lf, any_cr_lf how they end.
  void pass(std::size_t bytes, std::size_t lines, bool any_lf, bool any_cr_lf);
  /// Reads on until what is behind the row is as long, or the text ends; row() is then empty.
  void read_on(std::size_t bytes);
  /// Has so many bytes read behind what is in memory, for the next read_on(); while this works,
  /// rest() may be read by other threads.
  void read_ahead(std::size_t bytes);

  /// What is behind the row, as far as it is in memory.
  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] std::string_view row() const { return row_; }
  [[nodiscard]] long line() const { return line_; }  ///< Of the row; counts from 1.
  /// The last two comments between the row and the one before it, with their marks; empty where
  /// there are fewer, and where the text was read on since.
  [[nodiscard]] const std::array<std::string_view, 2>& comments() const { return comments_; }
  [[nodiscard]] bool has_line_end() const { return has_line_end_; }
  [[nodiscard]] std::uint64_t bytes_walked() const { return walked_; }
  [[nodiscard]] bool is_last() const { return rest_.empty(); }
  /// More than one kind of line end so far.
  [[nodiscard]] bool mixed_line_ends() const { return (kinds_ & (kinds_ - 1)) != 0; }

 private:
  void next_line();
  [[nodiscard]] bool may_go_on() const { return window_ != nullptr && !window_->at_end(); }
  /// The next LF in the rest; its size where there is none. Looked for once.
  [[nodiscard]] std::size_t next_lf();

  TextWindow* window_{nullptr};
  std::string_view rest_;
  std::string_view row_;
  std::array<std::string_view, 2> comments_;
  std::uint64_t walked_{0};
  std::optional<std::uint64_t> lf_at_;  ///< Counted as walked_ is, as far as one was found
  std::uint64_t searched_{0};           ///< up to here.
  long line_{0};
  bool has_line_end_{false};
  unsigned kinds_{0};
};

}  // namespace tribolog::ingest::text
