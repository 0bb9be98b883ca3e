#include "report/engine/page_style.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/encodings.h"
#include "report/engine/embedded_files.h"
#include "wording/words.h"

namespace tribolog::report::engine {

namespace {

/// Each stands on the ones before it.
constexpr std::array viewer_parts{"state.js", "elements.js",   "ranges.js",   "plot.js",
                                  "loops.js", "candidates.js", "curves.js",   "readings.js",
                                  "input.js", "saving.js",     "controls.js", "start.js"};

std::string without_indentation(std::string_view script) {
  std::string out;
  while (!script.empty()) {
    const std::size_t end = script.find('\n');
    std::string_view line = script.substr(0, end);
    script = end == std::string_view::npos ? std::string_view() : script.substr(end + 1);
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (!line.empty() && !line.starts_with("//")) out.append(line).append("\n");
  }
  return out;
}

}  // namespace

const std::string& own_style(PageKind kind) {
  static const std::string plain(embedded_file("report.css"));
  static const std::string with_viewer = plain + std::string(embedded_file("viewer.css"));
  static const std::string fleet = plain + std::string(embedded_file("fleet.css"));
  static const std::string robot = plain + std::string(embedded_file("robot.css"));
  static const std::string comparison = with_viewer + std::string(embedded_file("diff.css"));
  switch (kind) {
    case PageKind::comparison:
      return comparison;
    case PageKind::robot:
      return robot;
    case PageKind::with_viewer:
      return with_viewer;
    case PageKind::fleet:
      return fleet;
    case PageKind::plain:
      break;
  }
  return plain;
}

namespace {

constexpr std::string_view head_begins = "@page{@top-right{content:\"";
constexpr std::string_view head_ends = "\";font:8pt sans-serif;color:#444444}}\n";

/// What may stand within a string of the style.
bool is_harmless(char c) {
  constexpr std::string_view marks = " ./_-";
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         marks.find(c) != std::string_view::npos;
}

std::string running_head(const std::string& number) {
  std::string kept;
  std::copy_if(number.begin(), number.end(), std::back_inserter(kept), is_harmless);
  if (kept.empty()) return "";
  return std::string(head_begins) + kept + std::string(head_ends);
}

}  // namespace

bool is_own_style(std::string_view style) {
  for (const PageKind kind : {PageKind::with_viewer, PageKind::fleet, PageKind::robot,
                              PageKind::comparison, PageKind::plain}) {
    if (!style.starts_with(own_style(kind))) continue;
    std::string_view head = style.substr(own_style(kind).size());
    if (head.empty()) return true;
    if (!head.starts_with(head_begins) || !head.ends_with(head_ends)) continue;
    head.remove_prefix(head_begins.size());
    head.remove_suffix(head_ends.size());
    if (std::all_of(head.begin(), head.end(), is_harmless)) return true;
  }
  return false;
}

namespace {

/// For pages with such an element alone; a block, whose names do not clash with the page's.
template <typename Parts>
std::string script_where(const std::string& selector, const Parts& parts) {
  std::string all = "\"use strict\";\nif (document.querySelector(\"" + selector + "\")) {\n";
  for (const char* const part : parts) all += without_indentation(embedded_file(part));
  return all + "}\n";
}

const std::string& table_script() {
  static const std::string script = script_where("#fleet table", std::array{"fleet.js"});
  return script;
}

}  // namespace

const std::string& own_script() {
  static const std::string script = script_where("#tribolog-loops", viewer_parts);
  return script;
}

bool is_own_script(std::string_view script) {
  return script == own_script() || script == table_script();
}

std::vector<std::string> script_messages() {
  constexpr std::string_view call = "t(\"";
  const std::string_view script = own_script();
  std::set<std::string> messages;
  for (std::size_t at = script.find(call); at != std::string_view::npos;
       at = script.find(call, at + call.size())) {
    const char before = at == 0 ? ' ' : script[at - 1];
    if (std::isalnum(static_cast<unsigned char>(before)) != 0 || before == '.') continue;
    const std::string_view text = script.substr(at + call.size());
    messages.emplace(text.substr(0, text.find('"')));
  }
  return {messages.begin(), messages.end()};
}

namespace {

std::string hash_source(const std::string& text) {
  return fmt::format("'sha256-{}'", base64_of_hex(sha256_hex(text)));
}

/// @param script empty: none may run.
void fill(const std::string& style, const std::string& script, TemplateValues& values) {
  values.set_checked_by_modifier("CSS", style);
  std::string policy = "default-src 'none'; img-src data:; style-src " + hash_source(style);
  if (!script.empty()) {
    values.set_checked_by_modifier("SCRIPT", script);
    policy += "; script-src " + hash_source(script);
  }
  values.set("CSP", policy + "; base-uri 'none'; form-action 'none'");
}

}  // namespace

void fill_style(TemplateValues& values, PageKind kind, const std::string& number) {
  fill(own_style(kind) + running_head(number), "", values);
}

void allow_script(TemplateValues& values, PageKind kind) {
  fill(own_style(kind), kind == PageKind::fleet ? table_script() : own_script(), values);
}

void fill_style_and_script(TemplateValues& values, const std::string& number) {
  fill(own_style(PageKind::with_viewer) + running_head(number), own_script(), values);
}

void fill_head(const calibration::Provenance& provenance, TemplateValues& values, PageKind kind) {
  fill_style(values, kind);
  values.set("TOOL", "tribolog " + provenance.tool_version);
  values.set("CREATED", wording::or_dash(provenance.created_utc));
  values.set("COMMAND_LINE", wording::or_dash(provenance.command_line));
}

}  // namespace tribolog::report::engine
