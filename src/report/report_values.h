#pragma once
// Internal to the report: the view's texts under the names that the templates use.

#include "report/report_view.h"
#include "report/template_engine.h"

namespace tribolog::report {

void fill_report(const ReportView& view, TemplateValues& values);

}  // namespace tribolog::report
