#pragma once
// The variables of a MAT file as its bytes lay them out, before a library interprets them.

#include <cstddef>
#include <string>

namespace tribolog {

enum class MatVersion { mat_4, mat_5, mat_7_3 };

/// By the first 128 bytes. @throw UnreadableFile where they are of no MAT file.
MatVersion mat_version(const std::string& path);

struct MatElements {
  std::size_t complete{};  ///< Variables that are in the file as a whole.
  bool ends_inside{};      ///< One more is begun: the file is cut off.
};

/// Walks the variables of a MAT 4 or 5 file from length to length, checks what is compressed
/// against its checksum, and that a variable holds the values it claims: the library does neither.
/// @throw UnreadableFile naming the variable by its number.
MatElements check_mat_elements(const std::string& path, MatVersion version);

}  // namespace tribolog
