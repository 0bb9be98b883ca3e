#include "ingest/text/text_window.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/error.h"

namespace tribolog {
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

}  // namespace tribolog
