#include "report/page_style.h"

#include <string>

#include "files/base64.h"
#include "files/sha256.h"
#include "report/embedded_files.h"
#include "report/template_modifiers.h"
#include "report/view_parts.h"

namespace tribolog::report {

void fill_style(TemplateValues& values) {
  const std::string style(embedded_file(style_sheet_name));
  values.set_checked_by_modifier("CSS", style);
  values.set("CSP", "default-src 'none'; img-src data:; style-src 'sha256-" +
                        base64_of_hex(sha256_hex(style)) +
                        "'; base-uri 'none'; form-action 'none'");
}

void fill_head(const Provenance& provenance, TemplateValues& values) {
  fill_style(values);
  values.set("TOOL", "tribolog " + provenance.tool_version);
  values.set("CREATED", or_dash(provenance.created_utc));
  values.set("COMMAND_LINE", or_dash(provenance.command_line));
}

}  // namespace tribolog::report
