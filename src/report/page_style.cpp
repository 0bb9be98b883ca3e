#include "report/page_style.h"

#include <string>

#include <fmt/format.h>

#include "base/base64.h"
#include "base/sha256.h"
#include "report/page_texts.h"
#include "report/view_parts.h"

namespace tribolog::report {

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

void fill_style(TemplateValues& values, PageKind kind) { fill(own_style(kind), "", values); }

void fill_style_and_script(TemplateValues& values) {
  fill(own_style(PageKind::with_viewer), own_script(), values);
}

void fill_head(const Provenance& provenance, TemplateValues& values, PageKind kind) {
  fill_style(values, kind);
  values.set("TOOL", "tribolog " + provenance.tool_version);
  values.set("CREATED", or_dash(provenance.created_utc));
  values.set("COMMAND_LINE", or_dash(provenance.command_line));
}

}  // namespace tribolog::report
