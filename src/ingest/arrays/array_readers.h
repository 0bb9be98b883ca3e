#pragma once
// Logs that hold arrays by name: NumPy, MATLAB, HDF5 and JSON. Each reader gives tables by the rule
// of tables_of().

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::arrays {

// Logs of NumPy: .npz (savez, savez_compressed) and .npy.

/// Tables of a .npz or .npy file by the rule of tables_of(); an array of a .npz is named as in the
/// archive, that of a .npy by its file name without the ending. The fields of an array of records
/// are "array.field" in a .npz, and "field" in a .npy, whatever the file's name.
/// @throw InputError: the file cannot be read, is damaged, or holds no rows of numbers. Nothing is
///        ever unpickled.
std::vector<log::LogTable> read_npz(const std::string& path);

/// The same of a file's bytes. @param file its name, for messages.
std::vector<log::LogTable> parse_npz(std::string_view bytes, const std::string& file);

// Logs of MATLAB.

/// Tables of a MAT file (version 4, 5, 7, 7.3) by the rule of tables_of(); fields of structs are
/// named "struct.field", of an array of structs "struct_0.field". The elements of a cell array are
/// "cell_0", "cell_1", or as a cell of as many different texts beside it says, where there is just
/// one. Complex, sparse and text arrays, functions and objects are left out with the reason; for
/// tables, timetables and timeseries that is the line that makes vectors of them in MATLAB. Of a
/// file that is cut off the complete variables are read, which is noted; one whose compressed
/// variables are damaged is
/// refused. matio runs in a process of its own, see isolated_reading.h; a 7.3 file that leads to
/// other files is refused.
/// @throw InputError: matio is not installed; the file cannot be read, is no MAT file, is damaged,
/// or holds no rows.
std::vector<log::LogTable> read_mat(const std::string& path);

// Logs in HDF5.

/// Tables of an HDF5 file by the rule of tables_of(); a dataset is named by its path, "run/q", and
/// has the unit of its text attribute "units" or "unit". Numbers and enumerations (booleans of
/// h5py) are read; compound, text, reference and other types are left out with the reason.
///
/// Only what is in the file itself is read: soft and external links, external storage and virtual
/// datasets are left out with the reason, plugins are not loaded. The library runs in a process of
/// its own, see isolated_reading.h.
/// @throw InputError: the library is not installed; the file cannot be read, is no HDF5 file, is
/// damaged, or holds no rows.
std::vector<log::LogTable> read_hdf5(const std::string& path);

// Logs in JSON: as Rhoban/bam writes them, objects of arrays, arrays of objects.

/// Largest JSON file that is read; in memory it takes several times its size.
inline constexpr std::uint64_t largest_json_bytes = std::uint64_t{256} << 20;

/// Tables of a JSON file by the rule of tables_of().
///
/// An array of objects gives one column for each key, of numbers, times or words: `entries` of
/// Rhoban/bam its `timestamp`, `position`, `speed`, `load`, `input_volts`, `goal_position`,
/// `torque_enable`. Where there are several such arrays their names come in front ("run/position").
/// An array of numbers is a vector, an array of equally long arrays of numbers a matrix; within
/// objects "outer.inner". Booleans count 0 and 1; null, NaN and Infinity (which Python writes) are
/// gaps, as is a key that a row lacks; a key in less than a sixteenth of the rows is left out.
/// Single numbers (`mass`, `kp`) and texts become notes. Long format is spread, see long_format.h.
/// @throw InputError: the file cannot be read, is no JSON (with line and column), names a key twice
///        in one object, or holds no rows of numbers.
std::vector<log::LogTable> read_bam_json(const std::string& path);

/// The same of a file's bytes. @param file its name, for messages.
std::vector<log::LogTable> parse_json_log(std::string_view bytes, const std::string& file);

}  // namespace tribolog::ingest::arrays
