#include <algorithm>

#include <fmt/format.h>

#include "paper/drawings/printed_paper.h"
#include "paper/page/page_parts.h"
#include "report/elements/element_values.h"
#include "report/elements/elements.h"
#include "report/engine/template_engine.h"
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
                       return figure.paper_number == item.number &&
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

std::string sentence_of(const RegeneratedPaper& paper, const std::vector<PaperTally>& tallies) {
  const PaperTally& figures = tallies.at(0);
  const PaperTally& tables = tallies.at(1);
  const PaperTally& equations = tallies.at(2);
  const checks::Tally print = checks::tally_checks(paper.sections, checks::Kind::print);
  const checks::Tally independent = checks::tally_checks(paper.sections, checks::Kind::independent);
  return tr("{holding_print} of {print_checks} numbers, signs and orders that the paper prints are "
            "found again on its joint, {to_the_last_place} of them to the last printed place.",
            {{"holding_print", print.hold},
             {"print_checks", print.there},
             {"to_the_last_place", checks::to_the_last_place(paper.sections)}}) +
         " " +
         tr("{holding_independent} of {independent_checks} independent computations agree with the "
            "program; {unchecked} definitions and values taken from print are stated, not checked.",
            {{"holding_independent", independent.hold},
             {"independent_checks", independent.there},
             {"unchecked", checks::count_unchecked(paper.sections)}}) +
         " " +
         tr("{figures} of {printed_figures} figures, {tables} of {printed_tables} tables and "
            "{equations} of {printed_equations} equations are here.",
            {{"figures", figures.here},
             {"printed_figures", figures.printed},
             {"tables", tables.here},
             {"printed_tables", tables.printed},
             {"equations", equations.here},
             {"printed_equations", equations.printed}});
}

void fill_verdict(const RegeneratedPaper& paper, const std::vector<PaperTally>& tallies,
                  report::engine::TemplateValues& values) {
  const bool all_well = is_all_well(paper, tallies);
  report::engine::TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  verdict.set("WORD", all_well ? tr("WHAT THE PAPER PRINTS IS FOUND AGAIN")
                               : tr("NOT ALL THAT THE PAPER PRINTS IS FOUND AGAIN"));
  verdict.set("SENTENCE", sentence_of(paper, tallies));
  report::elements::fill_outcome(
      all_well ? report::elements::Outcome::good : report::elements::Outcome::bad, verdict);
  const PaperTally& figures = tallies.front();
  const int missing = figures.printed - figures.here;
  verdict.set_optional("FIGURES_MISSING",
                       missing > 0 ? tr("{missing} of {figures} figures missing",
                                        {{"missing", missing}, {"figures", figures.printed}})
                                   : "");
  report::engine::TemplateValues* list = nullptr;
  const auto tell = [&](const std::string& where, const checks::Checks& failed) {
    for (const checks::Check& check : failed) {
      if (check.holds()) continue;
      if (list == nullptr) list = &verdict.add_section("FINDINGS");
      list->add_section("FINDING").set("TEXT", where + ": " + check.what);
    }
  };
  for_each_item(paper, [&](const checks::PaperSection&, const checks::PaperItem& item) {
    tell(checks::item_name(item), item.checks);
  });
}

void fill_tally(const std::vector<PaperTally>& tallies, report::engine::TemplateValues& values) {
  report::elements::Table table;
  table.id = "table-tally";
  table.caption = tr("What the paper has, and what is regenerated here");
  table.columns = {{tr("Kind"), "", false},
                   {tr("In the paper"), "", true},
                   {tr("Regenerated"), "", true},
                   {tr("No check fails"), "", true}};
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    const PaperTally& tally = tallies[i];
    table.rows.push_back({{tr(kinds[i].many), std::to_string(tally.printed),
                           std::to_string(tally.here), std::to_string(tally.well)},
                          false});
  }
  report::elements::fill_table(table, "TALLY", values);
}

void fill_ticks(const RegeneratedPaper& paper,
                const std::vector<render::workers::DrawnFigure>& drawn,
                report::engine::TemplateValues& values) {
  for (const Kind& one : kinds) {
    std::vector<const checks::PaperItem*> items;
    for_each_item(paper, [&](const checks::PaperSection&, const checks::PaperItem& item) {
      if (item.kind == one.kind) items.push_back(&item);
    });
    std::sort(items.begin(), items.end(),
              [](const checks::PaperItem* a, const checks::PaperItem* b) {
                return a->number < b->number;
              });
    report::engine::TemplateValues& list = values.add_section("KIND");
    list.set("KIND_NAME", tr(one.many));
    for (const checks::PaperItem* item : items) {
      const bool well = is_well(*item, paper, drawn);
      report::engine::TemplateValues& entry = list.add_section("ENTRY");
      entry.set("STATE", well ? "holds" : "fails");
      entry.set("ITEM_ID", item_anchor(*item));
      entry.set("TITLE", item->title);
      entry.set("NUMBER", std::to_string(item->number));
      entry.set("TICK", tick(well));
      entry.set("SPOKEN", well ? tr("no check fails") : tr("a check fails"));
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

bool is_all_well(const RegeneratedPaper& paper, const std::vector<PaperTally>& tallies) {
  const auto all_hold = [&](checks::Kind kind) {
    const checks::Tally tally = checks::tally_checks(paper.sections, kind);
    return tally.hold == tally.there;
  };
  return all_hold(checks::Kind::print) && all_hold(checks::Kind::independent) &&
         std::all_of(tallies.begin(), tallies.end(),
                     [](const PaperTally& tally) { return tally.well == tally.printed; });
}

std::string item_anchor(const checks::PaperItem& item) {
  return fmt::format("{}-{}", checks::key_of(item.kind), item.number);
}

void fill_outcome_of(const RegeneratedPaper& paper,
                     const std::vector<render::workers::DrawnFigure>& drawn,
                     report::engine::TemplateValues& values) {
  const std::vector<PaperTally> tallies = tally_of(paper, drawn);
  fill_verdict(paper, tallies, values);
  fill_tally(tallies, values);
  fill_ticks(paper, drawn, values);
}

}  // namespace tribolog::paper::page
