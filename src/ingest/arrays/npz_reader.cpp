#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <zlib.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "base/input_file.h"
#include "ingest/arrays/array_readers.h"
#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/byte_order.h"
#include "ingest/arrays/npy.h"

namespace tribolog::ingest::arrays {

// The entries of a zip archive, stored or deflated, with zip64 as NumPy writes it.

namespace {

struct ZipEntry {
  std::string name;
  std::uint16_t method{};  ///< 0 stored, 8 deflated.
  std::uint16_t flags{};
  std::uint32_t crc{};
  std::uint64_t packed_bytes{};
  std::uint64_t bytes{};
  std::uint64_t local_header{};  ///< Offset in the archive.
};

constexpr std::size_t end_record_bytes = 22;
constexpr std::size_t longest_comment = 65535;
constexpr std::size_t directory_entry_bytes = 46;
constexpr std::size_t local_header_bytes = 30;
constexpr std::uint32_t in_zip64 = 0xffffffffU;
/// Deflate makes at most 1032 bytes of one.
constexpr std::uint64_t largest_deflate_ratio = 1032;

[[noreturn]] void refuse_archive(const std::string& file, const std::string& what,
                                 const std::string& hint = {}) {
  throw InputError({file, 0, 0}, {what, "", "", hint});
}

[[noreturn]] void refuse_directory(const std::string& file) {
  refuse_archive(file, "damaged zip archive: its directory contradicts its size");
}

struct Directory {
  std::uint64_t entries{};
  std::uint64_t bytes{};
  std::uint64_t offset{};
};

std::size_t find_end_record(std::string_view archive, const std::string& file) {
  const std::size_t searched = std::min(archive.size(), end_record_bytes + longest_comment);
  const std::string_view tail = archive.substr(archive.size() - searched);
  const std::size_t at = tail.rfind("PK\x05\x06");
  if (at == std::string_view::npos || tail.size() - at < end_record_bytes) {
    refuse_archive(file, "zip archive without its directory at the end",
                   "the file may be cut off: copy or record it again");
  }
  return archive.size() - searched + at;
}

Directory find_directory(std::string_view archive, const std::string& file) {
  const std::size_t end = find_end_record(archive, file);
  Directory found{number_at<std::uint16_t>(archive, end + 10),
                  number_at<std::uint32_t>(archive, end + 12),
                  number_at<std::uint32_t>(archive, end + 16)};
  constexpr std::size_t locator_bytes = 20;
  constexpr std::size_t zip64_record_bytes = 56;
  if (end >= locator_bytes && archive.substr(end - locator_bytes, 4) == "PK\x06\x07") {
    const auto at = number_at<std::uint64_t>(archive, end - locator_bytes + 8);
    if (at > end || end - at < zip64_record_bytes || archive.substr(at, 4) != "PK\x06\x06") {
      refuse_directory(file);
    }
    found = {number_at<std::uint64_t>(archive, at + 32), number_at<std::uint64_t>(archive, at + 40),
             number_at<std::uint64_t>(archive, at + 48)};
  }
  if (found.offset > end || found.bytes > end - found.offset ||
      found.entries > found.bytes / directory_entry_bytes) {
    refuse_directory(file);
  }
  return found;
}

/// Sizes and offset that do not fit into 32 bits stand in the extra field, in this order.
void read_zip64(std::string_view extra, ZipEntry& entry, const std::string& file) {
  while (extra.size() >= 4) {
    const auto kind = number_at<std::uint16_t>(extra, 0);
    const auto length = number_at<std::uint16_t>(extra, 2);
    if (length > extra.size() - 4) refuse_directory(file);
    std::string_view values = extra.substr(4, length);
    extra.remove_prefix(4U + length);
    if (kind != 1) continue;
    for (std::uint64_t* field : {&entry.bytes, &entry.packed_bytes, &entry.local_header}) {
      if (*field != in_zip64) continue;
      if (values.size() < 8) refuse_directory(file);
      *field = number_at<std::uint64_t>(values, 0);
      values.remove_prefix(8);
    }
  }
}

std::string_view packed_bytes(std::string_view archive, const ZipEntry& entry,
                              const std::string& file) {
  const std::uint64_t at = entry.local_header;
  if (at > archive.size() || archive.size() - at < local_header_bytes ||
      archive.substr(at, 4) != "PK\x03\x04") {
    refuse_directory(file);
  }
  const std::uint64_t data = at + local_header_bytes + number_at<std::uint16_t>(archive, at + 26) +
                             number_at<std::uint16_t>(archive, at + 28);
  if (data > archive.size() || entry.packed_bytes > archive.size() - data) refuse_directory(file);
  return archive.substr(data, entry.packed_bytes);
}

/// zlib counts in 32 bits: input and output go through in pieces.
bool inflate_all(std::string_view packed, std::string& bytes) {
  constexpr std::size_t largest_piece = std::numeric_limits<uInt>::max();
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return false;
  // zlib does not write to its input; its interface is from before const.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  std::size_t input_left = packed.size();
  std::size_t output_left = bytes.size();
  int status = Z_OK;
  while (status == Z_OK) {
    const std::size_t in = std::min(input_left, largest_piece);
    const std::size_t out = std::min(output_left, largest_piece);
    stream.avail_in = static_cast<uInt>(in);
    stream.avail_out = static_cast<uInt>(out);
    status = inflate(&stream, Z_NO_FLUSH);
    input_left -= in - stream.avail_in;
    output_left -= out - stream.avail_out;
  }
  inflateEnd(&stream);
  return status == Z_STREAM_END && output_left == 0;
}

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// The entries by the directory at the archive's end.
/// @throw InputError where it is missing (a truncated file) or contradicts the archive's size.
std::vector<ZipEntry> list_zip(std::string_view archive, const std::string& file) {
  const Directory directory = find_directory(archive, file);
  std::string_view rest = archive.substr(directory.offset, directory.bytes);
  std::vector<ZipEntry> entries;
  entries.reserve(directory.entries);
  std::uint64_t packed_left = archive.size();
  for (std::uint64_t i = 0; i < directory.entries; ++i) {
    if (rest.size() < directory_entry_bytes || !rest.starts_with("PK\x01\x02")) {
      refuse_directory(file);
    }
    ZipEntry entry;
    entry.flags = number_at<std::uint16_t>(rest, 8);
    entry.method = number_at<std::uint16_t>(rest, 10);
    entry.crc = number_at<std::uint32_t>(rest, 16);
    entry.packed_bytes = number_at<std::uint32_t>(rest, 20);
    entry.bytes = number_at<std::uint32_t>(rest, 24);
    const std::size_t name_bytes = number_at<std::uint16_t>(rest, 28);
    const std::size_t extra_bytes = number_at<std::uint16_t>(rest, 30);
    const std::size_t comment_bytes = number_at<std::uint16_t>(rest, 32);
    entry.local_header = number_at<std::uint32_t>(rest, 42);
    rest.remove_prefix(directory_entry_bytes);
    if (name_bytes + extra_bytes + comment_bytes > rest.size()) refuse_directory(file);
    entry.name = rest.substr(0, name_bytes);
    read_zip64(rest.substr(name_bytes, extra_bytes), entry, file);
    // Entries that share their bytes would unpack the same again and again.
    if (entry.packed_bytes > packed_left) refuse_directory(file);
    packed_left -= entry.packed_bytes;
    rest.remove_prefix(name_bytes + extra_bytes + comment_bytes);
    entries.push_back(std::move(entry));
  }
  return entries;
}

/// One entry's bytes; its stated size is believed only as far as its packed size can hold it.
/// @throw InputError naming the entry: encrypted, packed in another way, cut off, wrong checksum.
std::string unpack_zip_entry(std::string_view archive, const ZipEntry& entry,
                             const std::string& file) {
  constexpr std::uint16_t stored = 0;
  constexpr std::uint16_t deflated = 8;
  const std::string what = "entry " + in_quotes(entry.name) + " of the archive ";
  if ((entry.flags & 1U) != 0) refuse_archive(file, what + "is encrypted");
  if (entry.method != stored && entry.method != deflated) {
    refuse_archive(file, what + "is packed by method " + std::to_string(entry.method),
                   "write it by numpy.savez or numpy.savez_compressed");
  }
  const std::string_view packed = packed_bytes(archive, entry, file);
  std::string bytes;
  if (entry.method == stored) {
    bytes = packed;
  } else if (entry.bytes / largest_deflate_ratio <= packed.size()) {
    bytes.resize(entry.bytes);
    if (!inflate_all(packed, bytes))
      refuse_archive(file, what + "is damaged: it cannot be unpacked");
  }
  if (bytes.size() != entry.bytes) {
    refuse_archive(file, what + "is damaged: its stated size is not that of its bytes");
  }
  if (checksum(bytes) != entry.crc)
    refuse_archive(file, what + "is damaged: its checksum is wrong");
  return bytes;
}

constexpr std::string_view array_ending = ".npy";

void add_entry(std::string_view archive, const ZipEntry& entry, const std::string& file,
               FileArrays& found) {
  if (entry.name.ends_with('/')) return;  // a folder
  if (!entry.name.ends_with(array_ending)) {
    found.leave_out(entry.name, "it is no NumPy array");
    return;
  }
  // The widest number has 8 bytes; text and objects may be larger and are not unpacked then.
  if (entry.bytes > 8 * most_values) {
    found.leave_out(entry.name, "it would unpack to more than 16 GiB");
    return;
  }
  const std::string name = entry.name.substr(0, entry.name.size() - array_ending.size());
  add_npy_array(unpack_zip_entry(archive, entry, file), name, file, RecordNames::by_array_and_field,
                found);
}

}  // namespace

std::vector<log::LogTable> parse_npz(std::string_view bytes, const std::string& file) {
  FileArrays found;
  if (bytes.starts_with("\x93NUMPY")) {
    add_npy_array(bytes, std::filesystem::path(file).stem().string(), file, RecordNames::by_field,
                  found);
  } else {
    for (const ZipEntry& entry : list_zip(bytes, file)) add_entry(bytes, entry, file, found);
  }
  return tables_of(std::move(found), file);
}

std::vector<log::LogTable> read_npz(const std::string& path) {
  return parse_npz(read_file(path), path);
}

}  // namespace tribolog::ingest::arrays
