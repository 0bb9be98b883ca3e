#include "report/engine/template_language.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>

namespace tribolog::report::engine {
namespace {

constexpr std::string_view formula_mark = "<math/>";

/// What a browser shows or reads aloud.
constexpr std::array<std::string_view, 4> read_attributes = {" alt=\"", " aria-label=\"",
                                                             " data-name=\"", " title=\""};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Two letters in a row: symbols and most units are the same in every language.
bool has_a_word(std::string_view text) {
  return std::adjacent_find(text.begin(), text.end(), [](char a, char b) {
           return is_letter(a) && is_letter(b);
         }) != text.end();
}

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// "b" of "<b>", "</b>" and "<b class=...>".
std::string_view tag_name(std::string_view tag) {
  tag.remove_prefix(tag.starts_with("</") ? 2 : 1);
  const auto end = std::find_if_not(tag.begin(), tag.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
  });
  return tag.substr(0, static_cast<std::size_t>(end - tag.begin()));
}

bool stands_in_a_sentence(std::string_view tag) {
  static constexpr std::array names = {
      std::string_view("a"),      std::string_view("abbr"), std::string_view("b"),
      std::string_view("bdi"),    std::string_view("code"), std::string_view("em"),
      std::string_view("i"),      std::string_view("kbd"),  std::string_view("span"),
      std::string_view("strong"), std::string_view("sub"),  std::string_view("sup"),
      std::string_view("var")};
  const bool is_self_link = tag.find("class=\"self\"") != std::string_view::npos;
  return !is_self_link && std::find(names.begin(), names.end(), tag_name(tag)) != names.end();
}

/// One piece of a template: text, a tag, a marker, or a formula as a whole.
struct Piece {
  enum class Kind { text, tag, marker, formula, opaque } kind{};
  std::string_view text;
};

std::size_t end_behind(std::string_view source, std::size_t from, std::string_view what) {
  const std::size_t at = source.find(what, from);
  return at == std::string_view::npos ? source.size() : at + what.size();
}

Piece next_piece(std::string_view source) {
  if (source.starts_with("{{")) {
    return {Piece::Kind::marker, source.substr(0, end_behind(source, 0, "}}"))};
  }
  if (source.starts_with(formula_mark))
    return {Piece::Kind::tag, source.substr(0, formula_mark.size())};
  if (source.starts_with("<math")) {
    return {Piece::Kind::formula, source.substr(0, end_behind(source, 0, "</math>"))};
  }
  for (const std::string_view name : {"script", "style", "svg"}) {
    if (source.starts_with(fmt::format("<{}", name))) {
      const std::string end = fmt::format("</{}>", name);
      return {Piece::Kind::opaque, source.substr(0, end_behind(source, 0, end))};
    }
  }
  if (source.starts_with("<")) {
    return {Piece::Kind::tag, source.substr(0, end_behind(source, 0, ">"))};
  }
  const std::size_t end = std::min(source.find('<'), source.find("{{"));
  return {Piece::Kind::text, source.substr(0, end)};
}

/// "{{NAME}}" and "{{NAME:modifier}}" print a text; others open, close and include.
bool prints_a_text(std::string_view marker) {
  return marker.size() > 4 && std::isupper(static_cast<unsigned char>(marker[2])) != 0;
}

bool belongs_to_a_sentence(const Piece& piece) {
  switch (piece.kind) {
    case Piece::Kind::text:
      return true;
    case Piece::Kind::tag:
      return stands_in_a_sentence(piece.text);
    case Piece::Kind::marker:
      return prints_a_text(piece.text);
    case Piece::Kind::formula:
      return piece.text.find("display=\"block\"") == std::string_view::npos;
    case Piece::Kind::opaque:
      break;
  }
  return false;
}

/// Tags, markers and formulas in order of the alphabet: a translation may move them.
std::vector<std::string> marks_of(std::string_view message) {
  std::vector<std::string> marks;
  while (!message.empty()) {
    const Piece piece = next_piece(message);
    if (piece.kind != Piece::Kind::text) marks.emplace_back(piece.text);
    message.remove_prefix(piece.text.size());
  }
  std::sort(marks.begin(), marks.end());
  return marks;
}

class Rewriter {
 public:
  explicit Rewriter(const TranslateMessage& translate) : translate_(translate) {}

  std::string rewrite(std::string_view source) {
    while (!source.empty()) {
      const Piece piece = next_piece(source);
      source.remove_prefix(piece.text.size());
      if (belongs_to_a_sentence(piece)) {
        sentence_.push_back(piece);
        continue;
      }
      end_sentence();
      out_ += piece.kind == Piece::Kind::tag ? tag(piece.text) : std::string(piece.text);
    }
    end_sentence();
    return std::move(out_);
  }

 private:
  void end_sentence() {
    std::string message;
    std::string plain;
    bool has_words = false;
    for (const Piece& piece : sentence_) {
      plain += piece.kind == Piece::Kind::tag ? tag(piece.text) : std::string(piece.text);
      if (piece.kind == Piece::Kind::formula) {
        message += formula_mark;
        continue;
      }
      message += piece.text;
      has_words = has_words || (piece.kind == Piece::Kind::text && has_a_word(piece.text));
    }
    const std::string translation = has_words ? translated(message) : std::string();
    out_ += translation.empty() ? plain : with_formulas(translation);
    sentence_.clear();
  }

  /// With the message's blanks around it.
  std::string translated(const std::string& text) {
    const auto first = std::find_if_not(text.begin(), text.end(), is_blank);
    const auto last = std::find_if_not(text.rbegin(), text.rend(), is_blank).base();
    const std::string message(first, last);
    const std::string translation = translate_(message);
    if (translation.empty()) return {};
    if (marks_of(translation) != marks_of(message)) {
      throw std::invalid_argument("the translation of \"" + message +
                                  "\" has other tags or markers than the message");
    }
    return std::string(text.begin(), first) + translation + std::string(last, text.end());
  }

  [[nodiscard]] std::string with_formulas(std::string text) const {
    std::size_t at = 0;
    for (const Piece& piece : sentence_) {
      if (piece.kind != Piece::Kind::formula) continue;
      at = text.find(formula_mark, at);
      text.replace(at, formula_mark.size(), piece.text);
      at += piece.text.size();
    }
    return text;
  }

  /// A tag with the attributes that are read aloud or shown.
  std::string tag(std::string_view source) {
    std::string result(source);
    for (const std::string_view name : read_attributes) {
      const std::size_t at = result.find(name);
      if (at == std::string::npos) continue;
      const std::size_t from = at + name.size();
      const std::size_t end = result.find('"', from);
      const std::string message = result.substr(from, end - from);
      if (message.find("{{") != std::string::npos || message.empty()) continue;
      const std::string translation = translate_(message);
      if (translation.empty()) continue;
      if (translation.find_first_of("\"<>&{}") != std::string::npos) {
        throw std::invalid_argument("the translation of \"" + message +
                                    "\" cannot stand in an attribute");
      }
      result.replace(from, end - from, translation);
    }
    return result;
  }

  const TranslateMessage& translate_;
  std::vector<Piece> sentence_;
  std::string out_;
};

}  // namespace

std::string template_in_language(std::string_view source, const TranslateMessage& translate) {
  return Rewriter(translate).rewrite(source);
}

std::vector<std::string> messages_of_template(std::string_view source) {
  std::vector<std::string> messages;
  (void)template_in_language(source, [&messages](const std::string& message) {
    messages.push_back(message);
    return std::string();
  });
  return messages;
}

}  // namespace tribolog::report::engine
