#include "ingest/measurement/tdms_segments.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/byte_order.h"

namespace tribolog::ingest::measurement {
namespace {

constexpr std::size_t lead_in_bytes = 28;
constexpr const char* by_nptdms =
    "in a Python with npTDMS and pandas (pip install npTDMS pandas): python3 -c \"import nptdms; "
    "nptdms.TdmsFile.read('LOG').as_dataframe(time_index=True).to_csv('LOG.csv')\"";

/// Bits of a segment's table of contents.
enum Contents : std::uint32_t {
  has_metadata = 1U << 1,
  has_new_list = 1U << 2,
  has_raw_data = 1U << 3,
  is_interleaved = 1U << 5,
  is_in_big_endian = 1U << 6,
  has_daqmx_data = 1U << 7,
};

struct Segment {
  std::uint64_t byte{};
  std::uint32_t contents{};
  std::string_view metadata;
  std::string_view raw_data;
  bool is_cut{};  ///< The file ends inside it, or it was not closed.

  [[nodiscard]] bool is_big_endian() const { return (contents & is_in_big_endian) != 0; }
};

class Segments {
 public:
  Segments(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  TdmsFile read() && {
    check_start();
    while (!is_end_) take_segment();
    return std::move(found_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& found = {},
                           const std::string& expected = {}, const std::string& hint = {}) const {
    throw InputError({file_, 0, 0}, {what, found, expected, hint});
  }
  [[noreturn]] void refuse_daqmx() const {
    refuse("holds raw data of DAQmx, which are not read", "", "", by_nptdms);
  }

  void check_start() const;
  void take_segment();
  Segment segment_at(std::uint64_t at);
  void take_objects(const Segment& segment);
  void take_object(TdmsObject object);
  void set_active(std::size_t object, const TdmsRawIndex& index);
  void set_idle(std::size_t object);
  void take_raw_data(const Segment& segment);
  std::uint64_t take_chunks(const Segment& segment);
  std::uint64_t take_rows(const Segment& segment);
  void take_values(std::size_t object, const TdmsRawIndex& index, std::string_view bytes,
                   std::size_t stride, bool is_big_endian);
  void note_cut(const std::string& record, std::uint64_t byte, std::uint64_t expected,
                std::uint64_t got) {
    found_.notes.push_back(
        {"reading.truncated",
         {{"record", record}, {"byte", byte}, {"expected", expected}, {"got", got}}});
  }

  std::string_view bytes_;
  const std::string& file_;
  TdmsFile found_;
  std::uint64_t at_{};
  bool is_end_{};
  std::unordered_map<std::string, std::size_t> place_of_;  ///< Of an object, by its path.
  /// Objects with raw data in the segments from here on, in the order of the list that they are
  /// in: those without take no time.
  std::map<std::size_t, std::pair<std::size_t, TdmsRawIndex>> active_;
  std::unordered_map<std::size_t, std::size_t> order_of_;  ///< In that list, by object.
  std::uint64_t chunk_bytes_{};                            ///< Of those together.
  std::uint64_t row_bytes_{};
  std::uint64_t values_{};
};

void Segments::check_start() const {
  const std::string_view start = bytes_.substr(0, 4);
  if (start.empty()) refuse("file is empty");
  if (start == "TDSh") {
    refuse("is the index of a TDMS file", "", "the log itself", "name the .tdms file beside it");
  }
  if (start != std::string_view("TDSm").substr(0, start.size())) {
    refuse("is not a TDMS file (byte 0)", in_quotes(start), "'TDSm'");
  }
}

Segment Segments::segment_at(std::uint64_t at) {
  constexpr std::uint64_t not_closed = ~std::uint64_t{0};
  const std::string_view rest = bytes_.substr(at);
  Segment segment;
  segment.byte = at;
  segment.contents = arrays::number_at<std::uint32_t>(rest, 4);
  const bool is_big = segment.is_big_endian();
  const auto version = arrays::number_at<std::uint32_t>(rest, 8, is_big);
  if (version != 4712 && version != 4713) {
    refuse(fmt::format("is TDMS of another version (byte {})", at + 8), fmt::format("{}", version),
           "4712 or 4713");
  }
  std::uint64_t length = arrays::number_at<std::uint64_t>(rest, 12, is_big);
  const auto raw_at = arrays::number_at<std::uint64_t>(rest, 20, is_big);
  const std::uint64_t there = rest.size() - lead_in_bytes;
  segment.is_cut = length > there;
  if (length == not_closed) {
    found_.notes.push_back({"reading.segment_not_closed", {{"byte", at}}});
  } else if (segment.is_cut) {
    note_cut("segment", at, length + lead_in_bytes, rest.size());
  }
  length = std::min(length, there);
  if (raw_at > length && !segment.is_cut) {
    refuse(fmt::format("damaged: the segment at byte {} ends before its raw data start", at));
  }
  segment.metadata = rest.substr(lead_in_bytes, std::min(raw_at, length));
  segment.raw_data =
      rest.substr(lead_in_bytes + segment.metadata.size(), length - segment.metadata.size());
  if (raw_at > length) segment.contents = 0;  // nothing can be read of half the metadata
  is_end_ = segment.is_cut;
  at_ = at + lead_in_bytes + length;
  return segment;
}

void Segments::take_segment() {
  const std::string_view rest = bytes_.substr(at_);
  if (rest.empty()) {
    is_end_ = true;
    return;
  }
  if (rest.size() < lead_in_bytes) {
    note_cut("the start of a segment", at_, lead_in_bytes, rest.size());
    is_end_ = true;
    return;
  }
  if (!rest.starts_with("TDSm")) {
    refuse(fmt::format("damaged: no segment starts at byte {}", at_), in_quotes(rest.substr(0, 4)),
           "'TDSm'");
  }
  const Segment segment = segment_at(at_);
  if ((segment.contents & has_daqmx_data) != 0) refuse_daqmx();
  if ((segment.contents & has_metadata) != 0) take_objects(segment);
  if ((segment.contents & has_raw_data) != 0) take_raw_data(segment);
}

void Segments::take_objects(const Segment& segment) {
  if ((segment.contents & has_new_list) != 0) {
    active_.clear();
    order_of_.clear();
    chunk_bytes_ = row_bytes_ = 0;
  }
  for (TdmsObject& object : read_objects(segment.metadata, segment.is_big_endian(),
                                         segment.byte + lead_in_bytes, file_)) {
    take_object(std::move(object));
  }
}

void Segments::take_object(TdmsObject object) {
  const auto [known, is_new] = place_of_.emplace(object.path, found_.objects.size());
  const std::size_t place = known->second;
  if (is_new) {
    const auto path = path_of(object.path);
    if (!path) refuse("damaged: " + in_quotes(object.path) + " is no path of an object");
    found_.objects.push_back({*path, {}, {}, {}, {}, {}, {}});
  }
  TdmsChannel& channel = found_.objects[place];
  for (auto& [name, value] : object.properties) channel.properties[name] = std::move(value);
  order_of_.emplace(place, order_of_.size());
  switch (object.raw_data) {
    case TdmsObject::RawData::none:
      return set_idle(place);
    case TdmsObject::RawData::daqmx:
      refuse_daqmx();
    case TdmsObject::RawData::stated:
      channel.index = object.index;
      break;
    case TdmsObject::RawData::as_before:
      if (!channel.index) {
        refuse("damaged: " + in_quotes(object.path) + " is stored as before, and was not before");
      }
      break;
  }
  set_active(place, *channel.index);
}

void Segments::set_idle(std::size_t object) {
  const auto known = active_.find(order_of_.at(object));
  if (known == active_.end()) return;
  const TdmsRawIndex& index = known->second.second;
  chunk_bytes_ -= index.bytes;
  row_bytes_ -= size_of(index.type);
  active_.erase(known);
}

void Segments::set_active(std::size_t object, const TdmsRawIndex& index) {
  set_idle(object);
  if (index.bytes == 0) return;
  active_.emplace(order_of_.at(object), std::pair{object, index});
  chunk_bytes_ += index.bytes;
  row_bytes_ += size_of(index.type);
}

void Segments::take_raw_data(const Segment& segment) {
  if (segment.raw_data.empty()) return;
  if (active_.empty()) {
    refuse(fmt::format("damaged: the segment at byte {} has raw data of no channel", segment.byte));
  }
  const bool is_by_rows = (segment.contents & is_interleaved) != 0;
  const std::uint64_t taken = is_by_rows ? take_rows(segment) : take_chunks(segment);
  if (taken == segment.raw_data.size()) return;
  const auto byte = static_cast<std::uint64_t>(segment.raw_data.data() - bytes_.data()) + taken;
  note_cut(is_by_rows ? "row of channels" : "chunk of raw data", byte,
           is_by_rows ? row_bytes_ : chunk_bytes_, segment.raw_data.size() - taken);
}

std::uint64_t Segments::take_chunks(const Segment& segment) {
  std::uint64_t at = 0;
  while (segment.raw_data.size() - at >= chunk_bytes_) {
    for (const auto& [order, entry] : active_) {
      const auto& [object, index] = entry;
      take_values(object, index, segment.raw_data.substr(at, index.bytes), size_of(index.type),
                  segment.is_big_endian());
      at += index.bytes;
    }
  }
  return at;
}

std::uint64_t Segments::take_rows(const Segment& segment) {
  const std::uint64_t values = active_.begin()->second.second.values;
  const std::uint64_t rows = row_bytes_ == 0 ? 0 : segment.raw_data.size() / row_bytes_;
  if (rows == 0) return 0;
  std::uint64_t at = 0;
  for (const auto& [order, entry] : active_) {
    const auto& [object, index] = entry;
    const std::size_t size = size_of(index.type);
    if (index.values != values || size == 0) {
      refuse(
          fmt::format("damaged: the channels of the segment at byte {} take turns, and are not "
                      "of one length",
                      segment.byte));
    }
    take_values(object, index, segment.raw_data.substr(at, (rows - 1) * row_bytes_ + size),
                row_bytes_, segment.is_big_endian());
    at += size;
  }
  return rows * row_bytes_;
}

/// @param bytes from the first value to the end of the last one. @param stride from one to the
/// next.
void Segments::take_values(std::size_t object, const TdmsRawIndex& index, std::string_view bytes,
                           std::size_t stride, bool is_big_endian) {
  TdmsChannel& channel = found_.objects[object];
  const bool is_timestamp = index.type == TdmsType::timestamp;
  const bool is_mixed = !channel.values.empty() && is_timestamp != channel.first_time.has_value();
  if (!is_number(index.type) || is_mixed) channel.other = index.type;
  if (channel.other) return;
  const std::size_t count = (bytes.size() + stride - size_of(index.type)) / stride;
  if (count > arrays::most_values - values_) refuse("more than 2^31 numbers in one file");
  values_ += count;
  for (std::size_t i = 0; i < count; ++i) {
    const char* const at = bytes.data() + i * stride;
    if (is_timestamp) {
      const TdmsTime time = tdms_time(at, is_big_endian);
      if (!channel.first_time) channel.first_time = time;
      channel.values.push_back(seconds_between(*channel.first_time, time));
      continue;
    }
    channel.values.push_back(tdms_number(index.type, at, is_big_endian));
    const bool is_wide = index.type == TdmsType::int64 || index.type == TdmsType::uint64;
    channel.was_rounded = channel.was_rounded || (is_wide && std::abs(channel.values.back()) >=
                                                                 arrays::first_rounded_integer);
  }
}

}  // namespace

TdmsFile read_segments(std::string_view bytes, const std::string& file) {
  return Segments(bytes, file).read();
}

}  // namespace tribolog::ingest::measurement
