#include "ingest/measurement/mdf_data.h"

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>

#include <fmt/format.h>
#include <libdeflate.h>

#include "ingest/arrays/byte_order.h"

namespace tribolog::ingest::measurement {
namespace {

/// Data that cannot be read on; the text says why.
class DataError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

constexpr std::size_t block_header_bytes = 24;

class DataBlocks {
 public:
  DataBlocks(MdfBlocks& blocks, bool is_finalized, MdfData& data)
      : blocks_(blocks), is_finalized_(is_finalized), data_(data) {}

  /// Whatever a link of a data group, or of a list of data, leads to.
  void take(MdfLink link) {
    const std::string_view mark = blocks_.mark_at(link);
    if (mark == "##HL") return take_list(blocks_.once(link, {"##HL"}).link(0));
    if (mark == "##DL") return take_list(link);
    if (mark == "##LD" || mark == "##DV") throw DataError("its data are stored by columns");
    take_block(link);
  }

  /// After the last block.
  void finish() {
    if (!pieces_are_one_) data_.bytes = data_.unpacked;
  }

 private:
  void take_list(MdfLink link) {
    while (link != 0 && data_.cut.empty()) {
      const MdfBlock list = blocks_.once(link, {"##DL"});
      const std::size_t links = std::min<std::size_t>(1 + list.uint32(4), list.links());
      for (std::size_t i = 1; i < links && data_.cut.empty(); ++i) {
        if (list.link(i) != 0) take_block(list.link(i));
      }
      link = list.link(0);
    }
  }

  void take_block(MdfLink link) {
    if (blocks_.mark_at(link).empty() || blocks_.mark_at(link) == "##DZ") {
      if (note_cut(link, "##DZ")) return;
    }
    const MdfBlock block = blocks_.once(link, {"##DT", "##DZ"});
    if (block.mark() == "##DZ") {
      keep(unpacked(block));
    } else {
      keep(stored(block));
    }
  }

  /// Of a file that was not finalized the length of the last block may never have been written.
  std::string_view stored(const MdfBlock& block) {
    const std::string_view rest = blocks_.bytes().substr(block.at());
    const auto stated = arrays::number_at<std::uint64_t>(rest, 8);
    const std::string_view behind = rest.substr(block_header_bytes);
    const bool is_open = !is_finalized_ && (stated == block_header_bytes || stated > rest.size());
    if (is_open && !behind.starts_with("##")) {
      blocks_.count_rest(block.at() + block_header_bytes);
      return behind;
    }
    (void)note_cut(block.at(), "##DT");
    return block.data();
  }

  /// @return whether the file ends in front of a block's end.
  bool note_cut(MdfLink link, const std::string& mark) {
    const std::uint64_t size = blocks_.bytes().size();
    const std::uint64_t rest = size - std::min(size, link);
    const std::uint64_t stated = rest < block_header_bytes
                                     ? block_header_bytes
                                     : arrays::number_at<std::uint64_t>(blocks_.bytes(), link + 8);
    if (stated <= rest) return false;
    data_.cut = {
        "reading.truncated",
        {{"record", "data block " + mark}, {"byte", link}, {"expected", stated}, {"got", rest}}};
    return true;
  }

  std::string unpacked(const MdfBlock& block);

  void keep(std::string_view bytes) {
    if (pieces_are_one_ && data_.bytes.empty()) {
      data_.bytes = bytes;
      return;
    }
    if (pieces_are_one_) data_.unpacked = data_.bytes;
    pieces_are_one_ = false;
    check_size(bytes.size());
    data_.unpacked += bytes;
  }
  void keep(std::string bytes) {
    if (pieces_are_one_ && !data_.bytes.empty()) data_.unpacked = data_.bytes;
    pieces_are_one_ = false;
    check_size(bytes.size());
    if (data_.unpacked.empty()) {
      data_.unpacked = std::move(bytes);
    } else {
      data_.unpacked += bytes;
    }
  }
  void check_size(std::uint64_t more) const {
    if (more > most_unpacked_bytes - data_.unpacked.size()) {
      throw DataError("its data would unpack to more than 8 GiB");
    }
  }

  MdfBlocks& blocks_;
  bool is_finalized_;
  MdfData& data_;
  bool pieces_are_one_{true};  ///< What was kept stands in the file as it is.
};

/// From columns back to rows; what does not fill a row stands at the end as it is.
std::string transposed(const std::string& columns, std::size_t row_bytes) {
  const std::size_t rows = columns.size() / row_bytes;
  std::string bytes = columns;
  if (rows == 0) return bytes;  // the row's length may be anything then
  for (std::size_t column = 0; column < row_bytes; ++column) {
    for (std::size_t row = 0; row < rows; ++row) {
      bytes[row * row_bytes + column] = columns[column * rows + row];
    }
  }
  return bytes;
}

std::string inflated(std::string_view packed, std::uint64_t bytes, MdfLink at) {
  /// Deflate makes at most 1032 bytes of one.
  constexpr std::uint64_t largest_deflate_ratio = 1032;
  if (bytes / largest_deflate_ratio > packed.size()) {
    throw DataError(fmt::format("block ##DZ at byte {} states {} bytes, more than its {} can hold",
                                at, bytes, packed.size()));
  }
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> inflate(
      libdeflate_alloc_decompressor(), &libdeflate_free_decompressor);
  if (!inflate) throw std::bad_alloc();
  std::string unpacked(static_cast<std::size_t>(bytes), '\0');
  const libdeflate_result result = libdeflate_zlib_decompress(
      inflate.get(), packed.data(), packed.size(), unpacked.data(), unpacked.size(), nullptr);
  if (result != LIBDEFLATE_SUCCESS) {
    throw DataError(fmt::format("block ##DZ at byte {} is damaged: it cannot be unpacked", at));
  }
  return unpacked;
}

std::string DataBlocks::unpacked(const MdfBlock& block) {
  constexpr std::size_t fixed_bytes = 24;
  constexpr std::uint8_t deflate = 0;
  constexpr std::uint8_t transposed_deflate = 1;
  const std::uint8_t method = block.uint8(2);
  const std::uint32_t row_bytes = block.uint32(4);
  const std::uint64_t bytes = block.uint64(8);
  const std::uint64_t packed_bytes = block.uint64(16);
  if (block.data().substr(0, 2) != "DT") throw DataError("its data are stored by columns");
  if (method != deflate && method != transposed_deflate) {
    throw DataError(
        fmt::format("block ##DZ at byte {} is packed by method {}", block.at(), method));
  }
  const std::string_view packed = block.data().substr(std::min(fixed_bytes, block.data().size()));
  if (packed_bytes > packed.size()) {
    throw DataError(fmt::format("block ##DZ at byte {} is damaged: it states {} bytes and has {}",
                                block.at(), packed_bytes, packed.size()));
  }
  check_size(bytes);
  std::string unpacked = inflated(packed.substr(0, packed_bytes), bytes, block.at());
  if (method == deflate || row_bytes <= 1) return unpacked;
  return transposed(unpacked, row_bytes);
}

}  // namespace

void read_data(MdfBlocks& blocks, MdfLink link, bool is_finalized, MdfData& data) {
  DataBlocks reader(blocks, is_finalized, data);
  try {
    if (link != 0) reader.take(link);
  } catch (const DataError& error) {
    data.damage = error.what();
  }
  reader.finish();
}

}  // namespace tribolog::ingest::measurement
