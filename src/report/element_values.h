#pragma once
// Internal to the report: the values of the templates that many sections share.

#include <string>
#include <vector>

#include "report/report_view.h"
#include "report/template_engine.h"

namespace tribolog::report {

/// The word that the style sheet knows the outcome by.
std::string class_of(Outcome outcome);

/// OUTCOME and the section of its icon.
void fill_outcome(Outcome outcome, TemplateValues& values);

/// OUTCOME and its sign as text: "✓".
void fill_state(Outcome outcome, TemplateValues& values);

/// A path as the link to it; of its bytes, those that mean something there are escaped.
std::string link_to(const std::string& path);

/// One more table.tpl at the marker; nothing if the table has no rows.
void fill_table(const Table& table, const std::string& marker, TemplateValues& values);

/// The section FACTS; nothing if there are none.
void fill_facts(const std::vector<Fact>& facts, TemplateValues& values);
/// A text of somebody's own, line by line: the variable in a repetition of the section for each
/// line that is not empty.
void fill_lines(const std::string& text, const std::string& section, const std::string& variable,
                TemplateValues& values);

/// One more figure.tpl at the marker FIGURE.
void fill_figure(const FigureCard& figure, TemplateValues& values,
                 const std::string& marker = "FIGURE");

/// friction_speeds.tpl at the marker FRICTION_SPEEDS; nothing if it has no rows.
void fill_friction_speeds(const FrictionSpeeds& speeds, TemplateValues& values);

}  // namespace tribolog::report
