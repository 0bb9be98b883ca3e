#pragma once
// The view's texts under the names that the templates use.

#include <string>
#include <vector>

#include "report/report_view.h"
#include "report/template_engine.h"

namespace tribolog::report {

/// provenance.tpl at the marker PROVENANCE.
void fill_provenance(const std::string& command_line, const std::string& created_utc,
                     const std::vector<std::string>& notes, const std::vector<Table>& tables,
                     TemplateValues& values);

// Internal to the report: the view's texts under the names that the templates use.

/// @param has_viewer gives the loop viewer its place.
void fill_report(const ReportView& view, bool has_viewer, TemplateValues& values);

}  // namespace tribolog::report
