#include <cmath>
#include <compare>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/closest_match.h"
#include "base/input_file.h"
#include "ingest/log/units.h"
#include "ingest/measurement/measured_log.h"
#include "ingest/measurement/measurement_readers.h"
#include "ingest/measurement/tdms_scaling.h"
#include "ingest/measurement/tdms_segments.h"

namespace tribolog::ingest::measurement {
namespace {

/// Of a channel's waveform, by whose properties its values come one after the other.
struct WaveformClock {
  double offset_s{};
  double increment_s{};
  std::string start;  ///< The bytes of wf_start_time; empty: not stated.
  friend auto operator<=>(const WaveformClock&, const WaveformClock&) = default;
};

std::optional<WaveformClock> clock_of(const TdmsProperties& properties) {
  const auto increment = number_of(properties, "wf_increment");
  const double offset = number_of(properties, "wf_start_offset").value_or(0);
  if (!increment || !(*increment > 0) || !std::isfinite(*increment) || !std::isfinite(offset)) {
    return std::nullopt;
  }
  // A spectrum has its frequencies there.
  const std::string unit = text_of(properties, "wf_xunit_string");
  if (!unit.empty() && !log::find_si_factor(log::Quantity::time, unit)) return std::nullopt;
  const double factor = unit.empty() ? 1 : *log::find_si_factor(log::Quantity::time, unit);
  return WaveformClock{factor * offset, factor * *increment, text_of(properties, "wf_start_time")};
}

bool is_time(const TdmsChannel& channel) {
  const std::string unit = text_of(channel.properties, "unit_string");
  std::string name = channel.path.channel.substr(0, 4);
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return channel.first_time || name == "time" || name == "t" ||
         (!unit.empty() && log::find_si_factor(log::Quantity::time, unit));
}

/// Which channels of a group share their rows.
struct TableKey {
  std::size_t rows{};
  std::optional<WaveformClock> clock;  ///< Absent: none, or one of the channels is the clock.
  friend auto operator<=>(const TableKey&, const TableKey&) = default;
};

struct ChannelTable {
  TableKey key;
  std::vector<TdmsChannel*> channels;
};

class TdmsTables {
 public:
  TdmsTables(TdmsFile found, const std::string& file) : found_(std::move(found)), log_(file) {
    for (const TdmsChannel& object : found_.objects) {
      if (object.path.channel.empty()) group_properties_[object.path.group] = &object.properties;
    }
  }

  std::vector<log::LogTable> read() && {
    for (const Statement& note : found_.notes) log_.note(note);
    std::vector<std::string> groups;
    std::map<std::string, std::vector<TdmsChannel*>> channels_of;
    for (TdmsChannel& object : found_.objects) {
      if (object.path.channel.empty()) continue;
      const std::string& group = object.path.group;
      if (channels_of[group].empty()) groups.push_back(group);
      channels_of[group].push_back(&object);
    }
    for (const std::string& group : groups) add_group(group, channels_of[group]);
    return std::move(log_).finish();
  }

 private:
  void add_group(const std::string& group, const std::vector<TdmsChannel*>& channels);
  void add_table(const std::string& name, ChannelTable& table);
  bool is_readable(TdmsChannel& channel);
  void scale_values(TdmsChannel& channel) const;
  [[nodiscard]] const TdmsProperties* properties_of(const std::string& group) const {
    const auto found = group_properties_.find(group);
    return found == group_properties_.end() ? nullptr : found->second;
  }

  TdmsFile found_;
  std::map<std::string, const TdmsProperties*> group_properties_;  ///< The file's own under "".
  MeasuredLog log_;
};

/// @return false: it is left out, and said so.
bool TdmsTables::is_readable(TdmsChannel& channel) {
  const std::string name = channel.path.group + "/" + channel.path.channel;
  if (channel.other) {
    log_.leave_out(name, "it holds " + name_of(*channel.other));
    return false;
  }
  if (channel.values.empty()) {
    log_.leave_out(name, "it holds no values");
    return false;
  }
  try {
    scale_values(channel);
  } catch (const UnreadChannel& error) {
    log_.leave_out(name, error.what());
    return false;
  }
  return true;
}

/// By the scales of the channel, else of its group, else of the file.
void TdmsTables::scale_values(TdmsChannel& channel) const {
  for (const TdmsProperties* const properties :
       {static_cast<const TdmsProperties*>(&channel.properties), properties_of(channel.path.group),
        properties_of("")}) {
    if (properties == nullptr) continue;
    const auto scaling = read_scaling(*properties);
    if (!scaling) continue;
    return scale(*scaling, channel.values);
  }
}

void TdmsTables::add_group(const std::string& group, const std::vector<TdmsChannel*>& channels) {
  std::vector<TdmsChannel*> readable;
  std::map<std::size_t, bool> has_time;
  for (TdmsChannel* const channel : channels) {
    if (!is_readable(*channel)) continue;
    readable.push_back(channel);
    bool& has = has_time[channel->values.size()];
    has = has || is_time(*channel);
  }
  std::vector<ChannelTable> tables;
  std::map<TableKey, std::size_t> place_of;
  for (TdmsChannel* const channel : readable) {
    const std::size_t rows = channel->values.size();
    const TableKey key{rows, has_time[rows] ? std::nullopt : clock_of(channel->properties)};
    const auto [known, is_new] = place_of.emplace(key, tables.size());
    if (is_new) tables.push_back({key, {}});
    tables[known->second].channels.push_back(channel);
  }
  for (ChannelTable& table : tables) {
    const std::string first = table.channels.front()->path.channel;
    add_table(tables.size() == 1 ? group : group + "/" + first, table);
  }
}

void TdmsTables::add_table(const std::string& name, ChannelTable& table) {
  log::LogTable added;
  added.group = name;
  added.rows = table.key.rows;
  if (table.key.clock) {
    std::vector<double> times(added.rows);
    for (std::size_t row = 0; row < times.size(); ++row) {
      times[row] =
          table.key.clock->offset_s + static_cast<double>(row) * table.key.clock->increment_s;
    }
    added.columns.push_back(column_of("time", "s", std::move(times)));
  }
  for (TdmsChannel* const channel : table.channels) {
    const std::string& channel_name = channel->path.channel;
    const std::string unit =
        channel->first_time ? "s" : text_of(channel->properties, "unit_string");
    if (channel->was_rounded) {
      added.notes.push_back({"reading.integers_rounded", {{"array", in_quotes(channel_name)}}});
    }
    added.columns.push_back(column_of(channel_name, unit, std::move(channel->values)));
  }
  log_.add(std::move(added));
}

}  // namespace

std::vector<log::LogTable> parse_tdms(std::string_view bytes, const std::string& file) {
  return TdmsTables(read_segments(bytes, file), file).read();
}

std::vector<log::LogTable> read_tdms(const std::string& path) {
  return parse_tdms(read_file(path), path);
}

}  // namespace tribolog::ingest::measurement
