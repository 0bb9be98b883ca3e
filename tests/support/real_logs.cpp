#include "support/real_logs.h"

#include <filesystem>

namespace tribolog::test {

std::optional<std::string> real_log(const std::string& name) {
  const std::filesystem::path path =
      std::filesystem::path(TRIBOLOG_SOURCE_DIR) / ".." / "shared" / "data" / name;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path.string();
}

}  // namespace tribolog::test
