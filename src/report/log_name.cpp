#include <filesystem>

#include "report/view_parts.h"

namespace tribolog::report {

std::string log_name(const std::string& recording) {
  return std::filesystem::path(recording).filename().string();
}

}  // namespace tribolog::report
