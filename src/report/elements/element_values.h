#pragma once
// The values of the templates that many sections and pages share.

#include <string>
#include <vector>

#include "report/elements/elements.h"
#include "report/engine/template_engine.h"

namespace tribolog::report::elements {

/// The word that the style sheet knows the outcome by.
std::string class_of(Outcome outcome);

/// OUTCOME and the section of its icon.
void fill_outcome(Outcome outcome, engine::TemplateValues& values);

/// OUTCOME and its sign as text: "✓".
void fill_state(Outcome outcome, engine::TemplateValues& values);

/// A path as the link to it; of its bytes, those that mean something there are escaped.
std::string link_to(const std::string& path);

/// One more table.tpl at the marker; nothing if the table has no rows.
void fill_table(const Table& table, const std::string& marker, engine::TemplateValues& values);

/// The section FACTS; nothing if there are none.
void fill_facts(const std::vector<Fact>& facts, engine::TemplateValues& values);
/// A text of somebody's own, line by line: the variable in a repetition of the section for each
/// line that is not empty.
void fill_lines(const std::string& text, const std::string& section, const std::string& variable,
                engine::TemplateValues& values);

/// One more figure.tpl at the marker FIGURE.
void fill_figure(const FigureCard& figure, engine::TemplateValues& values,
                 const std::string& marker = "FIGURE");

}  // namespace tribolog::report::elements
