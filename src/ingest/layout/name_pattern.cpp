#include "ingest/layout/name_pattern.h"

#include <algorithm>
#include <cstddef>

namespace tribolog {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

std::optional<std::string> joint_in_name(std::string_view name, std::string_view pattern) {
  constexpr std::string_view place = "{}";
  const std::size_t at = pattern.find(place);
  if (at == std::string_view::npos) {
    return same(name, pattern) ? std::optional<std::string>("") : std::nullopt;
  }
  const std::string_view before = pattern.substr(0, at);
  const std::string_view behind = pattern.substr(at + place.size());
  if (name.size() <= before.size() + behind.size()) return std::nullopt;
  const std::size_t length = name.size() - before.size() - behind.size();
  if (!same(name.substr(0, before.size()), before)) return std::nullopt;
  if (!same(name.substr(name.size() - behind.size()), behind)) return std::nullopt;
  return std::string(name.substr(before.size(), length));
}

}  // namespace tribolog
