#pragma once
// The channels (##CN) of a channel group (##CG): where in a record each has its bits, and how they
// become values.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ingest/measurement/mdf_blocks.h"
#include "ingest/measurement/mdf_conversion.h"

namespace tribolog::ingest::measurement {

/// What a channel's bits are.
enum class MdfNumber : std::uint8_t { unsigned_integer, signed_integer, real };

/// Its bits in a record, behind the record's number.
struct MdfField {
  MdfNumber number{};
  bool is_big_endian{};
  std::uint32_t byte{};     ///< First one.
  std::uint8_t bit{};       ///< First one of the integer that the bytes are, 0 to 7.
  std::uint32_t bits{};     ///< 1 to 64.
  std::uint32_t invalid{};  ///< Bit behind the record's data that makes a value a gap.
  bool may_be_invalid{};

  /// From the first byte to the last that holds a bit of it.
  [[nodiscard]] std::size_t bytes() const { return (bit + bits + 7) / 8; }
};

struct MdfChannel {
  std::string name;
  std::string unit;  ///< Of a time without one: "s".
  bool is_master{};
  /// Absent: a virtual channel, whose raw values count the records from 0.
  std::optional<MdfField> field;
  UnitConversion conversion;
};

/// A channel that is not read, and why.
struct LeftOutChannel {
  std::string name;
  std::string reason;
};

struct MdfGroup {
  std::string name;  ///< Of the acquisition; empty: none.
  std::uint64_t record_id{};
  std::uint64_t records{};  ///< As stated.
  bool holds_texts{};       ///< Its records are of variable length, each with its length in front.
  std::size_t data_bytes{};
  std::size_t invalid_bytes{};
  std::vector<MdfChannel> channels;  ///< The master first.
  std::vector<LeftOutChannel> left_out;

  [[nodiscard]] std::size_t record_bytes() const { return data_bytes + invalid_bytes; }
};

/// Most channels of one group, as columns of a text log.
inline constexpr std::size_t most_mdf_channels = 65'536;

/// @throw InputError as MdfBlocks::once(), and for more channels than that.
MdfGroup read_group(const MdfBlock& group, MdfBlocks& blocks, MdfConversions& conversions);

/// A channel's values in records that follow each other.
/// @param records so many as record_bytes() of the group divide; `stride` is that, at least 1.
/// @param was_rounded becomes true where an integer of 2^53 or more stands among them.
std::vector<double> values_of(const MdfChannel& channel, std::string_view records,
                              std::size_t stride, std::size_t data_bytes, bool& was_rounded);

}  // namespace tribolog::ingest::measurement
