#pragma once
// Logs of MATLAB.

#include <string>
#include <vector>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::arrays {

/// Tables of a MAT file (version 4, 5, 7, 7.3) by the rule of tables_of(); fields of structs are
/// named "struct.field", of an array of structs "struct_0.field". Complex, sparse and text arrays,
/// cells, functions and objects are left out with the reason. Of a file that is cut off the
/// complete variables are read, which is noted; one whose compressed variables are damaged is
/// refused. matio runs in a process of its own, see isolated_reading.h; a 7.3 file that leads to
/// other files is refused.
/// @throw InputError: matio is not installed; the file cannot be read, is no MAT file, is damaged,
/// or holds no rows.
std::vector<log::LogTable> read_mat(const std::string& path);

}  // namespace tribolog::ingest::arrays
