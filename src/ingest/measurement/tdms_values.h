#pragma once
// Values of a TDMS file as doubles.

#include <cstdint>

#include "ingest/measurement/tdms_metadata.h"

namespace tribolog::ingest::measurement {

/// @param bytes size_of(type) of them; the type is a number, and no timestamp.
double tdms_number(TdmsType type, const char* bytes, bool is_big_endian);

/// Seconds since 1904 with a fraction in units of 2^-64 s.
struct TdmsTime {
  std::int64_t seconds{};
  std::uint64_t fraction{};
};
TdmsTime tdms_time(const char* bytes, bool is_big_endian);
/// In s; exact to the nanosecond where both are of one year.
double seconds_between(const TdmsTime& from, const TdmsTime& to);

}  // namespace tribolog::ingest::measurement
