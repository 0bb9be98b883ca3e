#pragma once
// A whole input file in memory.

#include <cstdint>
#include <string>

namespace tribolog {

/// Largest input file that is read unless the caller says otherwise: 8 GiB.
inline constexpr std::uint64_t largest_input_bytes = std::uint64_t{8} << 30;

/// The bytes of a regular file, as far as it reaches when it is opened. It is read, not mapped: a
/// file that becomes shorter meanwhile is refused and never a signal.
/// @throw InputError naming the file: it cannot be opened or read (with the system's reason), is a
///        directory, is not a regular file (device, pipe, socket, "-"), or is larger than the
///        bound; or it becomes shorter while it is read.
std::string read_file(const std::string& path, std::uint64_t largest_bytes = largest_input_bytes);

/// Size of a regular file in bytes, for a library that opens it by its name.
/// @throw InputError as read_file().
std::uint64_t size_of_file(const std::string& path,
                           std::uint64_t largest_bytes = largest_input_bytes);

}  // namespace tribolog
