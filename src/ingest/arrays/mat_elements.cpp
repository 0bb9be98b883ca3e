#include "ingest/arrays/mat_elements.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <optional>

#include <zlib.h>

#include "ingest/arrays/byte_order.h"
#include "ingest/arrays/isolated_reading.h"

namespace tribolog {
namespace {

constexpr std::size_t header_bytes_5 = 128;
constexpr std::size_t tag_bytes_5 = 8;
constexpr std::size_t header_bytes_4 = 20;

class MatBytes {
 public:
  explicit MatBytes(const std::string& path) : in_(path, std::ios::binary | std::ios::ate) {
    size_ = in_ ? static_cast<std::uint64_t>(in_.tellg()) : 0;
  }
  /// Up to `count` bytes from there.
  std::string at(std::uint64_t offset, std::size_t count) {
    std::string bytes(std::min<std::uint64_t>(count, size_ - std::min(offset, size_)), '\0');
    in_.seekg(static_cast<std::streamoff>(offset));
    in_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(in_.gcount()));
    return bytes;
  }
  [[nodiscard]] std::uint64_t size() const { return size_; }

 private:
  std::ifstream in_;
  std::uint64_t size_{};
};

[[noreturn]] void refuse(std::size_t number, const std::string& what) {
  throw UnreadableFile("damaged MAT file: variable " + std::to_string(number) + " " + what);
}

/// Unpacks to nowhere: zlib compares the checksum at the end.
bool is_intact(MatBytes& file, std::uint64_t offset, std::uint64_t length) {
  constexpr std::size_t piece = 1U << 16;
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) return false;
  std::array<unsigned char, piece> unpacked;
  int status = Z_OK;
  while (status == Z_OK && length > 0) {
    std::string packed = file.at(offset, std::min<std::uint64_t>(piece, length));
    if (packed.empty()) break;
    offset += packed.size();
    length -= packed.size();
    stream.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    do {
      stream.next_out = unpacked.data();
      stream.avail_out = piece;
      status = inflate(&stream, Z_NO_FLUSH);
    } while (status == Z_OK && (stream.avail_in > 0 || stream.avail_out == 0));
    if (status == Z_BUF_ERROR) status = Z_OK;  // wants the next piece
  }
  inflateEnd(&stream);
  return status == Z_STREAM_END;
}

MatElements check_version_5(MatBytes& file) {
  constexpr std::uint32_t matrix = 14;
  constexpr std::uint32_t compressed = 15;
  const bool big_endian = file.at(126, 2) == "MI";
  MatElements found;
  for (std::uint64_t at = header_bytes_5; at < file.size();) {
    const std::string tag = file.at(at, tag_bytes_5);
    const std::uint64_t left = file.size() - at;
    const std::uint64_t length =
        tag.size() < tag_bytes_5 ? left : number_at<std::uint32_t>(tag, 4, big_endian);
    if (left < tag_bytes_5 || length > left - tag_bytes_5) {
      found.ends_inside = true;
      break;
    }
    const auto type = number_at<std::uint32_t>(tag, 0, big_endian);
    if (type != matrix && type != compressed) {
      refuse(found.complete + 1, "is of the unknown kind " + std::to_string(type));
    }
    if (type == compressed && !is_intact(file, at + tag_bytes_5, length)) {
      refuse(found.complete + 1, "has a wrong checksum");
    }
    at += tag_bytes_5 + length;
    ++found.complete;
  }
  return found;
}

/// Bytes of one value by the second digit of a MAT 4 type.
std::optional<std::uint64_t> value_bytes_4(std::uint32_t type) {
  constexpr std::array<std::uint64_t, 6> bytes = {8, 4, 4, 2, 2, 1};
  const std::uint32_t digit = type / 10 % 10;
  if (type >= 5000 || digit >= bytes.size()) return std::nullopt;
  return bytes[digit];
}

MatElements check_version_4(MatBytes& file) {
  MatElements found;
  for (std::uint64_t at = 0; at < file.size();) {
    const std::string header = file.at(at, header_bytes_4);
    const std::uint64_t left = file.size() - at;
    found.ends_inside = header.size() < header_bytes_4;
    if (found.ends_inside) break;
    const bool big_endian = number_at<std::uint32_t>(header, 0) >= 5000;
    const auto field = [&](std::size_t i) {
      return number_at<std::uint32_t>(header, 4 * i, big_endian);
    };
    const auto value_bytes = value_bytes_4(field(0));
    if (!value_bytes || field(3) > 1 || field(4) > 4096) {
      refuse(found.complete + 1, "has a header that cannot be");
    }
    const std::uint64_t rest = left - header_bytes_4;
    const std::uint64_t count = std::uint64_t{field(1)} * field(2);
    const std::uint64_t room = rest / *value_bytes / (1 + field(3));
    found.ends_inside =
        field(4) > rest || count > room || field(4) + count * *value_bytes * (1 + field(3)) > rest;
    if (found.ends_inside) break;
    at += header_bytes_4 + field(4) + count * *value_bytes * (1 + field(3));
    ++found.complete;
  }
  return found;
}

}  // namespace

MatVersion mat_version(const std::string& path) {
  MatBytes file(path);
  const std::string start = file.at(0, header_bytes_5);
  if (start.empty()) throw UnreadableFile("file is empty");
  if (start.starts_with("MATLAB 7.3 MAT") || start.starts_with("\x89HDF")) {
    return MatVersion::mat_7_3;
  }
  if (start.size() == header_bytes_5 && (start.ends_with("IM") || start.ends_with("MI"))) {
    return MatVersion::mat_5;
  }
  if (start.size() >= header_bytes_4 && (value_bytes_4(number_at<std::uint32_t>(start, 0)) ||
                                         value_bytes_4(number_at<std::uint32_t>(start, 0, true)))) {
    return MatVersion::mat_4;
  }
  throw UnreadableFile("no MAT file, or cut off in its header");
}

MatElements check_mat_elements(const std::string& path, MatVersion version) {
  MatBytes file(path);
  return version == MatVersion::mat_5 ? check_version_5(file) : check_version_4(file);
}

}  // namespace tribolog
