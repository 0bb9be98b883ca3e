#pragma once
// Programs that archive, and are killed at random moments.

#include <chrono>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace tribolog::test {

/// Calibration files that differ in the SHA-256 of their inputs alone.
std::vector<std::string> calibrations_like(const std::string& json, const std::string& directory,
                                           std::size_t count);

/// What one run told before it ended or was killed.
struct WriterRun {
  bool was_killed{};
  int status{};               ///< Exit status where it was not.
  std::set<std::string> ids;  ///< First digits of what it said is archived.
  std::chrono::microseconds took{};
};

/// `tribolog archive add FILE... --archive LOCATION`, killed after a while unless it ends before.
WriterRun archive_and_kill(const std::vector<std::string>& files, const std::string& location,
                           std::chrono::microseconds life);

}  // namespace tribolog::test
