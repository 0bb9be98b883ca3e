#pragma once
// Files of measurement systems: ASAM MDF 4 (`.mf4`) and TDMS of National Instruments (`.tdms`).

#include <string>
#include <string_view>
#include <vector>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::measurement {

// Tables from an ASAM MDF 4 file (https://www.asam.net/standards/detail/mdf).
//
// Read: fixed-length channels of integers of 1 to 64 bits and floats of 16, 32 and 64, in either
// byte order, sorted or not, stored or deflated (transposed or not), in one block or in lists of
// blocks; invalidation bits (gaps); conversions by a line, a rational function, tables and ranges
// of values; texts that a conversion gives are words. Left out with a reason: texts, arrays,
// structures, formulas. A file that is cut off, or was not finalized, gives the records that stand
// in it, and a note says so. Memory: the file, one data group unpacked, and the tables.

/// One table for each channel group with records, named after the group: the master's values come
/// first, in s where it is a time. Of a data group that is damaged the tables are refused.
/// @throw InputError naming the file: it is no MDF 4 file (of an older one it says what converts
///        it), its blocks contradict each other, or no channel can be read.
std::vector<log::LogTable> read_mdf(const std::string& path);
/// The same from memory. @param file its name, for messages.
std::vector<log::LogTable> parse_mdf(std::string_view bytes, const std::string& file);

// Tables from a TDMS file (https://www.ni.com/tdms, "TDMS File Format Internal Structure").
//
// Read: integers, floats (with unit or without), booleans and timestamps, contiguous or
// interleaved, in either byte order, in any number of segments and chunks; linear and polynomial
// scales. Left out with a reason: texts, complex and extended numbers, other scales. A file that
// is cut off, or whose last segment was not closed, gives all its complete chunks, and a note says
// what is missing. Memory: the file and the tables.

/// One table for each group whose channels are of one length, named after the group; of channels of
/// other lengths, or with other clocks, a table of their own. Where none of a table's channels is
/// a time, `time` in s comes from the waveform's properties (wf_start_offset, wf_increment), where
/// there are such. A channel of timestamps counts in s from its first.
/// @throw InputError naming the file: it is no TDMS file, or its index alone; a segment is damaged;
///        raw data of DAQmx; no channel can be read.
std::vector<log::LogTable> read_tdms(const std::string& path);
/// The same from memory. @param file its name, for messages.
std::vector<log::LogTable> parse_tdms(std::string_view bytes, const std::string& file);

}  // namespace tribolog::ingest::measurement
