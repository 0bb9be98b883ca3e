#pragma once
// Logs in JSON: as Rhoban/bam writes them, objects of arrays, arrays of objects.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::arrays {

/// Largest JSON file that is read; in memory it takes several times its size.
inline constexpr std::uint64_t largest_json_bytes = std::uint64_t{256} << 20;

/// Tables of a JSON file by the rule of tables_of().
///
/// An array of objects gives one column for each key: `entries` of Rhoban/bam its `timestamp`,
/// `position`, `speed`, `load`, `input_volts`, `goal_position`, `torque_enable`. Where there are
/// several such arrays their names come in front ("run/position"). An array of numbers is a vector,
/// an array of equally long arrays of numbers a matrix; within objects "outer.inner". Booleans
/// count 0 and 1; null, NaN and Infinity (which Python writes) are gaps, as is a key that a row
/// lacks; a key in less than a sixteenth of the rows is left out. Single numbers (`mass`, `kp`) and
/// texts become notes.
/// @throw InputError: the file cannot be read, is no JSON (with line and column), names a key twice
///        in one object, or holds no rows of numbers.
std::vector<log::LogTable> read_bam_json(const std::string& path);

/// The same of a file's bytes. @param file its name, for messages.
std::vector<log::LogTable> parse_json_log(std::string_view bytes, const std::string& file);

}  // namespace tribolog::ingest::arrays
