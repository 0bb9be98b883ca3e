#include "report/trend_page.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "history/history_json.h"
#include "history/quantity_traits.h"
#include "history/reference_line.h"
#include "report/element_values.h"
#include "report/page_style.h"
#include "report/view_parts.h"
#include "statistics/distributions.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/units.h"

namespace tribolog::report {

namespace {

using history::FoundChange;
using history::JointTrend;
using history::LeftOut;
using history::QuantityTrend;
using history::TemperatureUse;
using history::TrendState;

constexpr history::LeftOut all_left_out[] = {
    history::LeftOut::before_baseline, history::LeftOut::not_usable, history::LeftOut::other_gear,
    history::LeftOut::other_payload, history::LeftOut::no_temperature};

std::string day(const std::string& utc) { return utc.substr(0, std::string("2026-01-31").size()); }

std::string size_of(const history::FoundChange& c, const std::string& unit) {
  if (c.percent) {
    const double half = std::abs(c.size.half_width() * *c.percent / c.size.value);
    return wording::in_words(statistics::symmetric_estimate(std::abs(*c.percent), half), {1, "%"});
  }
  return wording::in_words(
      statistics::symmetric_estimate(std::abs(c.size.value), c.size.half_width()),
      wording::quantity_scale(unit, c.size.value));
}

std::string change_sentence(const history::QuantityTrend& q, const history::FoundChange& c) {
  if (c.is_slow) {
    return as_sentence(fmt::format("{} has slowly {} by {} since {}, visible from {}", q.words,
                                   c.direction > 0 ? "risen" : "fallen", size_of(c, q.unit),
                                   day(c.from), day(c.alarm)));
  }
  const bool is_over = !c.back.empty();
  std::string words = fmt::format("{} {} {} by {}, visible from {} (alarm on {})", q.words,
                                  is_over ? "had" : "has", c.direction > 0 ? "risen" : "fallen",
                                  size_of(c, q.unit), day(c.from), day(c.alarm));
  if (is_over) words += ", and is back from " + day(c.back);
  return as_sentence(words);
}

std::string level_text(const history::QuantityTrend& q) {
  if (!q.reference) return or_dash("");
  const double half_width = statistics::normal_975 * std::sqrt(q.reference->level_variance);
  return wording::in_words(statistics::symmetric_estimate(q.reference->level, half_width),
                           wording::quantity_scale(q.unit, q.reference->level));
}

/// Of a single calibration about the reference.
std::string scatter_text(const history::QuantityTrend& q) {
  if (!q.reference) return or_dash("");
  const double scatter = q.reference->scatter();
  const double level = std::abs(q.reference->level);
  if (!history::traits_of(q.name).is_angle && level > scatter) {
    return wording::significant(100 * scatter / level, 2) + " %";
  }
  const wording::Scale scale = wording::quantity_scale(q.unit, scatter);
  return wording::with_unit(wording::significant(scatter * scale.factor, 2), scale.unit);
}

std::string temperature_text(const history::QuantityTrend& q) {
  if (q.temperature != history::TemperatureUse::corrected || !q.reference) return or_dash("");
  const double to_percent = 100 / std::abs(q.reference->level);
  return wording::in_words(
      statistics::symmetric_estimate(
          q.reference->slope_per_K * to_percent,
          statistics::normal_975 * std::sqrt(q.reference->slope_variance) * to_percent),
      {1, "%/K"});
}

std::string state_text(const history::QuantityTrend& q) {
  std::string text = history::to_string(q.state);
  if (!q.changes.empty()) text += " from " + day(q.changes.back().from);
  if (!q.changes.empty() && q.changes.back().is_slow) {
    return "slow drift, visible from " + day(q.changes.back().alarm);
  }
  if (q.state == history::TrendState::recovered) {
    text = fmt::format("changed from {}, back from {}", day(q.changes.back().from),
                       day(q.changes.back().back));
  }
  return text;
}

void add_left_out(const history::QuantityTrend& q, std::vector<std::string>& notes) {
  std::vector<std::string> parts;
  for (const history::LeftOut why : all_left_out) {
    if (const std::size_t n = q.count(why); n > 0) {
      parts.push_back(fmt::format("{} ({})", n, history::to_string(why)));
    }
  }
  if (q.without_estimate > 0) {
    parts.push_back(fmt::format("{} (without an estimate)", q.without_estimate));
  }
  if (parts.empty()) return;
  notes.push_back(
      as_sentence(fmt::format("{}: left out of {}: {}", q.words,
                              q.points.size() + q.without_estimate, wording::listed(parts))));
}

void add_too_few(const history::JointTrend& t, std::vector<std::string>& notes) {
  std::vector<std::string> names;
  for (const history::QuantityTrend& q : t.quantities) {
    if (q.state == history::TrendState::too_few) {
      names.push_back(fmt::format("{} ({})", q.words, q.count(history::LeftOut::none)));
    }
  }
  if (names.empty()) return;
  const std::size_t learned = t.baseline.is_by_date() ? history::fewest_learned : t.baseline.count;
  notes.push_back(as_sentence(fmt::format(
      "too few calibrations can be used of {}: the first {} or more only tell what to expect, and "
      "a change shows in those that follow",
      wording::listed(names), learned)));
}

/// Quantities whose intervals hold an error that all calibrations share.
void add_shared_errors(const history::JointTrend& t, std::vector<std::string>& notes) {
  constexpr double clearly = 0.5;  // of the variance
  std::vector<std::string> names;
  for (const history::QuantityTrend& q : t.quantities) {
    if (q.reference && q.judged > 0 && q.reference->stated_share < clearly) {
      names.push_back(q.words);
    }
  }
  if (names.empty()) return;
  notes.push_back(as_sentence(wording::listed(names) +
                              ": calibrations scatter by less than their intervals state, which "
                              "then hold an error that all of them share; a change is told from "
                              "the scatter"));
}

}  // namespace

std::string joint_words(const history::JointTrend& t) {
  return fmt::format("{}{}{}, joint {}: {} from {} to {}", or_dash(t.of.robot),
                     t.of.serial.empty() ? "" : " ", t.of.serial, or_dash(t.of.joint),
                     wording::counted(t.calibrations, "calibration"), day(t.first_at),
                     day(t.last_at));
}

std::vector<std::string> change_sentences(const history::JointTrend& t) {
  std::vector<std::string> standing;
  std::vector<std::string> over;
  for (const history::QuantityTrend& q : t.quantities) {
    for (const history::FoundChange& c : q.changes) {
      (c.back.empty() ? standing : over).push_back(change_sentence(q, c));
    }
  }
  standing.insert(standing.end(), over.begin(), over.end());
  return standing;
}

Table trend_table(const history::JointTrend& t, const std::string& id) {
  Table table;
  table.id = id;
  table.is_stacked = true;
  table.caption = "Each quantity over time";
  table.columns = {{"Quantity", "", false, true},  {"Used", "", true},
                   {"Reference", "", true},        {"Scatter", "", true},
                   {"With temperature", "", true}, {"State", "", false, true}};
  for (const history::QuantityTrend& q : t.quantities) {
    table.rows.push_back({{q.words,
                           fmt::format("{} of {}", q.count(history::LeftOut::none),
                                       q.points.size() + q.without_estimate),
                           level_text(q), scatter_text(q), temperature_text(q), state_text(q)},
                          q.state == history::TrendState::warning});
  }
  table.note =
      "At the motor. The reference is the mean of all calibrations outside of a change, with its "
      "95 % interval; the scatter is the standard deviation of a single calibration about it.";
  return table;
}

std::vector<std::string> trend_notes(const history::JointTrend& t) {
  std::vector<std::string> notes;
  for (const std::string& caution : t.cautions) notes.push_back(as_sentence(caution));
  for (const history::TemperatureUse use :
       {history::TemperatureUse::corrected, history::TemperatureUse::too_even,
        history::TemperatureUse::not_recorded}) {
    std::vector<std::string> names;
    for (const history::QuantityTrend& q : t.quantities) {
      if (q.temperature == use) names.push_back(q.words);
    }
    if (names.empty()) continue;
    notes.push_back(as_sentence(wording::listed(names) + ": " + history::to_string(use)));
  }
  add_shared_errors(t, notes);
  for (const history::QuantityTrend& q : t.quantities) add_left_out(q, notes);
  add_too_few(t, notes);
  return notes;
}

std::string chart_words(const history::JointTrend& t) {
  const std::string baseline =
      t.baseline.is_by_date()
          ? fmt::format("The calibrations{}{} (at least {})",
                        t.baseline.from.empty() ? "" : " from " + t.baseline.from,
                        t.baseline.to.empty() ? "" : " up to " + t.baseline.to,
                        history::fewest_learned)
          : fmt::format("The first {} calibrations", t.baseline.count);
  return fmt::format(
      "A self-starting two-sided CUSUM (Page 1954, Hawkins 1987) for each quantity. {} are only "
      "learned from; each later one is held against all before it that lie in no change. Its "
      "difference, in standard deviations of its interval and of the scatter between calibrations "
      "(moving ranges) together, less {:.3g}, is added up, and the alarm is at {:.1f}: a false one "
      "comes about once in {} calibrations of the joint or more rarely, for all of its {} watched "
      "quantities together. The date from which a change is visible is that of the calibration, "
      "of those since the sum last left zero, from which on a shift is most likely (Hinkley 1970). "
      "A straight line over time through all calibrations tells a steady drift, which a chart that "
      "learns on the way follows: from a chance of {:.2g} % on, at any one time and for all "
      "quantities together, that there is none. A "
      "change that was there before the first calibration is not seen, and one odd calibration "
      "alone raises no alarm.",
      baseline, history::cusum_allowance, history::cusum_limit(t.watched),
      history::calibrations_per_false_alarm, t.watched, 100 * history::drift_false_alarms);
}

namespace {

history::TrendState worst_of(const std::vector<history::JointTrend>& trends) {
  history::TrendState worst = history::TrendState::too_few;
  for (const history::JointTrend& t : trends) worst = std::max(worst, t.state());
  return worst;
}

std::string title_of(const history::JointTrend& t) {
  return fmt::format("{}{}{}, joint {}", or_dash(t.of.robot), t.of.serial.empty() ? "" : " ",
                     t.of.serial, or_dash(t.of.joint));
}

struct Headline {
  const char* word;
  const char* sentence;
  Outcome outcome;
};

Headline headline_of(history::TrendState state) {
  switch (state) {
    case history::TrendState::warning:
      return {"CHANGED", "A change stands that is larger than what calibrations scatter.",
              Outcome::bad};
    case history::TrendState::recovered:
      return {"CHANGED, AND BACK", "There was a change; the values are back.", Outcome::partial};
    case history::TrendState::steady:
      return {"NO CHANGE VISIBLE", "No quantity has left what its calibrations let expect.",
              Outcome::good};
    case history::TrendState::too_few:
      break;
  }
  return {"TOO FEW YET", "There are too few calibrations to say anything about a change.",
          Outcome::absent};
}

void fill_verdict(const std::vector<history::JointTrend>& trends, TemplateValues& values) {
  TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  const Headline headline = headline_of(worst_of(trends));
  verdict.set("WORD", headline.word);
  verdict.set("SENTENCE", headline.sentence);
  fill_outcome(headline.outcome, verdict);
  std::vector<std::string> findings;
  for (const history::JointTrend& t : trends) {
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

void fill_joint(const history::JointTrend& t, std::size_t k, const std::vector<FigureCard>& cards,
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

std::string trend_page(const std::vector<history::JointTrend>& trends,
                       const calibration::Provenance& provenance,
                       const std::vector<figures::ReportFigure>& figures,
                       const std::vector<render::workers::DrawnFigure>& drawn,
                       wording::Language language) {
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

}  // namespace tribolog::report
