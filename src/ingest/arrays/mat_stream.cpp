#include "ingest/arrays/mat_stream.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

#include "ingest/arrays/byte_order.h"

namespace tribolog::ingest::arrays {

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

namespace {

constexpr std::size_t tag_bytes = 8;
constexpr std::uint64_t longest_sides = 4 * 32;
constexpr std::uint64_t most_sided = std::uint64_t{1} << 62;
constexpr int deepest = 64;

enum Kind : std::uint32_t { int_32 = 5, uint_32 = 6, matrix = 14 };
enum Class : unsigned {
  cell = 1,
  structure = 2,
  character = 4,
  first_number = 6,
  last_number = 15,
  opaque =
      17  ///< An object: its name, "MCOS", its class, and a number of what is stored elsewhere.
};
constexpr std::uint64_t longest_name = 4096;

struct Misfit : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One tag: a kind and as many bytes, of which a short one keeps up to four in the tag itself.
struct Part {
  std::uint32_t kind{};
  std::uint64_t bytes{};
  std::string short_values;
  bool is_short{};
};

/// Bytes of one value by its kind, 0 for what is no number.
std::uint64_t value_bytes(std::uint32_t kind) {
  constexpr std::array<std::uint64_t, 19> bytes = {0, 1, 1, 2, 2, 4, 4, 4, 0, 8,
                                                   0, 0, 8, 8, 0, 0, 1, 2, 4};
  return kind < bytes.size() ? bytes[kind] : 0;
}

class Walk {
 public:
  Walk(MatStream& stream, bool big_endian, MatObjects& objects)
      : stream_(stream), big_endian_(big_endian), objects_(objects) {}

  void check_element(std::uint64_t end, int depth) {
    const Part part = next_part(end);
    if (part.kind != matrix || part.is_short) throw Misfit("holds what is no array");
    if (depth > deepest) throw Misfit("is nested too deeply");
    const std::uint64_t own_end = at_ + part.bytes;
    if (part.bytes > 0) check_matrix(own_end, depth);
    pass(own_end - at_);
  }

 private:
  void check_matrix(std::uint64_t end, int depth) {
    const Part flags = next_part(end);
    if (flags.kind != uint_32 || flags.bytes != tag_bytes || flags.is_short)
      throw Misfit("has no header of an array");
    const auto word = number_at<std::uint32_t>(take(tag_bytes), 0, big_endian_);
    const unsigned array_class = word & 0xffU;
    const bool is_complex = (word & 0x800U) != 0;
    const bool has_values =
        array_class == character || (array_class >= first_number && array_class <= last_number);
    if (array_class == opaque) return check_object(end, depth);
    if (array_class != cell && array_class != structure && !has_values) return;

    const std::uint64_t count = count_of(next_part(end));
    const Part name = next_part(end);
    if (depth == 0) {
      objects_.variable = text_of(name, end);
    } else {
      pass_values(name, end);
    }
    if (array_class == cell) return check_elements(count, end, depth);
    if (array_class == structure) return check_structs(count, end, depth);
    if (count == 0) return;
    for (int i = 0; i < (is_complex ? 2 : 1); ++i) check_values(next_part(end), count, end);
  }

  void check_object(std::uint64_t end, int depth) {
    const std::string name = text_of(next_part(end), end);
    if (depth == 0) objects_.variable = name;
    objects_.is_object = depth == 0;
    pass_values(next_part(end), end);  // "MCOS"
    objects_.classes.push_back(text_of(next_part(end), end));
  }

  std::string text_of(const Part& part, std::uint64_t end) {
    if (part.is_short) return part.short_values.substr(0, static_cast<std::size_t>(part.bytes));
    if (part.bytes > longest_name) throw Misfit("has a name that is too long");
    std::string text = take(static_cast<std::size_t>(std::min(padded(part.bytes), end - at_)));
    text.resize(std::min(text.size(), static_cast<std::size_t>(part.bytes)));
    return text;
  }

