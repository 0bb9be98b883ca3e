#include "report/elements/element_values.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "base/encodings.h"
#include "base/enum_text.h"
#include "wording/torques_in.h"
#include "wording/visible_text.h"

namespace tribolog::report::elements {

std::string class_of(Outcome outcome) { return own_name(outcome); }

namespace {

/// Beside the word and the colour.
std::string icon_of(Outcome outcome) {
  return std::string(EnumTexts<Outcome>("✓", "!", "✗", "–").of(outcome));
}

const char* class_of(const Column& column) {
  if (column.is_number) return "number";
  return column.is_wide ? "text wide" : "text";
}

}  // namespace

void fill_outcome(Outcome outcome, engine::TemplateValues& values) {
  values.set("OUTCOME", class_of(outcome));
  const char* const icons[] = {"ICON_GOOD", "ICON_PARTIAL", "ICON_BAD", "ICON_ABSENT"};
  values.add_section(icons[static_cast<int>(outcome)]);
}

void fill_state(Outcome outcome, engine::TemplateValues& values) {
  values.set("OUTCOME", class_of(outcome));
  values.set("ICON", icon_of(outcome));
}

std::string link_to(const std::string& path) {
  std::string text;
  for (const char c : path) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '/' || c == '.' || c == '-' || c == '_';
    text += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return text;
}

void fill_table(const Table& table, const std::string& marker, engine::TemplateValues& values) {
  if (table.rows.empty()) return;
  engine::TemplateValues& out = values.add_include(marker, "table.tpl");
  out.set("TABLE_ID", table.id);
  out.set("TABLE_CAPTION", table.caption);
  out.set("TABLE_KIND", table.is_of_estimates ? "estimates"
                        : table.is_stacked    ? "judged"
                                              : "plain");
  for (const Column& column : table.columns) {
    engine::TemplateValues& heading = out.add_section("COLUMN");
    heading.set("HEADING", column.heading);
    heading.set("KIND", class_of(column));
    heading.set_optional("UNIT", wording::shown_units(column.unit));
  }
  for (const Row& row : table.rows) {
    engine::TemplateValues& line = out.add_section("ROW");
    line.set("ROW_KIND", row.is_chosen ? "chosen" : "plain");
    for (std::size_t i = 0; i < std::min(row.cells.size(), table.columns.size()); ++i) {
      engine::TemplateValues& cell = line.add_section(i == 0 ? "ROW_HEADING" : "CELL");
      cell.set("KIND", class_of(table.columns[i]));
      cell.set("TEXT", row.cells[i].empty() ? "–" : row.cells[i]);
      cell.set_optional("NAME", table.columns[i].heading);
    }
  }
  out.set_optional("TABLE_NOTE", table.note);
}

void fill_facts(const std::vector<Fact>& facts, engine::TemplateValues& values) {
  if (facts.empty()) return;
  engine::TemplateValues& list = values.add_section("FACTS");
  for (const Fact& fact : facts) {
    engine::TemplateValues& item = list.add_section("FACT");
    item.set("NAME", fact.name);
    item.set("TEXT", fact.text);
  }
}

void fill_lines(const std::string& text, const std::string& section, const std::string& variable,
                engine::TemplateValues& values) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!line.empty()) values.add_section(section).set(variable, line);
  }
}

namespace {

void fill_reading(const FigureCard& figure, engine::TemplateValues& values) {
  values.set_optional("HOW_TO_READ", figure.how_to_read);
  if (figure.csv.empty()) return;
  engine::TemplateValues& data = values.add_section("DATA");
  data.set("FILE", figure.id + ".csv");
  data.set_checked_by_modifier("CSV", wording::visible_text(figure.csv));
  data.set("SIZE",
           fmt::format("{:.0f} kB", std::ceil(1e-3 * static_cast<double>(figure.csv.size()))));
}

}  // namespace

void fill_figure(const FigureCard& figure, engine::TemplateValues& values,
                 const std::string& marker) {
  engine::TemplateValues& out = values.add_include(marker, "figure.tpl");
  out.set("FIGURE_ID", figure.id);
  out.set("FIGURE_HEADING", figure.heading);
  if (figure.png != nullptr) {
    engine::TemplateValues& picture = out.add_section("PICTURE");
    picture.set_checked_by_modifier("PNG", base64(*figure.png));
    picture.set("ALT", figure.alt);
    picture.set("WIDTH", std::to_string(figure.width_px));
    picture.set("HEIGHT", std::to_string(figure.height_px));
    picture.set("LOADING", figure.is_lazy ? "lazy" : "eager");
  } else {
    engine::TemplateValues& missing = out.add_section("NO_PICTURE");
    missing.set("ERROR", figure.error);
    missing.set("ALT", figure.alt);
  }
  out.set_optional("FIGURE_CAPTION", figure.caption);
  if (!figure.how_to_read.empty() || !figure.csv.empty()) {
    fill_reading(figure, out.add_section("MORE"));
  }
  for (const std::string& warning : figure.warnings) {
    if (!warning.empty()) out.add_section("WARNING").set("TEXT", warning);
  }
}

}  // namespace tribolog::report::elements
