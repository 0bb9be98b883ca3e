#include "report/paper_page.h"

#include <algorithm>

#include <fmt/format.h>

#include "paper/printed_paper.h"
#include "report/check_rows.h"
#include "report/closing_values.h"
#include "report/element_values.h"
#include "report/page_style.h"
#include "report/paper_json.h"
#include "report/view_parts.h"

namespace tribolog {
namespace {

using namespace report;
using paper::ItemKind;
using paper::PaperItem;
using paper::PaperSection;

struct KindWords {
  ItemKind kind;
  const char* one;   ///< "Figure", and in anchors.
  const char* many;  ///< "Figures"
  int printed;
};

constexpr KindWords kinds[] = {
    {ItemKind::figure, "Figure", "Figures", paper::printed::figures},
    {ItemKind::table, "Table", "Tables", paper::printed::tables},
    {ItemKind::equation, "Equation", "Equations", paper::printed::equations},
    {ItemKind::statement, "Statement", "Statements", 0},
};

const KindWords& words_of(ItemKind kind) {
  return *std::find_if(std::begin(kinds), std::end(kinds),
                       [kind](const KindWords& words) { return words.kind == kind; });
}

std::string lower_case(std::string word) {
  word.front() = static_cast<char>(word.front() - 'A' + 'a');
  return word;
}

std::string anchor(const PaperItem& item) {
  return fmt::format("{}-{}", lower_case(words_of(item.kind).one), item.number);
}

std::string section_anchor(const PaperSection& section) {
  std::string id = "section-" + section.number;
  std::replace(id.begin(), id.end(), '.', '-');
  return id;
}

bool is_drawn(const PaperItem& item, const RegeneratedPaper& paper,
              const std::vector<render::DrawnFigure>& drawn) {
  if (item.kind != ItemKind::figure) return true;
  return std::any_of(paper.figures.begin(), paper.figures.end(), [&](const ReportFigure& figure) {
    return figure.number == item.number &&
           std::any_of(drawn.begin(), drawn.end(), [&](const render::DrawnFigure& picture) {
             return picture.id == figure.id && picture.error.empty() && !picture.png.empty();
           });
  });
}

bool is_well(const PaperItem& item, const RegeneratedPaper& paper,
             const std::vector<render::DrawnFigure>& drawn) {
  const paper::Tally checks = paper::tally_checks(item.checks);
  return checks.there > 0 && checks.hold == checks.there && is_drawn(item, paper, drawn);
}

template <class Use>
void for_each_item(const RegeneratedPaper& paper, Use use) {
  for (const PaperSection& section : paper.sections) {
    for (const PaperItem& item : section.items) use(section, item);
  }
}

std::string of(int well, int all, const std::string& what) {
  return fmt::format("{} of {} {}", well, all, what);
}

void fill_outcome_of(const RegeneratedPaper& paper, const std::vector<PaperTally>& tallies,
                     TemplateValues& values) {
  const paper::Tally checks = paper::tally_checks(paper.sections);
  const paper::Tally golden = paper::tally_checks(paper.golden_numbers);
  bool all_well = checks.hold == checks.there && golden.hold == golden.there;
  std::string sentence;
  for (const PaperTally& tally : tallies) {
    all_well = all_well && tally.well == tally.printed;
    sentence += of(tally.well, tally.printed, tally.kind) + ", ";
  }
  sentence += fmt::format("each regenerated and with every check held; {}, and {}.",
                          of(checks.hold, checks.there, "checks hold"),
                          of(golden.hold, golden.there, "golden numbers"));
  TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  verdict.set("WORD", all_well ? "THE PAPER IS REPRODUCED" : "NOT ALL OF IT IS REPRODUCED");
  verdict.set("SENTENCE", sentence);
  fill_outcome(all_well ? Outcome::good : Outcome::bad, verdict);
  const PaperTally& figures = tallies.front();
  const int missing = figures.printed - figures.here;
  verdict.set_optional("FIGURES_MISSING",
                       missing > 0 ? of(missing, figures.printed, "figures missing") : "");
  TemplateValues* list = nullptr;
  const auto tell = [&](const std::string& where, const paper::Checks& failed) {
    for (const paper::Check& check : failed) {
      if (check.holds()) continue;
      if (list == nullptr) list = &verdict.add_section("FINDINGS");
      list->add_section("FINDING").set("TEXT", where + ": " + check.what);
    }
  };
  for_each_item(paper, [&](const PaperSection&, const PaperItem& item) {
    tell(fmt::format("{} {}", words_of(item.kind).one, item.number), item.checks);
  });
  tell("Golden number", paper.golden_numbers);
}

void fill_tally(const std::vector<PaperTally>& tallies, TemplateValues& values) {
  Table table;
  table.id = "table-tally";
  table.caption = "What the paper has, and what is regenerated here";
  table.columns = {{"Kind", "", false},
                   {"In the paper", "", true},
                   {"Regenerated", "", true},
                   {"Every check holds", "", true}};
  for (const PaperTally& tally : tallies) {
    table.rows.push_back(
        {{as_sentence(tally.kind).substr(0, tally.kind.size()), std::to_string(tally.printed),
          std::to_string(tally.here), std::to_string(tally.well)},
         false});
  }
  fill_table(table, "TALLY", values);
}

void fill_ticks(const RegeneratedPaper& paper, const std::vector<render::DrawnFigure>& drawn,
                TemplateValues& values) {
  for (const KindWords& words : kinds) {
    if (words.printed == 0) continue;
    std::vector<const PaperItem*> items;
    for_each_item(paper, [&](const PaperSection&, const PaperItem& item) {
      if (item.kind == words.kind) items.push_back(&item);
    });
    std::sort(items.begin(), items.end(),
              [](const PaperItem* a, const PaperItem* b) { return a->number < b->number; });
    TemplateValues& list = values.add_section("KIND");
    list.set("KIND_NAME", words.many);
    for (const PaperItem* item : items) {
      const bool well = is_well(*item, paper, drawn);
      TemplateValues& entry = list.add_section("ENTRY");
      entry.set("STATE", well ? "holds" : "fails");
      entry.set("ITEM_ID", anchor(*item));
      entry.set("TITLE", item->title);
      entry.set("NUMBER", std::to_string(item->number));
      entry.set("TICK", tick(well));
      entry.set("SPOKEN", well ? "holds" : "does not hold");
    }
  }
}

std::string heading_of(const PaperItem& item) {
  switch (item.kind) {
    case ItemKind::figure:
      return "";  // the figure brings its own
    case ItemKind::statement:
      return item.title;
    case ItemKind::equation:
      return fmt::format("Equation ({}): {}", item.number, item.title);
    case ItemKind::table:
      break;
  }
  return fmt::format("Table {}: {}", item.number, item.title);
}

void fill_item(const PaperItem& item, const std::vector<ReportFigure>& figures,
               const std::vector<FigureCard>& cards, TemplateValues& section) {
  TemplateValues& out = section.add_include("ITEM", "paper_item.tpl");
  out.set("ITEM_ID", anchor(item));
  out.set_optional("HEADING", heading_of(item));
  if (item.kind == ItemKind::equation) {
    out.add_include("EQUATION", "equations.tpl")
        .add_section(fmt::format("EQUATION_{}", item.number));
  }
  if (item.kind == ItemKind::figure) {
    for (std::size_t i = 0; i < cards.size(); ++i) {
      if (figures[i].number == item.number) fill_figure(cards[i], out);
    }
  }
  out.set_optional("REMARK", item.remark);
  const std::string name =
      item.kind == ItemKind::statement
          ? std::string("the conclusions")
          : fmt::format("{} {}", lower_case(words_of(item.kind).one), item.number);
  const paper::Tally tally = paper::tally_checks(item.checks);
  fill_checks(item.checks, anchor(item),
              fmt::format("Checks of {}: {} of {} hold", name, tally.hold, tally.there), "CHECKS",
              out);
}

/// Section 3.4 in full: curves, masses, errors, choice.
void fill_selection(const Calibration& calibration, TemplateValues& section) {
  const auto add = [&](const char* id, void (*describe)(const Calibration&, Section&)) {
    Section stage;
    stage.id = id;
    describe(calibration, stage);
    for (const Table& table : stage.tables) fill_table(table, "TABLE", section);
  };
  add("curves", describe_viscous_curves);
  add("masses", describe_surrogate_masses);
  add("errors", describe_quality_errors);
  add("choice", describe_selection);
}

}  // namespace

std::vector<PaperTally> tally_of(const RegeneratedPaper& paper,
                                 const std::vector<render::DrawnFigure>& drawn) {
  std::vector<PaperTally> out;
  for (const KindWords& words : kinds) {
    if (words.printed == 0) continue;
    PaperTally tally{lower_case(words.many), words.printed, 0, 0};
    for_each_item(paper, [&](const PaperSection&, const PaperItem& item) {
      if (item.kind != words.kind) return;
      if (is_drawn(item, paper, drawn)) ++tally.here;
      if (is_well(item, paper, drawn)) ++tally.well;
    });
    out.push_back(std::move(tally));
  }
  return out;
}

std::string paper_page(const RegeneratedPaper& paper, const Calibration& calibration,
                       const std::vector<render::DrawnFigure>& drawn) {
  TemplateValues values;
  fill_style(values);
  values.set("TOOL", "tribolog " + paper.provenance.tool_version);
  values.set("CREATED", or_dash(paper.provenance.created_utc));
  const std::vector<PaperTally> tallies = tally_of(paper, drawn);
  fill_outcome_of(paper, tallies, values);
  fill_tally(tallies, values);
  fill_ticks(paper, drawn, values);
  const std::vector<FigureCard> cards = figure_cards(paper.figures, drawn);
  for (const PaperSection& section : paper.sections) {
    TemplateValues& entry = values.add_section("CONTENTS_ENTRY");
    TemplateValues& out = values.add_section("PAPER_SECTION");
    for (TemplateValues* both : {&entry, &out}) {
      both->set("SECTION_ID", section_anchor(section));
      both->set("NUMBER", section.number);
      both->set("TITLE", section.title);
    }
    for (const PaperItem& item : section.items) fill_item(item, paper.figures, cards, out);
    const bool is_selection = std::any_of(
        section.items.begin(), section.items.end(),
        [](const PaperItem& item) { return item.kind == ItemKind::equation && item.number == 14; });
    if (is_selection) fill_selection(calibration, out);
  }
  fill_checks(paper.golden_numbers, "golden", "Given, computed, and the difference", "GOLDEN",
              values);
  fill_errata(errata_numbers(), "section 3.4", values);
  for (const PaperSource& source : paper.sources) {
    TemplateValues& file = values.add_section("SOURCE_FILE");
    file.set("FILE_NAME", source.name);
    file.set("FILE_TEXT", source.text);
  }
  fill_provenance(paper.provenance.command_line, or_dash(paper.provenance.created_utc), {},
                  provenance_tables(calibration, paper.provenance), values);
  values.set_checked_by_modifier("RESULT_JSON", paper_json(paper));
  return expand_template("paper.tpl", values);
}

}  // namespace tribolog
