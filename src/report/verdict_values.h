#pragma once
// Internal to the report: the values of quantities.tpl and data_checks.tpl.

#include <vector>

#include "report/report_view.h"
#include "report/template_engine.h"

namespace tribolog::report {

/// Nothing where there are none.
void fill_quantities(const ReportView& view, TemplateValues& values);
void fill_data_checks(const std::vector<DataCheckRow>& rows, TemplateValues& values);

}  // namespace tribolog::report
