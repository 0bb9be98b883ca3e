#pragma once
// Logs of NumPy: .npz (savez, savez_compressed) and .npy.

#include <string>
#include <string_view>
#include <vector>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::arrays {

/// Tables of a .npz or .npy file by the rule of tables_of(); an array of a .npz is named as in the
/// archive, that of a .npy by its file name without the ending. The fields of an array of records
/// are "array.field" in a .npz, and "field" in a .npy, whatever the file's name.
/// @throw InputError: the file cannot be read, is damaged, or holds no rows of numbers. Nothing is
///        ever unpickled.
std::vector<log::LogTable> read_npz(const std::string& path);

/// The same of a file's bytes. @param file its name, for messages.
std::vector<log::LogTable> parse_npz(std::string_view bytes, const std::string& file);

}  // namespace tribolog::ingest::arrays
