#include "report/engine/template_modifiers.h"

#include <algorithm>
#include <string_view>

#include <ctemplate/template_emitter.h>
#include <ctemplate/template_modifiers.h>

#include "base/utf8.h"
#include "report/engine/page_style.h"

namespace tribolog::report::engine {
namespace {

class PngUri : public ctemplate::TemplateModifier {
 public:
  void Modify(const char* in, std::size_t length, const ctemplate::PerExpandData*,
              ctemplate::ExpandEmitter* out, const std::string&) const override {
    constexpr std::string_view alphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=";
    const std::string_view text(in, length);
    out->Emit("data:image/png;base64,");
    if (text.find_first_not_of(alphabet) == std::string_view::npos) out->Emit(in, length);
  }
};

class CsvUri : public ctemplate::TemplateModifier {
 public:
  void Modify(const char* in, std::size_t length, const ctemplate::PerExpandData*,
              ctemplate::ExpandEmitter* out, const std::string&) const override {
    constexpr std::string_view kept = ".,-_";
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string uri = "data:text/csv;charset=utf-8,";
    for (const char c : std::string_view(in, length)) {
      const auto byte = static_cast<unsigned char>(c);
      const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
      if (is_letter || (c >= '0' && c <= '9') || kept.find(c) != std::string_view::npos) {
        uri += c;
      } else {
        uri += {'%', digits[byte >> 4U], digits[byte & 15U]};
      }
    }
    out->Emit(uri);
  }
};

class ScriptJson : public ctemplate::TemplateModifier {
 public:
  void Modify(const char* in, std::size_t length, const ctemplate::PerExpandData*,
              ctemplate::ExpandEmitter* out, const std::string&) const override {
    out->Emit(json_for_script({in, length}));
  }
};

class OwnStyle : public ctemplate::TemplateModifier {
 public:
  void Modify(const char* in, std::size_t length, const ctemplate::PerExpandData*,
              ctemplate::ExpandEmitter* out, const std::string&) const override {
    if (is_own_style({in, length})) out->Emit(in, length);
  }
};

class OwnScript : public ctemplate::TemplateModifier {
 public:
  void Modify(const char* in, std::size_t length, const ctemplate::PerExpandData*,
              ctemplate::ExpandEmitter* out, const std::string&) const override {
    if (is_own_script(std::string_view(in, length))) out->Emit(in, length);
  }
};

class Dates : public ctemplate::TemplateModifier {
 public:
  void Modify(const char* in, std::size_t length, const ctemplate::PerExpandData*,
              ctemplate::ExpandEmitter* out, const std::string&) const override {
    out->Emit(html_with_dates({in, length}));
  }
};

class Symbols : public ctemplate::TemplateModifier {
 public:
  void Modify(const char* in, std::size_t length, const ctemplate::PerExpandData*,
              ctemplate::ExpandEmitter* out, const std::string&) const override {
    out->Emit(html_with_symbols({in, length}));
  }
};

bool is_small_letter(char c) { return c >= 'a' && c <= 'z'; }

/// What words and file names consist of.
bool joins_words(char c) {
  return is_small_letter(c) || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '/' || c == '\\';
}

/// Bytes of the Greek letter that the text starts with; 0: it starts with none.
std::size_t greek_bytes(std::string_view text) {
  if (text.empty()) return 0;
  const Utf8Character letter = first_utf8_character(text);
  return letter.code_point >= U'Α' && letter.code_point <= U'ω' ? letter.bytes : 0;
}

/// Bytes of the letter, Latin or Greek, that the text starts with; 0: it starts with none.
std::size_t symbol_bytes(std::string_view text) {
  const char first = text.front();
  if (is_small_letter(first) || (first >= 'A' && first <= 'Z')) return 1;
  return greek_bytes(text);
}

/// Bytes of the index in `_index` that the text starts with; 0: none.
std::size_t index_bytes(std::string_view text) {
  constexpr std::size_t longest = 9;
  if (text.empty() || text.front() != '_') return 0;
  std::size_t end = 1 + greek_bytes(text.substr(1));
  while (end < text.size() && is_small_letter(text[end])) ++end;
  if (end == 1 || end > longest + 1) return 0;
  if (end < text.size() && joins_words(text[end])) return 0;
  const bool has_ending = end + 1 < text.size() && text[end] == '.' && joins_words(text[end + 1]);
  return has_ending ? 0 : end - 1;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Whether the text starts with digits where `form` has zeros, and with its other characters.
bool starts_in_form(std::string_view text, std::string_view form) {
  const std::string_view start = text.substr(0, form.size());
  return start.size() == form.size() &&
         std::equal(start.begin(), start.end(), form.begin(),
                    [](char c, char wanted) { return wanted == '0' ? is_digit(c) : c == wanted; });
}

/// Bytes of the date that stands there, as "2026-01-31" or "2026-01-31T09:30:00Z", and is no part
/// of a longer name; 0: none.
std::size_t date_bytes(std::string_view text, std::size_t at) {
  constexpr std::string_view form = "0000-00-00";
  constexpr std::string_view with_time = "0000-00-00T00:00:00Z";
  if (!starts_in_form(text.substr(at), form)) return 0;
  const bool has_time = starts_in_form(text.substr(at), with_time);
  const std::size_t bytes = has_time ? with_time.size() : form.size();
  const auto belongs = [&](std::size_t beside) {
    return beside < text.size() && (joins_words(text[beside]) || text[beside] == '-');
  };
  const bool is_part = (at > 0 && belongs(at - 1)) || belongs(at + bytes);
  return is_part ? 0 : bytes;
}

void append_escaped(std::string& html, char c) {
  switch (c) {
    case '&':
      html += "&amp;";
      break;
    case '<':
      html += "&lt;";
      break;
    case '>':
      html += "&gt;";
      break;
    case '"':
      html += "&quot;";
      break;
    case '\'':
      html += "&#39;";
      break;
    default:
      html += c;
  }
}

}  // namespace

namespace {

/// Without line breaks at its hyphens.
void append_date(std::string& html, std::string_view date) {
  html.append("<span class=\"date\">").append(date).append("</span>");
}

}  // namespace

std::string html_with_dates(std::string_view text) {
  std::string html;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t date = date_bytes(text, i);
    if (date > 0) append_date(html, text.substr(i, date));
    if (date == 0) append_escaped(html, text[i]);
    i += std::max<std::size_t>(date, 1);
  }
  return html;
}

std::string html_with_symbols(std::string_view text) {
  // Behind the quotes of English and of Polish stands a name, as of a log's column.
  const auto stands_quoted = [text](std::size_t at) {
    const std::string_view before = text.substr(0, at);
    return before.ends_with("“") || before.ends_with("„");
  };
  std::string html;
  for (std::size_t i = 0; i < text.size();) {
    if (const std::size_t date = date_bytes(text, i); date > 0) {
      append_date(html, text.substr(i, date));
      i += date;
      continue;
    }
    const bool word_starts = i == 0 || (!joins_words(text[i - 1]) && !stands_quoted(i));
    const std::size_t symbol = word_starts ? symbol_bytes(text.substr(i)) : 0;
    const std::size_t index = symbol > 0 ? index_bytes(text.substr(i + symbol)) : 0;
    if (index == 0) {
      append_escaped(html, text[i++]);
      continue;
    }
    html.append("<i>").append(text.substr(i, symbol)).append("</i><sub>");
    html.append(text.substr(i + symbol + 1, index)).append("</sub>");
    i += symbol + 1 + index;
  }
  return html;
}

std::string json_for_script(const std::string& json) {
  std::string safe;
  safe.reserve(json.size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string_view rest(json.data() + i, json.size() - i);
    if (json[i] == '<') {
      safe += "\\u003c";
    } else if (json[i] == '>') {
      safe += "\\u003e";
    } else if (json[i] == '&') {
      safe += "\\u0026";
    } else if (rest.substr(0, 3) == "\u2028" || rest.substr(0, 3) == "\u2029") {
      safe += rest.substr(0, 3) == "\u2028" ? "\\u2028" : "\\u2029";
      i += 2;
    } else {
      safe += json[i];
    }
  }
  return safe;
}

void register_template_modifiers() {
  static const PngUri png;
  static const CsvUri csv;
  static const ScriptJson json;
  static const OwnStyle css;
  static const OwnScript script;
  static const Dates dates;
  static const Symbols symbols;
  static const bool once = ctemplate::AddXssSafeModifier("x-png", &png) &&
                           ctemplate::AddXssSafeModifier("x-csv", &csv) &&
                           ctemplate::AddXssSafeModifier("x-json", &json) &&
                           ctemplate::AddXssSafeModifier("x-css", &css) &&
                           ctemplate::AddXssSafeModifier("x-script", &script) &&
                           ctemplate::AddXssSafeModifier("x-dates", &dates) &&
                           ctemplate::AddXssSafeModifier("x-symbols", &symbols);
  static_cast<void>(once);
}

}  // namespace tribolog::report::engine
