#pragma once
// Internal to the report: the view's texts under the names that the templates use.

#include "report/report_view.h"
#include "report/template_engine.h"

namespace tribolog::report {

/// @param has_viewer gives the loop viewer its place.
void fill_report(const ReportView& view, bool has_viewer, TemplateValues& values);

}  // namespace tribolog::report
