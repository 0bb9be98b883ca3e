#include "ingest/measurement/tdms_metadata.h"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "base/utf8.h"
#include "ingest/arrays/byte_order.h"
#include "ingest/measurement/tdms_values.h"

namespace tribolog::ingest::measurement {

std::size_t size_of(TdmsType type) {
  switch (type) {
    case TdmsType::int8:
    case TdmsType::uint8:
    case TdmsType::boolean:
      return 1;
    case TdmsType::int16:
    case TdmsType::uint16:
      return 2;
    case TdmsType::int32:
    case TdmsType::uint32:
    case TdmsType::float32:
    case TdmsType::float32_with_unit:
      return 4;
    case TdmsType::int64:
    case TdmsType::uint64:
    case TdmsType::float64:
    case TdmsType::float64_with_unit:
    case TdmsType::complex32:
      return 8;
    case TdmsType::timestamp:
    case TdmsType::complex64:
      return 16;
    default:
      return 0;
  }
}

std::string name_of(TdmsType type) {
  switch (type) {
    case TdmsType::text:
      return "texts";
    case TdmsType::complex32:
    case TdmsType::complex64:
      return "complex numbers";
    case TdmsType::extended:
    case TdmsType::extended_with_unit:
      return "extended numbers";
    case TdmsType::fixed_point:
      return "fixed-point numbers";
    case TdmsType::timestamp:
      return "timestamps beside other values";
    default:
      return fmt::format("values of type {:#x}", static_cast<std::uint32_t>(type));
  }
}

bool is_number(TdmsType type) {
  return size_of(type) > 0 && type != TdmsType::complex32 && type != TdmsType::complex64;
}

std::optional<double> number_of(const TdmsProperties& properties, std::string_view name) {
  const auto found = properties.find(name);
  return found == properties.end() ? std::nullopt : found->second.number;
}

std::string text_of(const TdmsProperties& properties, std::string_view name) {
  const auto found = properties.find(name);
  return found == properties.end() ? "" : found->second.text;
}

namespace {

/// Longest name of a group, a channel or a unit.
constexpr std::size_t longest_name = 1024;

/// Values whose size is not known: nothing behind them can be found.
class UnknownSize : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The metadata of one segment, from their start on.
class Metadata {
 public:
  Metadata(std::string_view bytes, bool is_big_endian, std::uint64_t byte, const std::string& file)
      : rest_(bytes), all_(bytes.size()), is_big_endian_(is_big_endian), byte_(byte), file_(file) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError({file_, 0, 0}, {fmt::format("damaged: the metadata at byte {} {}",
                                                 byte_ + all_ - rest_.size(), what),
                                     "", "", ""});
  }
  std::string_view take(std::uint64_t bytes) {
    if (bytes > rest_.size()) refuse("end inside an object");
    const std::string_view taken = rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    return taken;
  }
  template <class Number>
  Number number() {
    return arrays::number_at<Number>(take(sizeof(Number)), 0, is_big_endian_);
  }
  std::string text() {
    const std::string_view bytes = take(number<std::uint32_t>());
    return first_broken_utf8(bytes) ? utf8_of_latin1(bytes) : std::string(bytes);
  }
  [[nodiscard]] std::size_t left() const { return rest_.size(); }
  [[nodiscard]] bool is_big_endian() const { return is_big_endian_; }

