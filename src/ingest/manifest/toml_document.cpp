#include "ingest/manifest/toml_document.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/shown_text.h"
#include "base/utf8.h"

namespace tribolog::ingest::manifest {

const TomlNode* TomlNode::member(std::string_view key) const {
  const auto* members = as<TomlMembers>();
  if (members == nullptr) return nullptr;
  const auto at = members->find(key);
  return at == members->end() ? nullptr : &at->second;
}

std::string iso_offset(int minutes) {
  if (minutes == 0) return "Z";
  const int size = std::abs(minutes);
  return fmt::format("{}{:02}:{:02}", minutes < 0 ? '-' : '+', size / 60, size % 60);
}

std::string toml_number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string toml_text(std::string_view text) {
  std::string quoted = "\"";
  while (!text.empty()) {
    const Utf8Character c = first_utf8_character(text);
    if (c.bytes == 0) throw std::invalid_argument("a text for TOML is not UTF-8");
    if (c.code_point == '"' || c.code_point == '\\') {
      quoted += '\\';
      quoted += text.front();
    } else if (is_control_character(c.code_point) || is_hidden_character(c.code_point)) {
      quoted += fmt::format("\\U{:08X}", static_cast<std::uint32_t>(c.code_point));
    } else {
      quoted += text.substr(0, c.bytes);
    }
    text.remove_prefix(c.bytes);
  }
  return quoted += '"';
}

// What must not reach the parser.

namespace {

constexpr int most_dots = 50;
constexpr std::size_t deepest_brackets = 32;  ///< As the parser has it.

/// Walks a document just closely enough to tell texts and comments from the rest, and where a key
/// or a value has begun: the parser scans a bare one up to a blank or further (dates), through
/// quotes and brackets and into a text behind them.
class Walk {
 public:
  Walk(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  void check() {
    while (!at_end()) {
      if (text_[i_] == '#') {
        skip_comment();
      } else if (text_[i_] == '"' || text_[i_] == '\'') {
        if (has_begun()) refuse("quote in the middle of a key or value");
        skip_text();
        begin();
      } else {
        check_plain(text_[i_]);
        step();
      }
    }
  }

 private:
  enum class Place { before_key, in_key, before_value, in_value };
  enum class Bracket { header, array, table };
  struct Open {
    Bracket kind{};
    long line{};
  };

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
    // Up to two quotes before the closing three are the text's own.
    const std::size_t end = i_ + (is_multiline ? 3 : 1);
    const std::size_t latest = is_multiline ? end + 2 : end;
    while (!at_end() && i_ < latest && (i_ < end || text_[i_] == quote)) step();
  }

  /// A backslash may continue a line: then blanks and line ends up to the next character follow.
  void check_after_backslash() const {
    const std::size_t next = text_.find_first_not_of(" \t\r\n", i_);
    if (next == std::string_view::npos || is_ascii(text_[next])) return;
    refuse("backslash before a character beyond ASCII");
  }

  void check_plain(char c) {
    if (!is_ascii(c)) refuse("character beyond ASCII outside of quotes and comments");
    switch (c) {
      case ' ':
      case '\t':
      case '\r':
        return;
      case '\n':
        return end_line();
      case '[':
      case '{':
        return open(c);
      case ']':
      case '}':
        return close();
      case '=':
        return assign();
      case ',':
        return separate();
      case '.':
        return join();
      default:
        begin();
    }
  }

  [[nodiscard]] bool has_begun() const {
    return place_ == Place::in_key || place_ == Place::in_value;
  }

  void begin() {
    if (place_ == Place::before_key) place_ = Place::in_key;
    if (place_ == Place::before_value) place_ = Place::in_value;
  }

  /// Only an array goes on in the next line.
  void end_line() {
    dots_ = 0;
    if (!open_.empty() && open_.back().kind == Bracket::array) {
      place_ = Place::before_value;
      return;
    }
    open_.clear();
    place_ = Place::before_key;
  }

  void open(char c) {
    const bool follows_point = place_ == Place::before_key && dots_ > 0;
    if (has_begun() || follows_point) refuse("bracket in the middle of a key or value");
    const bool is_header = c == '[' && place_ == Place::before_key;
    const bool is_array = c == '[' && !is_header;
    if (open_.size() == deepest_brackets) refuse("brackets nested too deeply");
    open_.push_back({is_header  ? Bracket::header
                     : is_array ? Bracket::array
                                : Bracket::table,
                     line_});
    place_ = is_array ? Place::before_value : Place::before_key;
    dots_ = 0;
  }

  /// What a bracket closes is a value or a header, and nothing else begins behind it.
  void close() {
    if (!open_.empty()) open_.pop_back();
    place_ = Place::in_value;
    dots_ = 0;
  }

  void assign() {
    if (place_ == Place::before_value || place_ == Place::in_value) {
      const bool is_from_above = !open_.empty() && open_.back().line < line_;
      refuse(
          "'=' in the middle of a value",
          is_from_above ? fmt::format("the '[' of line {} is not closed", open_.back().line) : "");
    }
    place_ = Place::before_value;
    dots_ = 0;
  }

  void separate() {
    const bool is_array = !open_.empty() && open_.back().kind == Bracket::array;
    place_ = is_array ? Place::before_value : Place::before_key;
    dots_ = 0;
  }

  /// A point joins the parts of a key; in a value it belongs to the number.
  void join() {
    if (++dots_ > most_dots) refuse("key with too many dots");
    if (place_ == Place::in_key) {
      place_ = Place::before_key;
    } else {
      begin();
    }
  }

  static bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

  [[noreturn]] void refuse(const char* what, const std::string& hint = "") const {
    throw InputError({file_, line_, static_cast<long>(i_ - line_start_ + 1)}, {what, "", "", hint});
  }

  std::string_view text_;
  const std::string& file_;
  std::vector<Open> open_;
  Place place_{Place::before_key};
  std::size_t i_{0};
  std::size_t line_start_{0};
  long line_{1};
  int dots_{0};
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

}  // namespace tribolog::ingest::manifest
