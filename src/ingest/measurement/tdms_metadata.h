#pragma once
// What a segment of a TDMS file says of its objects: groups and channels, their properties, and
// where each has its raw data.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog::ingest::measurement {

/// As tdsTypeXXX number them.
enum class TdmsType : std::uint32_t {
  none = 0,
  int8 = 1,
  int16 = 2,
  int32 = 3,
  int64 = 4,
  uint8 = 5,
  uint16 = 6,
  uint32 = 7,
  uint64 = 8,
  float32 = 9,
  float64 = 10,
  extended = 11,
  float32_with_unit = 0x19,
  float64_with_unit = 0x1a,
  extended_with_unit = 0x1b,
  text = 0x20,
  boolean = 0x21,
  timestamp = 0x44,
  fixed_point = 0x4f,
  complex32 = 0x08000c,
  complex64 = 0x10000d,
};

/// In bytes, of a value among raw data; 0: not known, or not the same for all.
std::size_t size_of(TdmsType type);
/// "complex numbers", for messages.
std::string name_of(TdmsType type);
/// Whether it is read as a number.
bool is_number(TdmsType type);

/// A value of a property. Times and what is no number stand in the text as their bytes do.
struct TdmsValue {
  std::optional<double> number;
  std::string text;
};
using TdmsProperties = std::map<std::string, TdmsValue, std::less<>>;

std::optional<double> number_of(const TdmsProperties& properties, std::string_view name);
std::string text_of(const TdmsProperties& properties, std::string_view name);

/// How one chunk holds an object's values.
struct TdmsRawIndex {
  TdmsType type{};
  std::uint64_t values{};
  std::uint64_t bytes{};  ///< Of them all.
};

/// An object as one segment describes it.
struct TdmsObject {
  enum class RawData : std::uint8_t { none, as_before, stated, daqmx };
  std::string path;  ///< "/'group'/'channel'"
  RawData raw_data{};
  TdmsRawIndex index{};  ///< Where it is stated.
  TdmsProperties properties;
};

/// @param byte of the file where the metadata start, for messages.
/// @throw InputError: they end inside an object, or state what cannot be.
std::vector<TdmsObject> read_objects(std::string_view metadata, bool is_big_endian,
                                     std::uint64_t byte, const std::string& file);

/// Group and channel; both empty: the file itself; no channel: a group.
struct TdmsPath {
  std::string group;
  std::string channel;
};
/// @return nothing for a text that is no path.
std::optional<TdmsPath> path_of(std::string_view text);

}  // namespace tribolog::ingest::measurement
