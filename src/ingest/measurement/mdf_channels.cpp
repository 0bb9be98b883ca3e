#include "ingest/measurement/mdf_channels.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/closest_match.h"

namespace tribolog::ingest::measurement {
namespace {

/// As cn_type states them.
enum class ChannelType : std::uint8_t {
  fixed_length = 0,
  variable_length = 1,
  master = 2,
  virtual_master = 3,
  synchronization = 4,
  largest_length = 5,
  virtual_data = 6,
};

constexpr std::uint8_t first_text_type = 6;
constexpr std::uint8_t last_text_type = 9;
constexpr std::uint32_t all_invalid = 1;
constexpr std::uint32_t has_invalid_bit = 2;

/// Places of links in a ##CN.
enum CnLink : std::size_t {
  cn_next = 0,
  cn_composition = 1,
  cn_name = 2,
  cn_conversion = 4,
  cn_unit = 6
};

bool is_text(std::uint8_t data_type) {
  return data_type >= first_text_type && data_type <= last_text_type;
}

[[noreturn]] void refuse_type(std::uint8_t data_type) {
  if (is_text(data_type)) throw UnreadChannel("it holds texts");
  if (data_type == 15 || data_type == 16) throw UnreadChannel("it holds complex numbers");
  throw UnreadChannel(fmt::format("it holds no numbers (data type {})", data_type));
}

MdfNumber number_of(std::uint8_t data_type) {
  if (data_type > 5) refuse_type(data_type);
  if (data_type >= 4) return MdfNumber::real;
  return data_type >= 2 ? MdfNumber::signed_integer : MdfNumber::unsigned_integer;
}

MdfField field_of(const MdfBlock& channel, const MdfGroup& group) {
  MdfField field;
  const std::uint8_t data_type = channel.uint8(2);
  field.number = number_of(data_type);
  field.is_big_endian = data_type % 2 == 1;
  field.bit = channel.uint8(3);
  field.byte = channel.uint32(4);
  field.bits = channel.uint32(8);
  const std::uint32_t flags = channel.uint32(12);
  field.invalid = channel.uint32(16);
  field.may_be_invalid = (flags & has_invalid_bit) != 0 && group.invalid_bytes > 0;
  if ((flags & all_invalid) != 0) throw UnreadChannel("all its values are marked as invalid");
  const bool is_width = field.number != MdfNumber::real
                            ? field.bits >= 1 && field.bits <= 64 && field.bit < 8
                            : (field.bits == 16 || field.bits == 32 || field.bits == 64);
  if (!is_width || (field.number == MdfNumber::real && field.bit != 0)) {
    throw UnreadChannel(
        fmt::format("it has numbers of {} bits from bit {} on", field.bits, field.bit));
  }
  if (field.byte > group.data_bytes || group.data_bytes - field.byte < field.bytes() ||
      (field.may_be_invalid && field.invalid / 8 >= group.invalid_bytes)) {
    throw UnreadChannel(fmt::format("it reaches beyond its record of {} bytes", group.data_bytes));
  }
  return field;
}

void refuse_composition(MdfLink composition, const MdfBlocks& blocks) {
  if (composition == 0) return;
  throw UnreadChannel(blocks.mark_at(composition) == "##CN" ? "it is a structure of channels"
                                                            : "it is an array");
}

/// @throw UnreadChannel
MdfChannel read_channel(const MdfBlock& block, const std::string& name, const MdfGroup& group,
                        MdfBlocks& blocks, MdfConversions& conversions) {
  constexpr std::uint8_t time = 1;
  MdfChannel channel;
  channel.name = name;
  refuse_composition(block.link(cn_composition), blocks);
  const auto type = static_cast<ChannelType>(block.uint8(0));
  channel.is_master = type == ChannelType::master || type == ChannelType::virtual_master;
  switch (type) {
    case ChannelType::fixed_length:
    case ChannelType::master:
      channel.field = field_of(block, group);
      break;
    case ChannelType::virtual_master:
    case ChannelType::virtual_data:
      break;
    case ChannelType::variable_length:
      throw UnreadChannel(is_text(block.uint8(2)) ? "it holds texts"
                                                  : "its values are of variable length");
    default:
      throw UnreadChannel(fmt::format("it is a channel of type {}", block.uint8(0)));
  }
  channel.conversion = conversions.conversion(block.link(cn_conversion));
  channel.unit = blocks.text(block.link(cn_unit));
  if (channel.unit.empty()) channel.unit = channel.conversion.unit;
  const bool is_time = channel.is_master && block.uint8(1) == time;
  if (channel.unit.empty() && is_time) channel.unit = "s";
  if (channel.conversion.conversion && !channel.conversion.conversion->words().empty()) {
    channel.unit.clear();
  }
  return channel;
}

/// Bits that channels share could make any amount of numbers out of few bytes. Some may be shared:
/// a word of status, and its bits.
class BitBudget {
 public:
  explicit BitBudget(const MdfGroup& group) : left_(most_times * 8 * group.data_bytes) {}

  /// @throw UnreadChannel
  void take(const MdfChannel& channel) {
    const std::uint64_t bits = channel.field ? channel.field->bits : 1;
    if (bits > left_) throw UnreadChannel("its bits are those of several other channels");
    left_ -= bits;
  }

 private:
  static constexpr std::uint64_t most_times = 4;
  std::uint64_t left_;
};

void read_channels(MdfLink link, MdfGroup& group, MdfBlocks& blocks, MdfConversions& conversions) {
  BitBudget budget(group);
  std::size_t count = 0;
  while (link != 0) {
    if (++count > most_mdf_channels) {
      blocks.refuse(fmt::format("more than {} channels in one group", most_mdf_channels));
    }
    const MdfBlock block = blocks.once(link, {"##CN"});
    std::string name = blocks.text(block.link(cn_name));
    if (name.empty()) name = fmt::format("channel {}", count);
    try {
      MdfChannel channel = read_channel(block, name, group, blocks, conversions);
      budget.take(channel);
      group.channels.push_back(std::move(channel));
    } catch (const UnreadChannel& error) {
      group.left_out.push_back({name, error.what()});
    }
    link = block.link(cn_next);
  }
}

}  // namespace

MdfGroup read_group(const MdfBlock& group, MdfBlocks& blocks, MdfConversions& conversions) {
  constexpr std::uint16_t variable_length = 1;
  constexpr std::uint16_t remote_master = 8;
  MdfGroup read;
  read.name = blocks.text(group.link(2));
  read.record_id = group.uint64(0);
  read.records = group.uint64(8);
  const std::uint16_t flags = group.uint16(16);
  read.holds_texts = (flags & variable_length) != 0;
  if (read.holds_texts) return read;
  read.data_bytes = group.uint32(24);
  read.invalid_bytes = group.uint32(28);
  read_channels(group.link(1), read, blocks, conversions);
  if ((flags & remote_master) != 0) {
    for (const MdfChannel& channel : read.channels) {
      read.left_out.push_back({channel.name, "its data are stored by columns"});
    }
    read.channels.clear();
  }
  std::stable_partition(read.channels.begin(), read.channels.end(),
                        [](const MdfChannel& channel) { return channel.is_master; });
  return read;
}

}  // namespace tribolog::ingest::measurement
