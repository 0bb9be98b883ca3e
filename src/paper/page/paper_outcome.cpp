#include "paper/page/paper_outcome.h"

#include <algorithm>

#include <fmt/format.h>

#include "paper/drawings/printed_paper.h"
#include "paper/page/check_rows.h"
#include "report/element_values.h"
#include "report/view_parts.h"

namespace tribolog::paper::page {
namespace {
using checks::ItemKind;
using checks::PaperItem;
using checks::PaperSection;

struct KindWords {
  checks::ItemKind kind;
  const char* one;   ///< "Figure", and in anchors.
  const char* many;  ///< "Figures"
  int printed;
};

constexpr KindWords kinds[] = {
    {checks::ItemKind::figure, "Figure", "Figures", drawings::figures},
    {checks::ItemKind::table, "Table", "Tables", drawings::tables},
    {checks::ItemKind::equation, "Equation", "Equations", drawings::equations},
    {checks::ItemKind::statement, "Statement", "Statements", 0},
};

const KindWords& words_of(checks::ItemKind kind) {
  return *std::find_if(std::begin(kinds), std::end(kinds),
                       [kind](const KindWords& words) { return words.kind == kind; });
}

std::string lower_case(std::string word) {
  word.front() = static_cast<char>(word.front() - 'A' + 'a');
  return word;
}

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

std::string of(int well, int all, const std::string& what) {
  return fmt::format("{} of {} {}", well, all, what);
}

void fill_verdict(const RegeneratedPaper& paper, const std::vector<PaperTally>& tallies,
                  report::TemplateValues& values) {
  const checks::Tally checks = checks::tally_checks(paper.sections);
  const checks::Tally golden = checks::tally_checks(paper.golden_numbers);
  bool all_well = checks.hold == checks.there && golden.hold == golden.there;
  std::string sentence;
  for (const PaperTally& tally : tallies) {
    all_well = all_well && tally.well == tally.printed;
    sentence += of(tally.well, tally.printed, tally.kind) + ", ";
  }
  sentence += fmt::format("each regenerated and with every check held; {}, and {}.",
                          of(checks.hold, checks.there, "checks hold"),
                          of(golden.hold, golden.there, "golden numbers"));
  report::TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  verdict.set("WORD", all_well ? "THE PAPER IS REPRODUCED" : "NOT ALL OF IT IS REPRODUCED");
  verdict.set("SENTENCE", sentence);
  report::fill_outcome(all_well ? report::Outcome::good : report::Outcome::bad, verdict);
  const PaperTally& figures = tallies.front();
  const int missing = figures.printed - figures.here;
  verdict.set_optional("FIGURES_MISSING",
                       missing > 0 ? of(missing, figures.printed, "figures missing") : "");
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
  tell("Golden number", paper.golden_numbers);
}

void fill_tally(const std::vector<PaperTally>& tallies, report::TemplateValues& values) {
  report::Table table;
  table.id = "table-tally";
  table.caption = "What the paper has, and what is regenerated here";
  table.columns = {{"Kind", "", false},
                   {"In the paper", "", true},
                   {"Regenerated", "", true},
                   {"Every check holds", "", true}};
  for (const PaperTally& tally : tallies) {
    table.rows.push_back(
        {{report::as_sentence(tally.kind).substr(0, tally.kind.size()),
          std::to_string(tally.printed), std::to_string(tally.here), std::to_string(tally.well)},
         false});
  }
  report::fill_table(table, "TALLY", values);
}

void fill_ticks(const RegeneratedPaper& paper,
                const std::vector<render::workers::DrawnFigure>& drawn,
                report::TemplateValues& values) {
  for (const KindWords& words : kinds) {
    if (words.printed == 0) continue;
    std::vector<const checks::PaperItem*> items;
    for_each_item(paper, [&](const checks::PaperSection&, const checks::PaperItem& item) {
      if (item.kind == words.kind) items.push_back(&item);
    });
    std::sort(items.begin(), items.end(),
              [](const checks::PaperItem* a, const checks::PaperItem* b) {
                return a->number < b->number;
              });
    report::TemplateValues& list = values.add_section("KIND");
    list.set("KIND_NAME", words.many);
    for (const checks::PaperItem* item : items) {
      const bool well = is_well(*item, paper, drawn);
      report::TemplateValues& entry = list.add_section("ENTRY");
      entry.set("STATE", well ? "holds" : "fails");
      entry.set("ITEM_ID", item_anchor(*item));
      entry.set("TITLE", item->title);
      entry.set("NUMBER", std::to_string(item->number));
      entry.set("TICK", tick(well));
      entry.set("SPOKEN", well ? "holds" : "does not hold");
    }
  }
}

}  // namespace

std::vector<PaperTally> tally_of(const RegeneratedPaper& paper,
                                 const std::vector<render::workers::DrawnFigure>& drawn) {
  std::vector<PaperTally> out;
  for (const KindWords& words : kinds) {
    if (words.printed == 0) continue;
    PaperTally tally{lower_case(words.many), words.printed, 0, 0};
    for_each_item(paper, [&](const checks::PaperSection&, const checks::PaperItem& item) {
      if (item.kind != words.kind) return;
      if (is_drawn(item, paper, drawn)) ++tally.here;
      if (is_well(item, paper, drawn)) ++tally.well;
    });
    out.push_back(std::move(tally));
  }
  return out;
}

std::string item_name(const checks::PaperItem& item) {
  if (item.kind == checks::ItemKind::statement) return "The conclusions";
  return fmt::format("{} {}", words_of(item.kind).one, item.number);
}

std::string item_anchor(const checks::PaperItem& item) {
  return fmt::format("{}-{}", lower_case(words_of(item.kind).one), item.number);
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
