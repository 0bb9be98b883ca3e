#pragma once
// Reading the JSON of a calibration of any age: what an older program did not write is null.

#include <string_view>

#include <nlohmann/json.hpp>

namespace tribolog::archive {

/// The member of that name; null where there is none, and where `object` is no object.
inline const nlohmann::json& member(const nlohmann::json& object, std::string_view key) {
  static const nlohmann::json none;
  if (!object.is_object()) return none;
  const auto at = object.find(key);
  return at == object.end() ? none : *at;
}

}  // namespace tribolog::archive
