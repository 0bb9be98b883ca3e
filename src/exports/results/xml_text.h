#pragma once
// XML with texts of any origin in it.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace tribolog::exports::results {

/// For an attribute in double quotes or between two tags: valid UTF-8, in which what hides is
/// visible (visible_text()) and what XML would obey is escaped.
std::string xml_escaped(const std::string& text);

/// Writes elements, indented by two blanks each. Every element that is opened is closed.
class XmlWriter {
 public:
  using Attributes = std::vector<std::pair<const char*, std::string>>;

  /// An element with what `content` writes in it.
  template <class Content>
  void element(const char* name, const Attributes& attributes, const Content& content) {
    start(name, attributes, ">\n");
    depth_ += 1;
    content();
    depth_ -= 1;
    text_ += indent() + "</" + name + ">\n";
  }
  template <class Content>
  void element(const char* name, const Content& content) {
    element(name, {}, content);
  }

  /// An element with a text alone. It is empty where the text is.
  void leaf(const char* name, const std::string& text, const Attributes& attributes = {}) {
    start(name, attributes, ">");
    text_ += xml_escaped(text);
    text_ += std::string("</") + name + ">\n";
  }

  /// All so far, behind the declaration.
  [[nodiscard]] std::string document() const {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + text_;
  }

 private:
  [[nodiscard]] std::string indent() const { return std::string(2 * depth_, ' '); }
  void start(const char* name, const Attributes& attributes, const char* end) {
    text_ += indent() + "<" + name;
    for (const auto& [key, value] : attributes) {
      text_ += std::string(" ") + key + "=\"" + xml_escaped(value) + "\"";
    }
    text_ += end;
  }

  std::string text_;
  std::size_t depth_{};
};

}  // namespace tribolog::exports::results
