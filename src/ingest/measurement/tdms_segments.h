#pragma once
// The segments of a TDMS file, one after the other, and the values of its channels.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/statement.h"
#include "ingest/measurement/tdms_metadata.h"
#include "ingest/measurement/tdms_values.h"

namespace tribolog::ingest::measurement {

/// What all segments of a file say of one object.
struct TdmsChannel {
  TdmsPath path;
  TdmsProperties properties;
  std::optional<TdmsRawIndex> index;  ///< The last one that was stated.
  /// Of its numbers; of timestamps s from the first one. Empty where the type is no number.
  std::vector<double> values;
  std::optional<TdmsTime> first_time;
  std::optional<TdmsType> other;  ///< Of what stands there that is no number, or no such one.
  bool was_rounded{};             ///< Holds integers of 2^53 and more.
};

struct TdmsFile {
  std::vector<TdmsChannel> objects;  ///< In the order in which they occur; groups too.
  std::vector<Statement> notes;      ///< What is missing at the end.
};

/// @throw InputError: no TDMS file, or its index alone; a segment that contradicts itself; raw data
///        of DAQmx; more than 2^31 numbers.
TdmsFile read_segments(std::string_view bytes, const std::string& file);

}  // namespace tribolog::ingest::measurement
