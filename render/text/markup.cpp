#include "render/text/markup.h"

#include "render/text/utf8.h"

namespace tribolog::render {
namespace {

void append(std::vector<MarkupRun>& runs, std::u32string_view text, Shift shift) {
  if (text.empty()) return;
  if (runs.empty() || runs.back().shift != shift) runs.push_back({{}, shift});
  runs.back().text += text;
}

}  // namespace

MarkupText parse_markup(std::string_view utf8) {
  const DecodedText decoded = decode_utf8(utf8);
  MarkupText out;
  out.replaced = decoded.replaced;
  std::u32string_view rest = decoded.text;
  while (!rest.empty()) {
    const bool opens = rest.size() > 2 && (rest[0] == U'_' || rest[0] == U'^') && rest[1] == U'{';
    const std::size_t closing = opens ? rest.find(U'}', 2) : std::u32string_view::npos;
    if (closing == std::u32string_view::npos) {
      append(out.runs, rest.substr(0, 1), Shift::none);
      rest.remove_prefix(1);
      continue;
    }
    append(out.runs, rest.substr(2, closing - 2),
           rest[0] == U'_' ? Shift::subscript : Shift::superscript);
    rest.remove_prefix(closing + 1);
  }
  return out;
}

}  // namespace tribolog::render
