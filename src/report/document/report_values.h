#pragma once
// The view's texts under the names that the templates use.

#include <string>
#include <vector>

#include "report/document/report_view.h"
#include "report/engine/template_engine.h"

namespace tribolog::report::document {

/// provenance.tpl at the marker PROVENANCE.
void fill_provenance(const std::string& command_line, const std::string& created_utc,
                     const std::vector<std::string>& notes, const std::vector<Table>& tables,
                     engine::TemplateValues& values);

// Internal to the report: the view's texts under the names that the templates use.

/// @param has_viewer gives the loop viewer its place.
void fill_report(const ReportView& view, bool has_viewer, engine::TemplateValues& values);

}  // namespace tribolog::report::document
