#pragma once
// Formats that hold named arrays (MAT, HDF5, NumPy, JSON): from what a file holds to tables of
// rows.

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::arrays {

/// Most numbers that are read from one file, in all its arrays.
inline constexpr std::uint64_t most_values = std::uint64_t{1} << 31;

/// Most columns of one matrix, as in a row of a text log.
inline constexpr std::size_t most_matrix_columns = 4096;

/// From this size on, not every integer has a double of its own.
inline constexpr double first_rounded_integer = 9007199254740992.0;  // 2^53

/// Numbers under one name: a scalar (1 x 1), a vector (N x 1) or a matrix.
struct NamedArray {
  std::string name;  ///< "q"; of a struct "run.q", of a group "run/q".
  std::size_t rows{1};
  std::size_t columns{1};
  bool by_columns{};           ///< The values of one column follow each other; else those of a row.
  std::vector<double> values;  ///< rows x columns. What is not finite is a gap.
  std::string unit{};          ///< Where the file states one outside of the name.
  bool was_rounded{};          ///< Holds integers that no double can hold exactly.
  bool is_time{};              ///< ISO 8601 texts, as seconds
  double origin{};             ///< since this one: the whole ones of the first reading.
  /// Not empty: a vector of words, whose values are their places in this list. Of JSON, and
  /// of text in long format.
  std::vector<std::string> words{};
};

/// What a file holds.
struct FileArrays {
  std::vector<NamedArray> arrays;
  std::vector<std::pair<std::string, std::string>> texts;     ///< Name and text.
  std::vector<std::pair<std::string, std::string>> left_out;  ///< Name and reason.
  std::uint64_t values{};  ///< Of all arrays, also those that are about to be read.

  void leave_out(const std::string& name, const std::string& reason) {
    left_out.emplace_back(name, reason);
  }
};

/// The rows and columns of an array with these dimensions; those of length 1 do not count, so that
/// 1 x N, N x 1 and 1 x 1 x N are vectors. Counts its values in `found.values`.
/// @return false, and the array is left out with the reason, where it is empty, has more than two
///         dimensions or too many columns, or the file would give more than `most_values`.
bool shape_array(const std::vector<std::uint64_t>& dimensions, NamedArray& array,
                 FileArrays& found);

/// All vectors of one length (2 or more) form one table; the tables come longest first.
///
/// Simulink's structures with time, q.time and q.signals.values, are columns "time" and "q", or
/// what q.signals.label says.
///
/// A matrix gives the columns name_0, name_1, ... . Its rows run along the dimension that is as
/// long as a vector of the file, along the longer one where both or none are; along the first one
/// where they are equal, which is noted. A dimension of more than 64 that fits no vector is not
/// taken for columns. Of two columns with the same name the later one gets a number, which is
/// noted. Scalars, texts and what was left out become notes of the first table. Vectors of words
/// are columns where numbers stand beside them, and are left out where they are alone.
/// @throw InputError naming what the file holds, where nothing has two rows.
std::vector<log::LogTable> tables_of(FileArrays found, const std::string& file);

}  // namespace tribolog::ingest::arrays
