#include "ingest/manifest/toml_precheck.h"

#include <fmt/format.h>

#include "error.h"
#include "files/utf8.h"

namespace tribolog {
namespace {

constexpr int most_dots = 50;

/// Walks a document just closely enough to tell texts and comments from the rest.
class Walk {
 public:
  Walk(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  void check() {
    while (!at_end()) {
      if (text_[i_] == '#') {
        skip_comment();
      } else if (text_[i_] == '"' || text_[i_] == '\'') {
        if (!may_start_text_) refuse("quote in the middle of a key or value");
        skip_text();
        may_start_text_ = false;
      } else {
        check_plain(text_[i_]);
        step();
      }
    }
  }

 private:
  [[nodiscard]] bool at_end() const { return i_ >= text_.size(); }
  [[nodiscard]] bool is_ahead(std::string_view what) const {
    return text_.substr(i_).starts_with(what);
  }

  void step() {
    if (text_[i_] == '\n') {
      ++line_;
      line_start_ = i_ + 1;
    }
    ++i_;
  }

  void skip_comment() {
    while (!at_end() && text_[i_] != '\n') step();
  }

  /// A text in one or three quotes. One that does not end in its line ends with it: the parser
  /// refuses it there.
  void skip_text() {
    const char quote = text_[i_];
    const std::string triple(3, quote);
    const bool is_multiline = is_ahead(triple);
    i_ += is_multiline ? 3 : 1;
    while (!at_end()) {
      if (is_multiline ? is_ahead(triple) : text_[i_] == quote) break;
      if (!is_multiline && text_[i_] == '\n') return;
      if (quote == '"' && text_[i_] == '\\') {
        step();
        check_after_backslash();
        if (at_end()) return;
      }
      step();
    }
    for (int n = is_multiline ? 3 : 1; n > 0 && !at_end(); --n) step();
  }

  /// A backslash may continue a line: then blanks and line ends up to the next character follow.
  void check_after_backslash() const {
    const std::size_t next = text_.find_first_not_of(" \t\r\n", i_);
    if (next == std::string_view::npos || is_ascii(text_[next])) return;
    refuse("backslash before a character beyond ASCII");
  }

  void check_plain(char c) {
    if (!is_ascii(c)) refuse("character beyond ASCII outside of quotes and comments");
    // The parser scans a bare value up to a blank, through brackets and into a text behind them.
    const bool opens = c == '[' || c == '{';
    if (opens && i_ > 0 && is_bare(text_[i_ - 1]))
      refuse("bracket in the middle of a key or value");
    if (c == '=' && is_value_) refuse("'=' in the middle of a value");
    if (std::string_view("\n[{,=").find(c) != std::string_view::npos) is_value_ = c == '=';
    if (c == '.' && ++dots_ > most_dots) refuse("key with too many dots");
    if (std::string_view("\n=[]{},").find(c) != std::string_view::npos) dots_ = 0;
    if (c != ' ' && c != '\t') {
      may_start_text_ = std::string_view("\n\r=[{,.").find(c) != std::string_view::npos &&
                        !(c == '.' && is_value_);
    }
  }

  /// Of a number, a date, a bare key; or the end of a text.
  static bool is_bare(char c) {
    return std::string_view(" \t\r\n=[]{},").find(c) == std::string_view::npos;
  }
  static bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

  [[noreturn]] void refuse(const char* what) const {
    throw InputError({file_, line_, static_cast<long>(i_ - line_start_ + 1)}, {what, "", "", ""});
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t i_{0};
  std::size_t line_start_{0};
  long line_{1};
  int dots_{0};
  bool may_start_text_{true};
  bool is_value_{false};  ///< Behind a '=', up to what ends its value.
};

void refuse_broken_utf8(std::string_view text, const std::string& file) {
  const auto broken = first_broken_utf8(text);
  if (!broken) return;
  long line = 1;
  std::size_t line_start = 0;
  for (std::size_t i = 0; i < *broken; ++i) {
    if (text[i] != '\n') continue;
    ++line;
    line_start = i + 1;
  }
  throw InputError(
      {file, line, static_cast<long>(*broken - line_start + 1)},
      {"text is not UTF-8", fmt::format("byte 0x{:02X}", static_cast<unsigned char>(text[*broken])),
       "", "save the file as UTF-8"});
}

}  // namespace

void precheck_toml(std::string_view text, const std::string& file) {
  refuse_broken_utf8(text, file);
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  Walk(text, file).check();
}

}  // namespace tribolog