  Part next_part(std::uint64_t end) {
    if (end - at_ < tag_bytes) throw Misfit("ends too early");
    const std::string tag = take(tag_bytes);
    const auto first = number_at<std::uint32_t>(tag, 0, big_endian_);
    Part part{first, number_at<std::uint32_t>(tag, 4, big_endian_), "", false};
    if (first >> 16U != 0) part = {first & 0xffffU, first >> 16U, tag.substr(4), true};
    if (part.is_short ? part.bytes > part.short_values.size() : part.bytes > end - at_)
      throw Misfit("has a part that is longer than itself");
    return part;
  }

  std::uint64_t count_of(const Part& sides) {
    if (sides.kind != int_32 || sides.is_short || sides.bytes > longest_sides)
      throw Misfit("has sides that cannot be");
    const std::string values = take(static_cast<std::size_t>(padded(sides.bytes)));
    std::uint64_t count = 1;
    for (std::size_t i = 0; i + 4 <= sides.bytes; i += 4) {
      const auto side = number_at<std::int32_t>(values, i, big_endian_);
      if (side < 0) throw Misfit("has sides that cannot be");
      if (side > 0 && count > most_sided / static_cast<std::uint64_t>(side))
        throw Misfit("claims more values than it has");
      count *= static_cast<std::uint64_t>(side);
    }
    return count;
  }

  void check_values(const Part& part, std::uint64_t count, std::uint64_t end) {
    const std::uint64_t each = value_bytes(part.kind);
    if (each == 0 || part.bytes / each < count) throw Misfit("claims more values than it has");
    pass_values(part, end);
  }

  void check_elements(std::uint64_t count, std::uint64_t end, int depth) {
    if (count > (end - at_) / tag_bytes) throw Misfit("claims more values than it has");
    for (std::uint64_t i = 0; i < count; ++i) check_element(end, depth + 1);
  }

  void check_structs(std::uint64_t count, std::uint64_t end, int depth) {
    const Part length = next_part(end);
    if (length.kind != int_32 || length.bytes != 4)
      throw Misfit("has no lengths of its names of fields");
    const std::string value = length.is_short ? length.short_values : take(tag_bytes);
    const auto name_bytes = number_at<std::int32_t>(value, 0, big_endian_);
    const Part names = next_part(end);
    pass_values(names, end);
    if (names.bytes == 0) return;
    if (name_bytes <= 0) throw Misfit("has no lengths of its names of fields");
    const std::uint64_t fields = names.bytes / static_cast<std::uint64_t>(name_bytes);
    if (count > most_sided / (fields + 1)) throw Misfit("claims more values than it has");
    check_elements(count * fields, end, depth);
  }

  /// Values begin at multiples of eight bytes; the last may go without what fills up.
  void pass_values(const Part& part, std::uint64_t end) {
    if (!part.is_short) pass(std::min(padded(part.bytes), end - at_));
  }

  static std::uint64_t padded(std::uint64_t bytes) { return (bytes + 7) / 8 * 8; }

  std::string take(std::size_t count) {
    std::string bytes = stream_.read(count);
    if (bytes.size() < count) throw Misfit("ends too early");
    at_ += count;
    return bytes;
  }

  void pass(std::uint64_t count) {
    if (stream_.skip(count) < count) throw Misfit("ends too early");
    at_ += count;
  }

  MatStream& stream_;
  bool big_endian_;
  MatObjects& objects_;
  std::uint64_t at_{0};
};

}  // namespace

std::string check_mat_matrix(MatStream& stream, bool big_endian, MatObjects& objects) {
  try {
    Walk(stream, big_endian, objects).check_element(std::numeric_limits<std::uint64_t>::max(), 0);
    return "";
  } catch (const Misfit& misfit) {
    return misfit.what();
  }
}

}  // namespace tribolog::ingest::arrays
