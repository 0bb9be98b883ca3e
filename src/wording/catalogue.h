#pragma once
// A message catalogue: English to another language.
//
// What the program computes, archives and writes as JSON is English and the same in every language.
// A report's texts are translated where they enter the page or the figure, by the whole message:
// exact ones first, then those with places (message_pattern.h), then sentence by sentence. A
// message that begins with a small letter also stands for the text that begins a sentence. What the
// catalogue has not stays English. Numbers and units are never changed.

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "wording/message_pattern.h"

namespace tribolog::wording {

class Catalogue {
 public:
  /// Adds the messages of a file: `{"templates": {message: translation}, "texts": {...}}`, either
  /// of which may be absent. Those of templates are HTML and are found as a whole.
  /// @throw std::invalid_argument naming file and message: no such object, a wrong place, a
  ///        translation that names a place which its message has not, a message that has two
  ///        different translations.
  void add(std::string_view json, const std::string& file);

  /// The text in this language; the text itself where the catalogue has no translation.
  [[nodiscard]] std::string translate(std::string_view text) const;

  /// As translate(), but "" where there is no translation.
  [[nodiscard]] std::string find(std::string_view text) const;

  /// Of a template's message; "" where there is no translation.
  [[nodiscard]] std::string find_in_templates(const std::string& message) const;

  /// All messages of templates, for a check of what is left over.
  [[nodiscard]] std::vector<std::string> template_messages() const;

 private:
  struct Message {
    MessagePattern pattern;
    std::string translation;
  };
  void add_text(const std::string& message, const std::string& translation,
                const std::string& file);
  [[nodiscard]] std::string find_whole(std::string_view text) const;
  [[nodiscard]] std::string fill(const Message& message, std::string_view text) const;
  [[nodiscard]] std::string find_sentence(std::string_view text) const;
  [[nodiscard]] std::string find_by_sentences(std::string_view text) const;

  std::map<std::string, std::string, std::less<>> templates_;
  std::map<std::string, std::string, std::less<>> exact_;
  std::vector<Message> with_places_;  ///< Those that say most first.
};

}  // namespace tribolog::wording
