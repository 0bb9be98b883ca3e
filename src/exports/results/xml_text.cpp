#include "exports/results/xml_text.h"

#include "wording/visible_text.h"

namespace tribolog::exports::results {

std::string xml_escaped(const std::string& text) {
  std::string escaped;
  for (const char c : wording::visible_text(text)) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&apos;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

}  // namespace tribolog::exports::results
