#include "ingest/arrays/mat_stream.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace tribolog {
namespace {

constexpr std::size_t piece = 1U << 16;

}  // namespace

MatBytes::MatBytes(const std::string& path) : in_(path, std::ios::binary | std::ios::ate) {
  size_ = in_ ? static_cast<std::uint64_t>(in_.tellg()) : 0;
}

std::string MatBytes::at(std::uint64_t offset, std::size_t count) {
  std::string bytes(std::min<std::uint64_t>(count, size_ - std::min(offset, size_)), '\0');
  in_.clear();
  in_.seekg(static_cast<std::streamoff>(offset));
  in_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in_.gcount()));
  return bytes;
}

MatStream::MatStream(MatBytes& file, std::uint64_t offset, std::uint64_t length, bool is_packed)
    : file_(file), offset_(offset), left_(length), is_packed_(is_packed) {
  if (is_packed_) status_ = inflateInit(&zlib_);
}

MatStream::~MatStream() {
  if (is_packed_) inflateEnd(&zlib_);
}

/// More bytes, or none at the end.
void MatStream::fill() {
  used_ = 0;
  ready_.clear();
  if (is_packed_) return unpack();
  ready_ = file_.at(offset_, std::min<std::uint64_t>(piece, left_));
  offset_ += ready_.size();
  left_ = ready_.empty() ? 0 : left_ - ready_.size();
}

void MatStream::unpack() {
  while (ready_.empty() && status_ == Z_OK) {
    if (zlib_.avail_in == 0 && left_ > 0) {
      packed_ = file_.at(offset_, std::min<std::uint64_t>(piece, left_));
      offset_ += packed_.size();
      left_ = packed_.empty() ? 0 : left_ - packed_.size();
      zlib_.next_in = reinterpret_cast<Bytef*>(packed_.data());
      zlib_.avail_in = static_cast<uInt>(packed_.size());
    }
    ready_.resize(piece);
    zlib_.next_out = reinterpret_cast<Bytef*>(ready_.data());
    zlib_.avail_out = static_cast<uInt>(piece);
    status_ = inflate(&zlib_, Z_NO_FLUSH);
    ready_.resize(piece - zlib_.avail_out);
    // It has nothing to go on with: good while there is more to give it.
    if (status_ == Z_BUF_ERROR && left_ > 0) status_ = Z_OK;
  }
}

std::string MatStream::read(std::size_t count) {
  std::string bytes;
  while (bytes.size() < count) {
    if (used_ == ready_.size()) fill();
    if (ready_.empty()) break;
    const std::size_t taken = std::min(count - bytes.size(), ready_.size() - used_);
    bytes.append(ready_, used_, taken);
    used_ += taken;
  }
  return bytes;
}

std::uint64_t MatStream::skip(std::uint64_t count) {
  std::uint64_t passed = 0;
  while (passed < count) {
    if (used_ == ready_.size()) {
      if (!is_packed_) {
        const std::uint64_t unread = std::min(count - passed, left_);
        offset_ += unread;
        left_ -= unread;
        return passed + unread;
      }
      fill();
    }
    if (ready_.empty()) break;
    const auto taken = std::min<std::uint64_t>(count - passed, ready_.size() - used_);
    passed += taken;
    used_ += static_cast<std::size_t>(taken);
  }
  return passed;
}

bool MatStream::finish() {
  skip(std::numeric_limits<std::uint64_t>::max());
  return !is_packed_ || status_ == Z_STREAM_END;
}

}  // namespace tribolog
