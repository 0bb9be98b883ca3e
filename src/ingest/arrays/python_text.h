#pragma once
// Text of Python literals, as a NumPy header holds them: taken piece by piece from the front.

#include <cstdint>
#include <string>
#include <string_view>

namespace tribolog::ingest::arrays {

class PythonText {
 public:
  explicit PythonText(std::string_view text) : rest_(text) {}

  /// Each takes what it names, with blanks in front of it. @return false: it is not there, and what
  /// is left of the text has no meaning.
  bool take(char c);
  bool take(std::string_view word);
  /// In quotes of either kind, with Python's escapes.
  bool take_text(std::string& text);
  bool take_number(std::uint64_t& number);

  bool is_at_end();

 private:
  void skip_blanks();
  bool take_escape(std::string& text);
  std::string_view rest_;
};

}  // namespace tribolog::ingest::arrays
