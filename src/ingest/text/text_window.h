#pragma once
// The part of a text log that is in memory.

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <string_view>

#include "base/byte_source.h"

namespace tribolog {

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

}  // namespace tribolog
