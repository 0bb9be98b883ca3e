#pragma once
// Internal to the report: what the head of every page has.

#include "report/template_engine.h"

namespace tribolog::report {

/// CSS, the embedded style sheet, and CSP, the content security policy that allows it by its hash
/// and nothing else but pictures as data URIs.
void fill_style(TemplateValues& values);

}  // namespace tribolog::report
