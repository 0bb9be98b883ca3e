#include "ingest/manifest/toml_document.h"

#include <cstdlib>

#include <fmt/format.h>

namespace tribolog::ingest::manifest {

const TomlNode* TomlNode::member(std::string_view key) const {
  const auto* members = as<TomlMembers>();
  if (members == nullptr) return nullptr;
  const auto at = members->find(key);
  return at == members->end() ? nullptr : &at->second;
}

std::string iso_offset(int minutes) {
  if (minutes == 0) return "Z";
  const int size = std::abs(minutes);
  return fmt::format("{}{:02}:{:02}", minutes < 0 ? '-' : '+', size / 60, size % 60);
}

}  // namespace tribolog::ingest::manifest
