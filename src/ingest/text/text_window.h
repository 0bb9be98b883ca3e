#pragma once
// The part of a text log that is in memory.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "files/byte_source.h"

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

  /// Nothing comes behind what was returned last.
  [[nodiscard]] bool at_end() const { return at_end_; }
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  void make_room(std::string_view unread, std::size_t bytes);

  ByteSource& source_;
  const std::string& file_;
  std::unique_ptr<char[]> bytes_;
  std::size_t room_{0};
  std::uint64_t bytes_read_{0};
  bool at_end_{false};
  bool is_read_on_{false};
};

}  // namespace tribolog
