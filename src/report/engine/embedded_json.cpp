#include "report/engine/embedded_json.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace tribolog::report::engine {
namespace {

constexpr const char* elements[] = {"tribolog-result", "tribolog-diff",      "tribolog-trend",
                                    "tribolog-plan",   "tribolog-study",     "tribolog-paper",
                                    "tribolog-robot",  "tribolog-robot-plan"};

[[noreturn]] void refuse(const std::string& html, const std::string& file, std::size_t at,
                         const std::string& what, const std::string& hint) {
  const auto line =
      1 + std::count(html.begin(), html.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  throw InputError({file, at == 0 ? 0 : line, 0}, {what, "", "", hint});
}

}  // namespace

std::optional<std::string> json_in(const std::string& html, const std::string& element,
                                   const std::string& file) {
  // No text of a page holds a raw '<', so this is the page's own.
  const std::string opening = fmt::format(R"(<script type="application/json" id="{}">)", element);
  const std::size_t at = html.find(opening);
  if (at == std::string::npos) return std::nullopt;
  if (html.find(opening, at + 1) != std::string::npos)
    refuse(html, file, at, "the page holds its numbers twice", "take the page as it was written");
  const std::size_t from = at + opening.size();
  const std::size_t to = html.find("</script>", from);
  if (to == std::string::npos)
    refuse(html, file, at, "the page is cut off inside its numbers", "copy it again");
  std::string json = html.substr(from, to - from);
  if (!nlohmann::json::accept(json))
    refuse(html, file, at, "the numbers in the page are no JSON", "they were changed");
  return json;
}

EmbeddedJson embedded_json(const std::string& html, const std::string& file) {
  for (const char* const element : elements) {
    if (auto json = json_in(html, element, file)) return {element, std::move(*json)};
  }
  refuse(html, file, 0, "no page of tribolog with its numbers",
         "`tribolog show` reads the reports and pages that tribolog writes, and calibrations");
}

}  // namespace tribolog::report::engine
