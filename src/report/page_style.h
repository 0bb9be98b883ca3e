#pragma once
// Internal to the report: what the head of every page has.

#include "calibration/provenance.h"
#include "report/page_texts.h"
#include "report/template_engine.h"

namespace tribolog::report {

/// fill_style(), and TOOL, CREATED and COMMAND_LINE from the provenance.
void fill_head(const Provenance& provenance, TemplateValues& values,
               PageKind kind = PageKind::plain);

/// CSS, the style of such a page, and CSP, the content security policy that allows it by its hash
/// and nothing else but pictures as data URIs.
void fill_style(TemplateValues& values, PageKind kind = PageKind::plain);

/// The same with the style of the loop viewer, and SCRIPT, its script, which the policy allows by
/// its hash too.
void fill_style_and_script(TemplateValues& values);

}  // namespace tribolog::report
