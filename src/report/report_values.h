#pragma once
// The view's texts under the names that the templates use.

#include <string>
#include <vector>

#include "report/report_view.h"
#include "report/template_engine.h"

namespace tribolog::report {

/// errata.tpl at the marker ERRATA, with the paper's table 2 below it, or where in the page that
/// table stands: "stage 4".
void fill_errata(const ErrataNumbers& errata, const Table& paper_table, TemplateValues& values);
void fill_errata(const ErrataNumbers& errata, const std::string& place_of_paper_table,
                 TemplateValues& values);

/// provenance.tpl at the marker PROVENANCE.
void fill_provenance(const std::string& command_line, const std::string& created_utc,
                     const std::vector<std::string>& notes, const std::vector<Table>& tables,
                     TemplateValues& values);

// Internal to the report: the view's texts under the names that the templates use.

/// @param has_viewer gives the loop viewer its place.
void fill_report(const ReportView& view, bool has_viewer, TemplateValues& values);

}  // namespace tribolog::report
