#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/input_file.h"
#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/byte_order.h"
#include "ingest/measurement/mdf_blocks.h"
#include "ingest/measurement/mdf_channels.h"
#include "ingest/measurement/mdf_data.h"
#include "ingest/measurement/measured_log.h"
#include "ingest/measurement/measurement_readers.h"

namespace tribolog::ingest::measurement {
namespace {

constexpr std::size_t identification_bytes = 64;
constexpr const char* by_asammdf =
    "in a Python with asammdf (pip install asammdf): python3 -c \"import asammdf; "
    "asammdf.MDF('LOG').convert('4.10').save('LOG.mf4')\"";

/// The records of one group: of its own, one after the other; where they are mixed with those of
/// others, picked from them.
struct GroupRecords {
  std::string_view bytes;
  std::string picked;
};

class MdfReader {
 public:
  MdfReader(std::string_view bytes, const std::string& file)
      : blocks_(bytes, file), conversions_(blocks_), log_(file) {}

  std::vector<log::LogTable> read() && {
    read_identification();
    const MdfBlock header = blocks_.once(identification_bytes, {"##HD"});
    for (MdfLink link = header.link(0); link != 0;) {
      const MdfBlock group = blocks_.once(link, {"##DG"});
      read_data_group(group);
      link = group.link(0);
    }
    if (!is_finalized_) log_.note({"reading.not_finalized"});
    return std::move(log_).finish();
  }

 private:
  void read_identification();
  void read_data_group(const MdfBlock& block);
  std::vector<MdfGroup> groups_of(const MdfBlock& data_group);
  std::string pick_records(std::string_view bytes, std::size_t id_bytes,
                           const std::vector<MdfGroup>& groups,
                           std::vector<GroupRecords>& records) const;
  void add_table(const MdfGroup& group, std::string_view records, const MdfData& data,
                 const std::string& damage);
  bool add_column(const MdfChannel& channel, const MdfGroup& group, std::string_view records,
                  log::LogTable& table);

