#include "export/calibration/xml_text.h"

#include "base/shortest_number.h"
#include "export/calibration/comment_lines.h"

namespace tribolog::archive {

std::string xml_attribute(const std::string& text, const std::string& instead) {
  std::string escaped;
  for (const char c : one_line(text.empty() ? instead : text)) {
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

std::string xml_comment(const std::vector<std::string>& lines, const std::string& indent) {
  std::string text = indent + "<!--\n";
  for (const std::string& line : lines) {
    text += indent + "  ";
    for (const char c : one_line(line)) {
      if (c == '-' && text.back() == '-') text += ' ';
      text += c;
    }
    text += '\n';
  }
  return text + indent + "-->\n";
}

std::string shortest(double number) {
  std::string text;
  append_number(text, number);
  return text;
}

}  // namespace tribolog::archive
