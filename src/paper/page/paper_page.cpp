#include "paper/page/paper_page.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/enum_text.h"
#include "paper/page/page_parts.h"
#include "report/document/report_values.h"
#include "report/document/view_parts.h"
#include "report/elements/element_values.h"
#include "report/elements/elements.h"
#include "report/elements/figure_cards.h"
#include "report/engine/page_style.h"
#include "report/engine/template_engine.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::paper::page {

void fit_to_page(std::vector<figures::ReportFigure>& figures) {
  const auto fitted = [](int size_px) { return 3 * size_px / 4; };
  for (figures::ReportFigure& figure : figures) {
    figure.figure.width_px = fitted(figure.figure.width_px);
    figure.figure.height_px = fitted(figure.figure.height_px);
  }
}

// The checks of the paper for machines.

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json list_of(const checks::Checks& checks) {
  Json list = Json::array();
  for (const checks::Check& check : checks) {
    Json one{{"what", check.what}, {"kind", own_name(check.kind)}};
    if (check.is_words()) {
      one["expected"] = check.expected_words;
      one["ours"] = check.ours_words;
    } else {
      one["expected"] = number(check.expected);
      one["ours"] = number(check.ours);
      one["difference"] = number(check.difference());
      one["allowed"] = number(check.bound);
      one["unit"] = check.unit;
    }
    one["holds"] = check.holds();
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace

std::string paper_json(const RegeneratedPaper& paper) {
  Json items = Json::array();
  for (const checks::PaperSection& section : paper.sections) {
    for (const checks::PaperItem& item : section.items) {
      items.push_back({{"kind", checks::key_of(item.kind)},
                       {"number", item.number},
                       {"section", section.number},
                       {"title", item.title},
                       {"checks", list_of(item.checks)},
                       {"told", item.unchecked}});
    }
  }
  Json whole{{"schema", "tribolog-paper-2"},
             {"tool", paper.provenance.tool_version},
             {"items", std::move(items)}};
  return whole.dump();
}

namespace {

using checks::ItemKind;
using checks::PaperItem;
using checks::PaperSection;
using wording::tr;

std::string section_anchor(const checks::PaperSection& section) {
  std::string id = "section-" + section.number;
  std::replace(id.begin(), id.end(), '.', '-');
  return id;
}

std::string heading_of(const checks::PaperItem& item) {
  switch (item.kind) {
    case checks::ItemKind::figure:
      return "";  // the figure brings its own
    case checks::ItemKind::statement:
      return item.title;
    case checks::ItemKind::equation:
      return tr("Equation ({number}): {title}", {{"number", item.number}, {"title", item.title}});
    case checks::ItemKind::table:
      break;
  }
  return tr("Table {number}: {title}", {{"number", item.number}, {"title", item.title}});
}

void fill_item(const checks::PaperItem& item, const calibration::Calibration& calibration,
               const std::vector<figures::ReportFigure>& figures,
               const std::vector<report::elements::FigureCard>& cards,
               report::engine::TemplateValues& section) {
  report::engine::TemplateValues& out = section.add_include("ITEM", "paper_item.tpl");
  out.set("ITEM_ID", item_anchor(item));
  out.set_optional("HEADING", heading_of(item));
  if (item.kind == checks::ItemKind::equation) {
    out.add_include("EQUATION", "equations.tpl")
        .add_section(fmt::format("EQUATION_{}", item.number));
  }
  if (item.kind == checks::ItemKind::figure) {
    for (std::size_t i = 0; i < cards.size(); ++i) {
      if (figures[i].paper_number == item.number) report::elements::fill_figure(cards[i], out);
    }
  }
  if (item.kind == checks::ItemKind::table && item.number == 2) {
    report::elements::fill_table(table_2(calibration), "TABLE", out);
  }
  out.set_optional("REMARK", item.remark);
  const checks::Tally tally = checks::tally_checks(item.checks);
  const std::string caption = tr(
      "{item}: {holding_checks} of {checks} checks hold",
      {{"item", checks::item_name(item)}, {"holding_checks", tally.hold}, {"checks", tally.there}});
  // Where all hold, their number says it. What is stated without a check, or of the paper's words,
  // is the item itself.
  const bool is_folded = !item.checks.empty() && tally.hold == tally.there;
  report::engine::TemplateValues& place = is_folded ? out.add_section("FOLD") : out;
  if (is_folded) place.set("WHAT", caption);
  report::engine::TemplateValues& details = place.add_include("DETAILS", "paper_details.tpl");
  if (!item.printed_caption.empty()) {
    details.set_optional("IN_PRINT",
                         tr("Caption in print: “{caption}”.", {{"caption", item.printed_caption}}));
  }
  fill_checks(item.checks, item_anchor(item), caption, "CHECKS", details);
  if (item.unchecked.empty()) return;
  const bool is_of_words = item.kind == checks::ItemKind::statement;
  report::engine::TemplateValues& stated =
      (is_folded && is_of_words ? out.add_include("DETAILS", "paper_details.tpl") : details)
          .add_section("TOLD");
  for (const std::string& text : item.unchecked) stated.add_section("ENTRY").set("TEXT", text);
}

}  // namespace

void fill_selection(const calibration::Calibration& calibration,
                    report::engine::TemplateValues& section) {
  const auto add = [&](const char* id, void (*describe)(const calibration::Calibration&,
                                                        report::document::Section&)) {
    report::document::Section stage;
    stage.id = id;
    describe(calibration, stage);
    for (const report::elements::Table& table : stage.tables)
      report::elements::fill_table(table, "TABLE", section);
  };
  add("curves", report::document::describe_viscous_curves);
  add("masses", report::document::describe_surrogate_masses);
  add("errors", report::document::describe_quality_errors);
  add("choice", report::document::describe_selection);
  report::elements::fill_table(fits_of_equation_6(calibration), "TABLE", section);
}

std::string paper_page(const RegeneratedPaper& paper, const calibration::Calibration& calibration,
                       const std::vector<render::workers::DrawnFigure>& drawn,
                       const std::string& json, wording::Language language) {
  report::engine::TemplateValues values;
  report::engine::fill_head(paper.provenance, values);
  fill_outcome_of(paper, drawn, values);
  const std::vector<report::elements::FigureCard> cards =
      report::elements::figure_cards(paper.figures, drawn);
  for (const checks::PaperSection& section : paper.sections) {
    report::engine::TemplateValues& entry = values.add_section("CONTENTS_ENTRY");
    report::engine::TemplateValues& out = values.add_section("PAPER_SECTION");
    for (report::engine::TemplateValues* both : {&entry, &out}) {
      both->set("SECTION_ID", section_anchor(section));
      both->set("NUMBER", section.number);
      both->set("TITLE", section.title);
    }
    for (const checks::PaperItem& item : section.items) {
      fill_item(item, calibration, paper.figures, cards, out);
    }
    const bool is_selection =
        std::any_of(section.items.begin(), section.items.end(), [](const checks::PaperItem& item) {
          return item.kind == checks::ItemKind::equation && item.number == 14;
        });
    if (is_selection) fill_selection(calibration, out.add_section("SELECTION"));
  }
  fill_errata(paper.presliding, values);
  for (const PaperSource& source : paper.sources) {
    report::engine::TemplateValues& file = values.add_section("SOURCE_FILE");
    file.set("FILE_NAME", source.name);
    file.set("FILE_TEXT", source.text);
  }
  report::document::fill_provenance(
      paper.provenance.command_line, wording::or_dash(paper.provenance.created_utc), {},
      report::document::provenance_tables(calibration, paper.provenance), values);
  values.set_checked_by_modifier("RESULT_JSON", json);
  return report::engine::expand_template("paper.tpl", values, language);
}

}  // namespace tribolog::paper::page