 private:
  std::string_view rest_;
  std::size_t all_;
  bool is_big_endian_;
  std::uint64_t byte_;
  const std::string& file_;
};

TdmsValue read_value(Metadata& metadata) {
  const auto type = static_cast<TdmsType>(metadata.number<std::uint32_t>());
  if (type == TdmsType::text) return {std::nullopt, metadata.text()};
  if (type == TdmsType::none) return {};
  const std::size_t size = size_of(type);
  if (size == 0) metadata.refuse("have a property of " + name_of(type));
  const std::string_view bytes = metadata.take(size);
  if (!is_number(type) || type == TdmsType::timestamp) return {std::nullopt, std::string(bytes)};
  return {tdms_number(type, bytes.data(), metadata.is_big_endian()), ""};
}

/// Those of the waveform, the unit and the scales: others say nothing of numbers.
bool is_wanted(std::string_view name) {
  return name.starts_with("wf_") || name.starts_with("NI_") || name == "unit_string";
}

void read_properties(Metadata& metadata, TdmsProperties& properties) {
  const auto count = metadata.number<std::uint32_t>();
  constexpr std::size_t least_bytes = 8;
  if (count > metadata.left() / least_bytes) metadata.refuse("state more properties than it holds");
  for (std::uint32_t i = 0; i < count; ++i) {
    std::string name = metadata.text();
    TdmsValue value = read_value(metadata);
    if (value.text.size() <= longest_name && is_wanted(name)) {
      properties[std::move(name)] = std::move(value);
    }
  }
}

/// What follows the length of a raw data index.
TdmsRawIndex read_index(Metadata& metadata) {
  constexpr std::uint64_t most_values = std::uint64_t{1} << 31;
  constexpr std::uint64_t most_text_bytes = std::uint64_t{1} << 35;
  TdmsRawIndex index;
  index.type = static_cast<TdmsType>(metadata.number<std::uint32_t>());
  const auto dimensions = metadata.number<std::uint32_t>();
  index.values = metadata.number<std::uint64_t>();
  if (dimensions != 1) metadata.refuse(fmt::format("state {} dimensions, not 1", dimensions));
  if (index.values > most_values) {
    metadata.refuse(fmt::format("state {} values in one chunk, more than 2^31", index.values));
  }
  if (index.type == TdmsType::text) {
    index.bytes = metadata.number<std::uint64_t>();
    if (index.bytes > most_text_bytes) metadata.refuse("state more than 32 GiB of text");
  } else if (size_of(index.type) == 0) {
    throw UnknownSize(name_of(index.type));
  } else {
    index.bytes = index.values * size_of(index.type);
  }
  return index;
}

void read_raw_data(Metadata& metadata, TdmsObject& object) {
  constexpr std::uint32_t no_data = 0xffffffffU;
  constexpr std::uint32_t as_before = 0;
  constexpr std::uint32_t changing_format = 0x1269;
  constexpr std::uint32_t digital_line = 0x1369;
  constexpr std::uint32_t digital_line_as_well = 0x126a;
  const auto length = metadata.number<std::uint32_t>();
  if (length == no_data) return;
  object.raw_data = TdmsObject::RawData::as_before;
  if (length == as_before) return;
  if (length == changing_format || length == digital_line || length == digital_line_as_well) {
    object.raw_data = TdmsObject::RawData::daqmx;
    return;
  }
  object.raw_data = TdmsObject::RawData::stated;
  object.index = read_index(metadata);
}

}  // namespace

std::vector<TdmsObject> read_objects(std::string_view metadata, bool is_big_endian,
                                     std::uint64_t byte, const std::string& file) {
  Metadata reader(metadata, is_big_endian, byte, file);
  const auto count = reader.number<std::uint32_t>();
  constexpr std::size_t least_bytes = 12;
  if (count > reader.left() / least_bytes) reader.refuse("state more objects than they hold");
  std::vector<TdmsObject> objects;
  for (std::uint32_t i = 0; i < count; ++i) {
    TdmsObject& object = objects.emplace_back();
    object.path = reader.text();
    if (object.path.size() > 2 * longest_name) reader.refuse("have a name of more than 2048 bytes");
    try {
      read_raw_data(reader, object);
    } catch (const UnknownSize& unknown) {
      reader.refuse(fmt::format("state that {} holds {}, whose size is not known",
                                in_quotes(object.path), unknown.what()));
    }
    if (object.raw_data == TdmsObject::RawData::daqmx) return objects;
    read_properties(reader, object.properties);
  }
  return objects;
}

namespace {

/// One part of a path, "'Tom''s'", from its quote on; what was read is taken off the text.
std::optional<std::string> take_part(std::string_view& text) {
  if (!text.starts_with("/'")) return std::nullopt;
  text.remove_prefix(2);
  std::string part;
  while (!text.empty()) {
    const char c = text.front();
    text.remove_prefix(1);
    if (c != '\'') {
      part += c;
    } else if (text.starts_with('\'')) {
      part += c;
      text.remove_prefix(1);
    } else {
      return part;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<TdmsPath> path_of(std::string_view text) {
  TdmsPath path;
  if (text == "/") return path;
  const auto group = take_part(text);
  if (!group) return std::nullopt;
  path.group = *group;
  if (text.empty()) return path;
  const auto channel = take_part(text);
  if (!channel || !text.empty()) return std::nullopt;
  path.channel = *channel;
  return path;
}

}  // namespace tribolog::ingest::measurement
