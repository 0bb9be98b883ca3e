#include <algorithm>

#include <fmt/format.h>

#include "paper/drawings/printed_paper.h"
#include "paper/page/page_parts.h"
#include "report/element_values.h"
#include "report/view_parts.h"
#include "wording/tr.h"

namespace tribolog::paper::page {
namespace {
using checks::ItemKind;
using checks::PaperItem;
using checks::PaperSection;

using wording::tr;

/// What the paper has a number of.
struct Kind {
  checks::ItemKind kind;
  const char* many;
  int printed;
};

constexpr Kind kinds[] = {
    {checks::ItemKind::figure, wording::to_translate("Figures"), drawings::figures},
    {checks::ItemKind::table, wording::to_translate("Tables"), drawings::tables},
    {checks::ItemKind::equation, wording::to_translate("Equations"), drawings::equations},
};

bool is_drawn(const checks::PaperItem& item, const RegeneratedPaper& paper,
              const std::vector<render::workers::DrawnFigure>& drawn) {
  if (item.kind != checks::ItemKind::figure) return true;
  return std::any_of(paper.figures.begin(), paper.figures.end(),
                     [&](const figures::ReportFigure& figure) {
                       return figure.number == item.number &&
                              std::any_of(drawn.begin(), drawn.end(),
                                          [&](const render::workers::DrawnFigure& picture) {
                                            return picture.id == figure.id &&
                                                   picture.error.empty() && !picture.png.empty();
                                          });
                     });
}

bool is_well(const checks::PaperItem& item, const RegeneratedPaper& paper,
             const std::vector<render::workers::DrawnFigure>& drawn) {
  return checks::every_check_holds(item) && is_drawn(item, paper, drawn);
}

template <class Use>
void for_each_item(const RegeneratedPaper& paper, Use use) {
  for (const checks::PaperSection& section : paper.sections) {
    for (const checks::PaperItem& item : section.items) use(section, item);
  }
}

std::string sentence_of(const std::vector<PaperTally>& tallies, const checks::Tally& checks,
                        const checks::Tally& golden) {
  const PaperTally& figures = tallies.at(0);
  const PaperTally& tables = tallies.at(1);
  const PaperTally& equations = tallies.at(2);
  return tr(
      "{good_figures} of {figures} figures, {good_tables} of {tables} tables, {good_equations} of "
      "{equations} equations, each regenerated and with every check passed; {holding_checks} of "
      "{checks} checks hold, and {holding_golden} of {golden_numbers} golden numbers.",
      {{"good_figures", figures.well},
       {"figures", figures.printed},
       {"good_tables", tables.well},
       {"tables", tables.printed},
       {"good_equations", equations.well},
       {"equations", equations.printed},
       {"holding_checks", checks.hold},
       {"checks", checks.there},
       {"holding_golden", golden.hold},
       {"golden_numbers", golden.there}});
}

void fill_verdict(const RegeneratedPaper& paper, const std::vector<PaperTally>& tallies,
                  report::TemplateValues& values) {
  const checks::Tally checks = checks::tally_checks(paper.sections);
  const checks::Tally golden = checks::tally_checks(paper.golden_numbers);
  const bool all_well = checks.hold == checks.there && golden.hold == golden.there &&
                        std::all_of(tallies.begin(), tallies.end(), [](const PaperTally& tally) {
                          return tally.well == tally.printed;
                        });
  report::TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  verdict.set("WORD", all_well ? tr("THE PAPER IS REPRODUCED") : tr("NOT ALL OF IT IS REPRODUCED"));
  verdict.set("SENTENCE", sentence_of(tallies, checks, golden));
  report::fill_outcome(all_well ? report::Outcome::good : report::Outcome::bad, verdict);
  const PaperTally& figures = tallies.front();
  const int missing = figures.printed - figures.here;
  verdict.set_optional("FIGURES_MISSING",
                       missing > 0 ? tr("{missing} of {figures} figures missing",
                                        {{"missing", missing}, {"figures", figures.printed}})
                                   : "");
  report::TemplateValues* list = nullptr;
  const auto tell = [&](const std::string& where, const checks::Checks& failed) {
    for (const checks::Check& check : failed) {
      if (check.holds()) continue;
      if (list == nullptr) list = &verdict.add_section("FINDINGS");
      list->add_section("FINDING").set("TEXT", where + ": " + check.what);
    }
  };
  for_each_item(paper, [&](const checks::PaperSection&, const checks::PaperItem& item) {
    tell(item_name(item), item.checks);
  });
  tell(tr("Golden number"), paper.golden_numbers);
}

void fill_tally(const std::vector<PaperTally>& tallies, report::TemplateValues& values) {
  report::Table table;
  table.id = "table-tally";
  table.caption = tr("What the paper has, and what is regenerated here");
  table.columns = {{tr("Kind"), "", false},
                   {tr("In the paper"), "", true},
                   {tr("Regenerated"), "", true},
                   {tr("Every check holds"), "", true}};
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    const PaperTally& tally = tallies[i];
    table.rows.push_back({{tr(kinds[i].many), std::to_string(tally.printed),
                           std::to_string(tally.here), std::to_string(tally.well)},
                          false});
  }
  report::fill_table(table, "TALLY", values);
}

void fill_ticks(const RegeneratedPaper& paper,
                const std::vector<render::workers::DrawnFigure>& drawn,
                report::TemplateValues& values) {
  for (const Kind& one : kinds) {
    std::vector<const checks::PaperItem*> items;
    for_each_item(paper, [&](const checks::PaperSection&, const checks::PaperItem& item) {
      if (item.kind == one.kind) items.push_back(&item);
    });
    std::sort(items.begin(), items.end(),
              [](const checks::PaperItem* a, const checks::PaperItem* b) {
                return a->number < b->number;
              });
    report::TemplateValues& list = values.add_section("KIND");
    list.set("KIND_NAME", tr(one.many));
    for (const checks::PaperItem* item : items) {
      const bool well = is_well(*item, paper, drawn);
      report::TemplateValues& entry = list.add_section("ENTRY");
      entry.set("STATE", well ? "holds" : "fails");
      entry.set("ITEM_ID", item_anchor(*item));
      entry.set("TITLE", item->title);
      entry.set("NUMBER", std::to_string(item->number));
      entry.set("TICK", tick(well));
      entry.set("SPOKEN", well ? tr("holds") : tr("does not hold"));
    }
  }
}

}  // namespace

