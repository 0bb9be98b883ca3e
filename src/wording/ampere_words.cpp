#include "wording/ampere_words.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace tribolog::wording {

std::string in_amperes(std::string text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> units = {
      {{"N·m", "A"}, {"kg·m²", "A·s²/rad"}, {"g·m²", "mA·s²/rad"}}};
  for (const auto& [torque, current] : units) {
    for (std::size_t at = text.find(torque); at != std::string::npos;
         at = text.find(torque, at + current.size())) {
      text.replace(at, torque.size(), current);
    }
  }
  return text;
}

std::string page_in_amperes(const std::string& html) {
  constexpr std::string_view opened = "<script";
  constexpr std::string_view closed = "</script>";
  std::string page;
  for (std::size_t at = 0; at < html.size();) {
    const std::size_t script = std::min(html.find(opened, at), html.size());
    page += in_amperes(html.substr(at, script - at));
    const std::size_t end = html.find(closed, script);
    const std::size_t next = end == std::string::npos ? html.size() : end + closed.size();
    page += html.substr(script, next - script);
    at = next;
  }
  return page;
}

}  // namespace tribolog::wording
