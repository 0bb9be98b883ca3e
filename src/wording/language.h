#pragma once
// The languages that pages are written in, and the one that words are made in just now.

#include <string>
#include <vector>

namespace tribolog::wording {

/// By its code: "en", the program's own; "pl" and others, each a file templates/languages/CODE.po.
struct Language {
  std::string code{"en"};
  [[nodiscard]] bool is_english() const { return code == "en"; }
  friend auto operator<=>(const Language&, const Language&) = default;
};

/// All of them, English first.
std::vector<Language> languages();

/// While it lives, words() and tr() on this thread are in this language; English otherwise.
/// @throw std::invalid_argument: there is no such language. @throw MissingModule
class WordsIn {
 public:
  explicit WordsIn(const Language& language);
  WordsIn(const WordsIn&) = delete;
  WordsIn& operator=(const WordsIn&) = delete;
  ~WordsIn();

 private:
  const class Translator* before_;
};

}  // namespace tribolog::wording