std::vector<PaperTally> tally_of(const RegeneratedPaper& paper,
                                 const std::vector<render::workers::DrawnFigure>& drawn) {
  std::vector<PaperTally> out;
  for (const Kind& one : kinds) {
    PaperTally tally{one.kind, one.printed, 0, 0};
    for_each_item(paper, [&](const checks::PaperSection&, const checks::PaperItem& item) {
      if (item.kind != one.kind) return;
      if (is_drawn(item, paper, drawn)) ++tally.here;
      if (is_well(item, paper, drawn)) ++tally.well;
    });
    out.push_back(tally);
  }
  return out;
}

std::string item_name(const checks::PaperItem& item) {
  switch (item.kind) {
    case checks::ItemKind::figure:
      return tr("Figure {number}", {{"number", item.number}});
    case checks::ItemKind::table:
      return tr("Table {number}", {{"number", item.number}});
    case checks::ItemKind::equation:
      return tr("Equation {number}", {{"number", item.number}});
    case checks::ItemKind::statement:
      break;
  }
  return tr("The conclusions");
}

std::string item_anchor(const checks::PaperItem& item) {
  return fmt::format("{}-{}", checks::key_of(item.kind), item.number);
}

void fill_outcome_of(const RegeneratedPaper& paper,
                     const std::vector<render::workers::DrawnFigure>& drawn,
                     report::TemplateValues& values) {
  const std::vector<PaperTally> tallies = tally_of(paper, drawn);
  fill_verdict(paper, tallies, values);
  fill_tally(tallies, values);
  fill_ticks(paper, drawn, values);
}

}  // namespace tribolog::paper::page
