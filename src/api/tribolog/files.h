#pragma once
// Writes results atomically: files are either complete or unchanged.

#include <string>
#include <vector>

#include "tribolog/export.h"

namespace tribolog {

/// One file of a result; its contents may be any bytes.
struct File {
  std::string name;
  std::string bytes;
};

/// Writes all of them or, if one cannot be written, none: they are put in place once all are on
/// disk. A replaced file keeps its permissions, a new one gets those that the umask allows.
/// @param directory created if it does not exist; empty: names are paths.
/// @throw Failure output_failed: with the system's reason. usage: two have the same name.
TRIBOLOG_EXPORT void write_files(const std::vector<File>& files, const std::string& directory = "");

}  // namespace tribolog