  MdfBlocks blocks_;
  MdfConversions conversions_;
  MeasuredLog log_;
  bool is_finalized_{true};
  std::size_t groups_{};
  std::uint64_t values_{};
  std::size_t word_bytes_{};
};

void MdfReader::read_identification() {
  const std::string_view start = blocks_.bytes().substr(0, identification_bytes);
  const std::string& file = blocks_.file();
  if (start.empty()) throw InputError({file, 0, 0}, {"file is empty", "", "", ""});
  if (!start.starts_with("MDF     ") && !start.starts_with("UnFinMF ")) {
    blocks_.refuse("is not an MDF file (byte 0)", in_quotes(start.substr(0, 8)), "'MDF     '");
  }
  if (start.size() < identification_bytes) {
    blocks_.refuse("file ends inside the first 64 bytes", fmt::format("{} bytes", start.size()));
  }
  is_finalized_ = start.starts_with("MDF ");
  if (start[8] == '4') return;
  throw InputError({file, 0, 0}, {"is MDF of another version (byte 8)",
                                  in_quotes(start.substr(8, 4)), "4.00 or later", by_asammdf});
}

std::vector<MdfGroup> MdfReader::groups_of(const MdfBlock& data_group) {
  std::vector<MdfGroup> groups;
  for (MdfLink link = data_group.link(1); link != 0;) {
    const MdfBlock block = blocks_.once(link, {"##CG"});
    groups.push_back(read_group(block, blocks_, conversions_));
    ++groups_;
    if (groups.back().name.empty()) groups.back().name = fmt::format("group_{}", groups_);
    link = block.link(0);
  }
  return groups;
}

void MdfReader::read_data_group(const MdfBlock& block) {
  const std::size_t id_bytes = block.uint8(0);
  if (id_bytes > 8 || (id_bytes & (id_bytes - 1)) != 0) {
    blocks_.refuse(fmt::format("damaged: record numbers of {} bytes in block ##DG at byte {}",
                               id_bytes, block.at()));
  }
  const std::vector<MdfGroup> groups = groups_of(block);
  if (groups.empty()) return;
  MdfData data;
  read_data(blocks_, block.link(2), is_finalized_, data);
  if (!data.cut.empty()) log_.note(data.cut);
  std::vector<GroupRecords> records(groups.size());
  std::string damage = data.damage;
  if (id_bytes == 0 && groups.size() > 1) {
    damage = "several channel groups share their records, which have no numbers to tell them apart";
  } else if (id_bytes == 0) {
    records.front().bytes = data.bytes;
  } else {
    const std::string found = pick_records(data.bytes, id_bytes, groups, records);
    if (damage.empty()) damage = found;
    for (GroupRecords& group : records) group.bytes = group.picked;
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    add_table(groups[i], records[i].bytes, data, damage);
  }
}

/// A record's number, of 1, 2, 4 or 8 bytes.
std::uint64_t record_id(std::string_view bytes, std::size_t at, std::size_t id_bytes) {
  std::uint64_t id = 0;
  for (std::size_t i = id_bytes; i-- > 0;)
    id = (id << 8) | static_cast<unsigned char>(bytes[at + i]);
  return id;
}

/// @return what is damaged; empty: nothing.
std::string MdfReader::pick_records(std::string_view bytes, std::size_t id_bytes,
                                    const std::vector<MdfGroup>& groups,
                                    std::vector<GroupRecords>& records) const {
  std::map<std::uint64_t, std::size_t> place_of;
  for (std::size_t i = 0; i < groups.size(); ++i) place_of.emplace(groups[i].record_id, i);
  std::size_t at = 0;
  while (bytes.size() - at >= id_bytes) {
    const std::uint64_t id = record_id(bytes, at, id_bytes);
    const auto found = place_of.find(id);
    if (found == place_of.end()) {
      return fmt::format(
          "record at byte {} of the data belongs to no channel group: its number is "
          "{}",
          at, id);
    }
    const MdfGroup& group = groups[found->second];
    std::size_t length = group.record_bytes();
    std::size_t start = at + id_bytes;
    if (group.holds_texts) {
      if (bytes.size() - start < 4) break;
      length = arrays::number_at<std::uint32_t>(bytes, start);
      start += 4;
    }
    if (length > bytes.size() - start) break;  // the file ends inside the record
    if (!group.channels.empty()) records[found->second].picked += bytes.substr(start, length);
    at = start + length;
  }
  return "";
}

void MdfReader::add_table(const MdfGroup& group, std::string_view records, const MdfData& data,
                          const std::string& damage) {
  for (const LeftOutChannel& channel : group.left_out) {
    log_.leave_out(group.name + "/" + channel.name, channel.reason);
  }
  const std::size_t stride = group.record_bytes();
  if (stride == 0 && !group.holds_texts) return log_.leave_out(group.name, "its records are empty");
  if (group.channels.empty()) return;
  const std::uint64_t there = records.size() / stride;
  const std::uint64_t rows = is_finalized_ ? std::min(there, group.records) : there;
  log::LogTable table;
  table.group = group.name;
  table.rows = static_cast<std::size_t>(rows);
  table.refusal = damage;
  if (rows == 0 && damage.empty()) return log_.leave_out(group.name, "it holds no records");
  if (is_finalized_ && there < group.records && data.cut.empty() && damage.empty()) {
    table.notes.push_back({"reading.fewer_records",
                           {{"group", in_quotes(group.name)},
                            {"records", static_cast<std::int64_t>(rows)},
                            {"stated", static_cast<double>(group.records)}}});
  }
  bool has_numbers = false;
  for (const MdfChannel& channel : group.channels) {
    const bool is_added = add_column(channel, group, records.substr(0, rows * stride), table);
    has_numbers = has_numbers || (is_added && !channel.is_master);
  }
  if (has_numbers || !damage.empty()) {
    log_.add(std::move(table));
  } else {
    log_.leave_out(group.name, "it has no channel of numbers but its master");
  }
}

/// The words that occur, in the order of the conversion.
void keep_words(const std::vector<std::string>& words, log::LogColumn& column) {
  std::vector<bool> occurs(words.size());
  for (const double value : column.values) {
    if (!std::isnan(value)) occurs[static_cast<std::size_t>(value)] = true;
  }
  std::vector<double> place(words.size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    place[i] = static_cast<double>(column.words.size());
    if (occurs[i]) column.words.push_back(words[i]);
  }
  for (double& value : column.values) {
    if (!std::isnan(value)) value = place[static_cast<std::size_t>(value)];
  }
}

/// @return false: it is left out, and said so.
bool MdfReader::add_column(const MdfChannel& channel, const MdfGroup& group,
                           std::string_view records, log::LogTable& table) {
  constexpr std::size_t most_word_bytes = std::size_t{1} << 24;
  if (table.rows > arrays::most_values - values_) {
    log_.leave_out(group.name + "/" + channel.name, "the file holds more than 2^31 numbers");
    return false;
  }
  values_ += table.rows;
  bool was_rounded = false;
  log::LogColumn column =
      column_of(channel.name, channel.unit,
                values_of(channel, records, group.record_bytes(), group.data_bytes, was_rounded));
  if (was_rounded) {
    table.notes.push_back({"reading.integers_rounded", {{"array", in_quotes(channel.name)}}});
  }
  const MdfConversion* const conversion = channel.conversion.conversion.get();
  if (conversion != nullptr && !conversion->words().empty()) {
    keep_words(conversion->words(), column);
    for (const std::string& word : column.words) word_bytes_ += word.size();
    if (column.words.empty() || word_bytes_ > most_word_bytes) {
      log_.leave_out(group.name + "/" + channel.name, "it holds texts");
      return false;
    }
    column.reading = log::ColumnReading::words;
  }
  table.columns.push_back(std::move(column));
  return true;
}

}  // namespace

std::vector<log::LogTable> parse_mdf(std::string_view bytes, const std::string& file) {
  return MdfReader(bytes, file).read();
}

std::vector<log::LogTable> read_mdf(const std::string& path) {
  return parse_mdf(read_file(path), path);
}

}  // namespace tribolog::ingest::measurement
