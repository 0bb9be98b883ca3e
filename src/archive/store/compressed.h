#pragma once
// Documents as they are stored: zstd frames.

#include <cstdint>
#include <string>
#include <string_view>

namespace tribolog::archive {

std::string compressed(std::string_view bytes);

/// @param bytes how many they were.
/// @throw ArchiveError: damaged, or another length. @param name of the archive, for the message.
std::string uncompressed(const std::string& stored, std::uint64_t bytes, const std::string& name);

}  // namespace tribolog::archive
