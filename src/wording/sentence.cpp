#include "wording/sentence.h"

#include <cwctype>
#include <sstream>
#include <string_view>

#include <locale.h>

#include "base/utf8.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::wording {
namespace {

/// Greek letters are symbols.
bool is_latin(char32_t c) {
  return c < 0x80 || (c >= 0xc0 && c < 0x250) || (c >= 0x1e00 && c < 0x1f00);
}

char32_t capital_of(char32_t letter) {
  static const locale_t characters = newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
  if (letter >= 'a' && letter <= 'z') return letter - 'a' + 'A';
  if (letter < 0x80 || !is_latin(letter) || characters == nullptr) return letter;
  return towupper_l(static_cast<wint_t>(letter), characters);
}

bool is_word_of_one_letter(std::string_view letter) {
  std::istringstream words(
      /* TRANSLATORS: the words of one letter that may begin a sentence, with blanks between */
      tr("a"));
  for (std::string word; words >> word;) {
    if (word == letter) return true;
  }
  return false;
}

bool is_symbol(std::string_view word) {
  if (word.find('_') != std::string_view::npos) return true;
  return first_utf8_character(word).bytes == word.size() && !is_word_of_one_letter(word);
}

}  // namespace

std::string capitalised(const std::string& text) {
  if (is_symbol(std::string_view(text).substr(0, text.find(' ')))) return text;
  const Utf8Character first = first_utf8_character(text);
  if (first.bytes == 0) return text;
  return utf8_of(capital_of(first.code_point)) + text.substr(first.bytes);
}

std::string capitalised(const Statement& statement) { return capitalised(words(statement)); }

std::string as_sentence(const std::string& text) {
  if (text.empty()) return text;
  std::string sentence = capitalised(text);
  const char last = sentence.back();
  return last == '.' || last == '!' || last == '?' || last == ':' ? sentence : sentence + ".";
}

std::string as_sentence(const Statement& statement) { return as_sentence(words(statement)); }

}  // namespace tribolog::wording
