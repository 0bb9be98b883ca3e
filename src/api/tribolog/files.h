#pragma once
// Results as files that are either whole or what they were before.

#include <string>
#include <vector>

#include "tribolog/export.h"

namespace tribolog {

/// Of a result; bytes of any kind.
struct File {
  std::string name;
  std::string bytes;
};

/// Writes all of them or, where one cannot be written, none: each takes its place once every one is
/// on the disk. An old file leaves its permissions, a new one has those that the umask leaves.
/// @param directory is made if it is not there; empty: names are paths.
/// @throw Failure output_failed: with the system's reason. usage: two have the same name.
TRIBOLOG_EXPORT void write_files(const std::vector<File>& files, const std::string& directory = "");

}  // namespace tribolog
