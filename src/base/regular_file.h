#pragma once
// Internal to the readers of input files: what may be opened, and how the rest is refused.

#include <cstdint>
#include <string>

namespace tribolog {

/// @return a descriptor, to be owned. @throw InputError: cannot be opened (with the system's
/// reason).
int open_regular_file(const std::string& path);

/// @throw InputError: a directory, not a regular file (device, pipe, socket), larger than the
/// bound.
std::uint64_t size_of_regular_file(int descriptor, const std::string& path,
                                   std::uint64_t largest_bytes);

/// @param read, expected bytes.
[[noreturn]] void refuse_shortened(const std::string& path, std::uint64_t read,
                                   std::uint64_t expected);
[[noreturn]] void refuse_unreadable(const std::string& path, int error);
[[noreturn]] void refuse_too_large(const std::string& path, std::uint64_t largest_bytes);

}  // namespace tribolog
