#include "ingest/text/text_window.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "error.h"

namespace tribolog {

void refuse_nul(std::string_view text, std::uint64_t first_byte, const std::string& file) {
  const std::size_t at = text.find('\0');
  if (at == std::string_view::npos) return;
  throw InputError({file, 0, 0}, {"binary data at byte " + std::to_string(first_byte + at), "",
                                  "a text file of columns", ""});
}

std::string_view TextWindow::read_on(std::string_view unread, std::size_t wanted_bytes) {
  // A small file gets a small window; one more byte, so that its end is seen.
  const std::uint64_t likely_rest =
      source_.likely_bytes() - std::min(source_.likely_bytes(), bytes_read_);
  std::size_t filled = unread.size();
  make_room(unread,
            std::max<std::size_t>(std::min<std::uint64_t>(wanted_bytes, filled + likely_rest + 1),
                                  filled + 1));
  while (!at_end_ && filled < wanted_bytes) {
    if (filled == room_) make_room({bytes_.get(), filled}, std::min(2 * room_ + 1, wanted_bytes));
    const std::size_t got = source_.read(bytes_.get() + filled, room_ - filled);
    at_end_ = got == 0;
    if (got == 0) break;
    // What a log starts with is judged as a whole (start_of_text).
    if (is_read_on_) refuse_nul({bytes_.get() + filled, got}, bytes_read_, file_);
    filled += got;
    bytes_read_ += got;
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

}  // namespace tribolog
