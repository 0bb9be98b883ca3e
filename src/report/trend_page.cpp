#include "report/trend_page.h"

#include <algorithm>

#include <fmt/format.h>

#include "history/trend_json.h"
#include "report/element_values.h"
#include "report/page_style.h"
#include "report/trend_view.h"
#include "report/view_parts.h"

namespace tribolog {
namespace {

using namespace report;
using history::JointTrend;
using history::TrendState;

TrendState worst_of(const std::vector<JointTrend>& trends) {
  TrendState worst = TrendState::too_few;
  for (const JointTrend& t : trends) worst = std::max(worst, t.state());
  return worst;
}

std::string title_of(const JointTrend& t) {
  return fmt::format("{}{}{}, joint {}", or_dash(t.of.robot), t.of.serial.empty() ? "" : " ",
                     t.of.serial, or_dash(t.of.joint));
}

struct Headline {
  const char* word;
  const char* sentence;
  Outcome outcome;
};

Headline headline_of(TrendState state) {
  switch (state) {
    case TrendState::warning:
      return {"CHANGED", "A change stands that is larger than what calibrations scatter.",
              Outcome::bad};
    case TrendState::recovered:
      return {"CHANGED, AND BACK", "There was a change; the values are back.", Outcome::partial};
    case TrendState::steady:
      return {"NO CHANGE VISIBLE", "No quantity has left what its calibrations let expect.",
              Outcome::good};
    case TrendState::too_few:
      break;
  }
  return {"TOO FEW YET", "There are too few calibrations to say anything about a change.",
          Outcome::absent};
}

void fill_verdict(const std::vector<JointTrend>& trends, TemplateValues& values) {
  TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  const Headline headline = headline_of(worst_of(trends));
  verdict.set("WORD", headline.word);
  verdict.set("SENTENCE", headline.sentence);
  fill_outcome(headline.outcome, verdict);
  std::vector<std::string> findings;
  for (const JointTrend& t : trends) {
    for (const std::string& change : change_sentences(t)) {
      findings.push_back(trends.size() > 1 ? title_of(t) + ": " + change : change);
    }
  }
  if (findings.empty()) return;
  TemplateValues& list = verdict.add_section("FINDINGS");
  for (const std::string& text : findings) list.add_section("FINDING").set("TEXT", text);
}

bool belongs_to(const FigureCard& card, std::size_t joint) {
  return card.id.rfind(fmt::format("trend-{}-", joint + 1), 0) == 0;
}

void fill_joint(const JointTrend& t, std::size_t k, const std::vector<FigureCard>& cards,
                TemplateValues& values) {
  TemplateValues& section = values.add_section("JOINT");
  section.set("JOINT_ID", fmt::format("joint-{}", k + 1));
  section.set("JOINT_TITLE", title_of(t));
  section.set("JOINT_WORDS", as_sentence(joint_words(t)));
  fill_table(trend_table(t, fmt::format("table-joint-{}", k + 1)), "TREND", section);
  const std::vector<std::string> notes = trend_notes(t);
  if (!notes.empty()) {
    TemplateValues& list = section.add_section("NOTES");
    for (const std::string& note : notes) list.add_section("NOTE").set("TEXT", note);
  }
  section.set("CHART_WORDS", chart_words(t));
  for (const FigureCard& card : cards) {
    if (belongs_to(card, k)) fill_figure(card, section);
  }
}

}  // namespace

std::string trend_page(const std::vector<JointTrend>& trends, const Provenance& provenance,
                       const std::vector<ReportFigure>& figures,
                       const std::vector<render::DrawnFigure>& drawn, Language language) {
  TemplateValues values;
  fill_head(provenance, values);
  values.set("TITLE", trends.size() == 1 ? title_of(trends.front())
                                         : fmt::format("{} joints", trends.size()));
  fill_verdict(trends, values);
  const std::vector<FigureCard> cards = figure_cards(figures, drawn);
  for (std::size_t k = 0; k < trends.size(); ++k) {
    TemplateValues& link = values.add_section("JOINT_LINK");
    link.set("LINK_ID", fmt::format("joint-{}", k + 1));
    link.set("LINK_TITLE", title_of(trends[k]));
    fill_joint(trends[k], k, cards, values);
  }
  values.set_checked_by_modifier("RESULT_JSON", history::trend_json(trends));
  return expand_template("trend.tpl", values, language);
}

}  // namespace tribolog
