#pragma once
// A page of tribolog, read again.

#include <optional>
#include <string>

namespace tribolog::report::engine {

struct EmbeddedJson {
  std::string element;  ///< "tribolog-result" of a report, "tribolog-diff" of a comparison, ...
  std::string json;
};

/// What stands in `<script type="application/json" id="ELEMENT">`; nothing: the page has none.
/// @throw InputError: it is there twice, cut off, or no JSON.
std::optional<std::string> json_in(const std::string& html, const std::string& element,
                                   const std::string& file);

/// The numbers that a page carries in `<script type="application/json" id="tribolog-...">`, as the
/// program wrote them.
/// @param file for messages.
/// @throw InputError: it has none, more than one of a kind, or one that is cut off or no JSON.
EmbeddedJson embedded_json(const std::string& html, const std::string& file);

}  // namespace tribolog::report::engine
