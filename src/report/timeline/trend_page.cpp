#include "report/timeline/trend_page.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/enum_text.h"
#include "calibration/friction_speeds.h"
#include "figures/timeline/history_axes.h"
#include "history/history_json.h"
#include "history/quantity_traits.h"
#include "history/reference_line.h"
#include "report/elements/element_values.h"
#include "report/elements/elements.h"
#include "report/elements/figure_cards.h"
#include "report/engine/page_style.h"
#include "report/engine/template_engine.h"
#include "report/timeline/quantity_names.h"
#include "statistics/distributions.h"
#include "wording/axis_scale.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::timeline {

namespace {

using history::FoundChange;
using history::JointTrend;
using history::LeftOut;
using history::QuantityTrend;
using history::TemperatureUse;
using history::TrendState;
using wording::date_of;
using wording::tr;
using wording::tr_count;

constexpr history::LeftOut all_left_out[] = {
    history::LeftOut::before_baseline, history::LeftOut::not_usable, history::LeftOut::other_gear,
    history::LeftOut::other_payload, history::LeftOut::no_temperature};

std::string size_of(const history::FoundChange& c, const std::string& unit) {
  if (c.percent) {
    const double half = std::abs(c.size.half_width() * *c.percent / c.size.value);
    return wording::in_words(statistics::symmetric_estimate(std::abs(*c.percent), half), {1, "%"});
  }
  return wording::in_words(
      statistics::symmetric_estimate(std::abs(c.size.value), c.size.half_width()),
      wording::quantity_scale(unit, c.size.value));
}

std::string name_of(const history::QuantityTrend& q) {
  return figures::timeline::quantity_words(q.name, q.words);
}

/// " (0.27 % a month)"; empty where it has no meaning.
std::string rate_text(const history::FoundChange& c) {
  constexpr double days_of_a_month = 365.25 / 12;
  if (!c.is_slow || !c.percent || !(c.drift_days > days_of_a_month)) return "";
  const double percent = std::abs(*c.percent) / c.drift_days * days_of_a_month;
  return " (" +
         tr("{rate} a month",
            {{"rate", wording::with_unit(wording::significant(percent, 2), "%")}}) +
         ")";
}

/// "; 10 % are reached on 2027-08-14 (2027-06-30 to 2027-10-20) if it goes on"; empty without a
/// limit.
std::string limit_text(const history::FoundChange& c) {
  if (!c.limit) return "";
  const std::string percent = wording::with_unit(wording::as_stated(c.limit->percent), "%");
  if (c.percent && std::abs(*c.percent) >= c.limit->percent) {
    return "; " + tr("it exceeds the limit of {limit}", {{"limit", percent}});
  }
  if (c.limit->expected.empty()) return "";
  const std::initializer_list<StatedValue> values{{"limit", percent},
                                                  {"date", date_of(c.limit->expected)},
                                                  {"earliest_date", date_of(c.limit->earliest)},
                                                  {"latest_date", date_of(c.limit->latest)}};
  return "; " +
         (c.limit->latest.empty()
              ? tr("at this rate it reaches {limit} on {date}, not before {earliest_date}", values)
              : tr("at this rate it reaches {limit} on {date} ({earliest_date} to "
                   "{latest_date})",
                   values));
}

/// @param quantity "Coulomb torque" @param size "2.9 ± 0.3 %"
std::string change_words(const std::string& quantity, const std::string& size,
                         const history::FoundChange& c) {
  const bool has_risen = c.direction > 0;
  const std::initializer_list<StatedValue> values{
      {"quantity", quantity},
      {"change", size},
      {"first_date", date_of(c.from)},
      {"visible_date", date_of(c.is_slow ? c.alarm : c.from)},
      {"alarm_date", date_of(c.alarm)},
      {"back_date", date_of(c.back)},
      {"rate", rate_text(c)}};
  if (c.is_slow) {
    return (has_risen ? tr("{quantity} has slowly risen by {change} since {first_date}{rate}, "
                           "visible from {visible_date}",
                           values)
                      : tr("{quantity} has slowly fallen by {change} since {first_date}{rate}, "
                           "visible from {visible_date}",
                           values)) +
           limit_text(c);
  }
  if (c.back.empty()) {
    return has_risen ? tr("{quantity} has risen by {change}, visible from {visible_date} (alarm "
                          "on {alarm_date})",
                          values)
                     : tr("{quantity} has fallen by {change}, visible from {visible_date} (alarm "
                          "on {alarm_date})",
                          values);
  }
  return has_risen ? tr("{quantity} had risen by {change}, visible from {visible_date} (alarm "
                        "on {alarm_date}), and came back to where it was on {back_date}",
                        values)
                   : tr("{quantity} had fallen by {change}, visible from {visible_date} (alarm "
                        "on {alarm_date}), and came back to where it was on {back_date}",
                        values);
}

std::string level_text(const history::QuantityTrend& q) {
  if (!q.reference) return wording::or_dash("");
  const double half_width = statistics::normal_975 * std::sqrt(q.reference->level_variance);
  return wording::in_words(statistics::symmetric_estimate(q.reference->level, half_width),
                           wording::quantity_scale(q.unit, q.reference->level));
}

/// Of a single calibration about the reference.
std::string scatter_text(const history::QuantityTrend& q) {
  if (!q.reference) return wording::or_dash("");
  const double scatter = q.reference->scatter();
  const double level = std::abs(q.reference->level);
  if (!history::traits_of(q.name).is_angle && level > scatter) {
    return wording::significant(100 * scatter / level, 2) + " %";
  }
  const wording::Scale scale = wording::quantity_scale(q.unit, scatter);
  return wording::with_unit(wording::significant(scatter * scale.factor, 2), scale.unit);
}

std::string temperature_text(const history::QuantityTrend& q) {
  if (q.temperature != history::TemperatureUse::corrected || !q.reference)
    return wording::or_dash("");
  const double to_percent = 100 / std::abs(q.reference->level);
  return wording::in_words(
      statistics::symmetric_estimate(
          q.reference->slope_per_K * to_percent,
          statistics::normal_975 * std::sqrt(q.reference->slope_variance) * to_percent),
      {1, "%/K"});
}

/// "20 % above its reference on 2026-07-17"
std::string apart_words(const history::QuantityTrend& q, const history::FoundApart& one) {
  const wording::Scale scale = wording::quantity_scale(q.unit, one.size);
  const std::string size =
      one.percent ? wording::with_unit(wording::significant(std::abs(*one.percent), 2), "%")
                  : wording::with_unit(wording::significant(std::abs(one.size) * scale.factor, 2),
                                       scale.unit);
  const std::initializer_list<StatedValue> values{{"size", size}, {"date", date_of(one.at)}};
  return one.size > 0 ? tr("{size} above its reference on {date}", values)
                      : tr("{size} below its reference on {date}", values);
}

std::string apart_sentence(const history::QuantityTrend& q) {
  std::vector<std::string> all;
  for (const history::FoundApart& one : q.apart) all.push_back(apart_words(q, one));
  const std::initializer_list<StatedValue> values{{"quantity", name_of(q)},
                                                  {"apart", wording::listed(all)}};
  return q.apart.back().is_latest
             ? tr("{quantity} lay {apart}. The latest calibration is one of them: measure again, "
                  "for one alone does not show a change.",
                  values)
             : tr("{quantity} lay {apart}, and is back at it.", values);
}

std::string state_text(const history::QuantityTrend& q) {
  if (q.state == history::TrendState::apart) {
    std::vector<std::string> dates;
    for (const history::FoundApart& one : q.apart) dates.push_back(date_of(one.at));
    return tr("far from the others on {dates}", {{"dates", wording::listed(dates)}});
  }
  if (q.changes.empty()) return wording::words(history::statement_of(q.state));
  const history::FoundChange& last = q.changes.back();
  if (last.is_slow) {
    return tr("slow drift, visible from {visible_date}", {{"visible_date", date_of(last.alarm)}});
  }
  if (q.state == history::TrendState::recovered) {
    return tr("changed from {first_date}, back where it was from {back_date}",
              {{"first_date", date_of(last.from)}, {"back_date", date_of(last.back)}});
  }
  return tr("changed from {first_date}", {{"first_date", date_of(last.from)}});
}

void add_left_out(const history::QuantityTrend& q, std::vector<std::string>& notes) {
  std::vector<std::string> parts;
  for (const history::LeftOut why : all_left_out) {
    const std::size_t count = q.count(why);
    if (count == 0) continue;
    parts.push_back(wording::words(
        Statement::with(Code::of("left_out." + own_name(why)), {{"calibrations", count}})));
  }
  if (q.without_estimate > 0) {
    parts.push_back(
        tr("{calibrations} (without an estimate)", {{"calibrations", q.without_estimate}}));
  }
  if (q.in_another_unit > 0) {
    parts.push_back(tr("{calibrations} (in another unit than the latest)",
                       {{"calibrations", q.in_another_unit}}));
  }
  if (parts.empty()) return;
  notes.push_back(wording::as_sentence(tr("{quantity}: left out of {calibrations}: {left_out}",
                                          {{"quantity", name_of(q)},
                                           {"calibrations", q.calibrations()},
                                           {"left_out", wording::listed(parts)}})));
}

void add_too_few(const history::JointTrend& t, std::vector<std::string>& notes) {
  std::vector<NamedQuantity> names;
  for (const history::QuantityTrend& q : t.quantities) {
    if (q.state == history::TrendState::too_few) {
      names.push_back({q.name, fmt::format("{} ({})", wording::within_a_sentence(name_of(q)),
                                           q.count(history::LeftOut::none))});
    }
  }
  if (names.empty()) return;
  const std::size_t learned = t.baseline.is_by_date() ? history::fewest_learned : t.baseline.count;
  notes.push_back(wording::as_sentence(
      tr("too few usable calibrations of {quantities}: the first {calibrations} or "
         "more only set the baseline, and a change shows in those that follow",
         {{"quantities", listed_quantities(names)}, {"calibrations", learned}})));
}

/// Quantities whose intervals hold an error that all calibrations share.
void add_shared_errors(const history::JointTrend& t, std::vector<std::string>& notes) {
  constexpr double clearly = 0.5;  // of the variance
  std::vector<NamedQuantity> names;
  for (const history::QuantityTrend& q : t.quantities) {
    if (q.reference && q.judged > 0 && q.reference->stated_share < clearly) {
      names.push_back({q.name, wording::within_a_sentence(name_of(q))});
    }
  }
  if (names.empty()) return;
  notes.push_back(wording::as_sentence(
      tr("{quantities}: calibrations scatter by less than their intervals state, so the intervals "
         "include an error that all of them share; changes are judged by the scatter",
         {{"quantities", listed_quantities(names)}})));
}

/// Of the quantities whose temperature was treated in that way.
std::string temperature_note(history::TemperatureUse use, const std::string& quantities) {
  return wording::words(
      Statement::with(Code::of("temperature_use." + own_name(use)),
                      {{"quantities", quantities}, {"span_K", history::least_temperature_span_K}}));
}

/// "R1 S1"
std::string robot_of(const history::JointTrend& t) {
  return wording::or_dash(t.of.robot) + (t.of.serial.empty() ? "" : " ") + t.of.serial;
}

}  // namespace

std::string joint_words(const history::JointTrend& t) {
  return tr_count(static_cast<std::int64_t>(t.calibrations),
                  "{robot}, joint {joint}: {calibrations} calibration from {first_date} to "
                  "{last_date}",
                  "{robot}, joint {joint}: {calibrations} calibrations from {first_date} to "
                  "{last_date}",
                  {{"robot", robot_of(t)},
                   {"joint", wording::or_dash(t.of.joint)},
                   {"calibrations", t.calibrations},
                   {"first_date", date_of(t.first_at)},
                   {"last_date", date_of(t.last_at)}});
}

namespace {

struct Change {
  const history::QuantityTrend* quantity;
  const history::FoundChange* change;
};

/// Changes of friction that stand, at three speeds or more and of one kind, as one sentence; they
/// are taken out of the others.
std::vector<std::string> take_friction_together(std::vector<Change>& all) {
  std::vector<std::string> sentences;
  for (const bool is_slow : {true, false}) {
    for (const int direction : {1, -1}) {
      const auto is_one = [&](const Change& one) {
        return calibration::speed_of_friction(one.quantity->name) && one.change->percent &&
               one.change->is_slow == is_slow && one.change->direction == direction &&
               one.change->back.empty();
      };
      std::vector<std::string> names;
      wording::Extent percent;
      const history::FoundChange* earliest = nullptr;
      std::optional<history::LimitDates> limit;  // whichever speed reaches it first
      for (const Change& one : all) {
        if (!is_one(one)) continue;
        if (one.change->limit && (!limit || one.change->limit->expected < limit->expected)) {
          limit = one.change->limit;
        }
        names.push_back(one.quantity->name);
        percent.add(std::abs(*one.change->percent));
        if (earliest == nullptr || one.change->alarm < earliest->alarm) earliest = one.change;
      }
      const std::string friction = friction_at_speeds(names);
      if (friction.empty()) continue;
      const std::string size =
          tr("{lowest} to {highest}",
             {{"lowest", wording::fixed(percent.low, 1)},
              {"highest", wording::with_unit(wording::fixed(percent.high, 1), "%")}});
      history::FoundChange together = *earliest;
      together.limit = limit;
      together.percent = percent.high;
      sentences.push_back(wording::as_sentence(change_words(friction, size, together)));
      std::erase_if(all, is_one);
    }
  }
  return sentences;
}

}  // namespace

std::vector<std::string> change_sentences(const history::JointTrend& t) {
  std::vector<Change> all;
  for (const history::QuantityTrend& q : t.quantities) {
    for (const history::FoundChange& c : q.changes) all.push_back({&q, &c});
  }
  const auto percent = [](const Change& one) { return std::abs(one.change->percent.value_or(0)); };
  std::stable_sort(all.begin(), all.end(), [&](const Change& a, const Change& b) {
    const bool is_standing = a.change->back.empty();
    if (is_standing != b.change->back.empty()) return is_standing;
    return percent(a) > percent(b);
  });
  std::vector<std::string> sentences = take_friction_together(all);
  for (const Change& one : all) {
    sentences.push_back(wording::as_sentence(change_words(
        name_of(*one.quantity), size_of(*one.change, one.quantity->unit), *one.change)));
  }
  std::vector<const history::QuantityTrend*> apart;
  for (const history::QuantityTrend& q : t.quantities) {
    if (!q.apart.empty()) apart.push_back(&q);
  }
  std::stable_sort(apart.begin(), apart.end(), [](const auto* a, const auto* b) {
    return std::abs(a->apart.back().percent.value_or(0)) >
           std::abs(b->apart.back().percent.value_or(0));
  });
  for (const history::QuantityTrend* q : apart) sentences.push_back(apart_sentence(*q));
  return sentences;
}

elements::Table trend_table(const history::JointTrend& t, const std::string& id) {
  elements::Table table;
  table.id = id;
  table.is_stacked = true;
  table.caption = tr("Each quantity over time");
  table.columns = {{tr("Quantity"), "", false, true},  {tr("Used"), "", true},
                   {tr("Reference"), "", true},        {tr("Scatter"), "", true},
                   {tr("With temperature"), "", true}, {tr("State"), "", false, true}};
  for (const history::QuantityTrend& q : t.quantities) {
    table.rows.push_back(
        {{name_of(q),
          tr("{used} of {calibrations}",
             {{"used", q.count(history::LeftOut::none)}, {"calibrations", q.calibrations()}}),
          level_text(q), scatter_text(q), temperature_text(q), state_text(q)},
         q.state == history::TrendState::warning});
  }
  table.note =
      tr("At the motor. The reference is the mean of all calibrations outside a change, with its "
         "95 % interval; the scatter is the standard deviation of a single calibration about it.");
  return table;
}

std::vector<std::string> trend_notes(const history::JointTrend& t) {
  std::vector<std::string> notes;
  for (const Statement& caution : t.cautions) notes.push_back(wording::as_sentence(caution));
  for (const history::TemperatureUse use :
       {history::TemperatureUse::corrected, history::TemperatureUse::too_even,
        history::TemperatureUse::not_recorded}) {
    std::vector<NamedQuantity> names;
    for (const history::QuantityTrend& q : t.quantities) {
      if (q.temperature == use) {
        names.push_back({q.name, wording::within_a_sentence(name_of(q))});
      }
    }
    if (names.empty()) continue;
    notes.push_back(wording::as_sentence(temperature_note(use, listed_quantities(names))));
  }
  add_shared_errors(t, notes);
  for (const history::QuantityTrend& q : t.quantities) add_left_out(q, notes);
  add_too_few(t, notes);
  return notes;
}

namespace {

std::string baseline_words(const history::Baseline& baseline) {
  const std::size_t fewest = history::fewest_learned;
  if (!baseline.is_by_date()) {
    return tr_count(static_cast<std::int64_t>(baseline.count),
                    "The first {calibrations} calibration only sets the baseline; each later one "
                    "is compared with all earlier ones that are not part of a change.",
                    "The first {calibrations} calibrations only set the baseline; each later one "
                    "is compared with all earlier ones that are not part of a change.",
                    {{"calibrations", baseline.count}});
  }
  if (baseline.to.empty()) {
    return tr(
        "The calibrations from {first_date} (at least {fewest}) only set the baseline; each later "
        "one is compared with all earlier ones that are not part of a change.",
        {{"first_date", baseline.from}, {"fewest", fewest}});
  }
  if (baseline.from.empty()) {
    return tr(
        "The calibrations up to {last_date} (at least {fewest}) only set the baseline; each later "
        "one is compared with all earlier ones that are not part of a change.",
        {{"last_date", baseline.to}, {"fewest", fewest}});
  }
  return tr(
      "The calibrations from {first_date} up to {last_date} (at least {fewest}) only set the "
      "baseline; each later one is compared with all earlier ones that are not part of a change.",
      {{"first_date", baseline.from}, {"last_date", baseline.to}, {"fewest", fewest}});
}

std::string alarm_words(const history::JointTrend& t) {
  return tr_count(
      static_cast<std::int64_t>(t.watched),
      "Its difference, in standard deviations of its interval and of the scatter between "
      "calibrations (moving ranges) together, less {allowance:.3g}, is summed, and the alarm is "
      "raised at {limit:.1f}: a false alarm occurs about once in {calibrations} calibrations of "
      "the joint or less often, for its {watched} watched quantity.",
      "Its difference, in standard deviations of its interval and of the scatter between "
      "calibrations (moving ranges) together, less {allowance:.3g}, is summed, and the alarm is "
      "raised at {limit:.1f}: a false alarm occurs about once in {calibrations} calibrations of "
      "the joint or less often, for all of its {watched} watched quantities together.",
      {{"allowance", history::cusum_allowance},
       {"limit", history::cusum_limit(t.watched)},
       {"calibrations", history::calibrations_per_false_alarm},
       {"watched", t.watched}});
}

}  // namespace

std::string chart_words(const history::JointTrend& t) {
  const std::vector<std::string> sentences{
      tr("A self-starting two-sided CUSUM (Page 1954, Hawkins 1987) for each quantity."),
      baseline_words(t.baseline),
      alarm_words(t),
      tr("A change is visible from the date of that calibration, among those since the sum last "
         "left zero, from which a shift is most likely to have begun (Hinkley 1970)."),
      tr("A straight line over time through all calibrations shows a steady drift, which a "
         "self-starting chart would follow: it is reported if the chance that there is none is at "
         "most {chance_percent:.2g} %, at any one time and for all quantities together.",
         {{"chance_percent", 100 * history::drift_false_alarms}}),
      tr("A change that was there before the first calibration is not seen, and one odd "
         "calibration alone raises no alarm.")};
  return fmt::format("{}", fmt::join(sentences, " "));
}

namespace {

history::TrendState worst_of(const std::vector<history::JointTrend>& trends) {
  history::TrendState worst = history::TrendState::too_few;
  for (const history::JointTrend& t : trends) worst = std::max(worst, t.state());
  return worst;
}

std::string title_of(const history::JointTrend& t) {
  return tr("{robot}, joint {joint}",
            {{"robot", robot_of(t)}, {"joint", wording::or_dash(t.of.joint)}});
}

/// The outcome in one sentence, and what there is to tell beside it.
struct Outcomes {
  std::string sentence;
  std::vector<std::string> others;
};

/// "No change is visible in its other 8 quantities."
std::string rest_words(const history::JointTrend& t) {
  std::size_t unchanged = 0;
  for (const history::QuantityTrend& q : t.quantities) {
    if (q.state == history::TrendState::steady) ++unchanged;
  }
  if (unchanged == 0) return {};
  return " " + tr_count(static_cast<std::int64_t>(unchanged),
                        "No change is visible in {unchanged} other quantity.",
                        "No change is visible in {unchanged} other quantities.",
                        {{"unchanged", unchanged}});
}

Outcomes outcomes_of(const std::vector<history::JointTrend>& trends, history::TrendState worst) {
  Outcomes out;
  const bool are_many = trends.size() > 1;
  const auto sentence_of = [&](const history::JointTrend& t, const std::string& change) {
    return are_many ? title_of(t) + ": " + change : change;
  };
  if (worst == history::TrendState::steady) {
    std::size_t calibrations = 0;
    for (const history::JointTrend& t : trends) calibrations += t.calibrations;
    out.sentence =
        tr_count(static_cast<std::int64_t>(calibrations),
                 "No quantity has left the range expected from {calibrations} calibration.",
                 "No quantity has left the range expected from {calibrations} calibrations.",
                 {{"calibrations", calibrations}});
    return out;
  }
  if (worst == history::TrendState::too_few) {
    out.sentence = tr("There are too few calibrations to say anything about a change.");
    return out;
  }
  for (const history::JointTrend& t : trends) {
    const std::vector<std::string> changes = change_sentences(t);
    for (std::size_t i = 0; i < changes.size(); ++i) {
      const bool is_first = out.sentence.empty() && t.state() == worst && i == 0;
      if (is_first) {
        out.sentence = sentence_of(t, changes[i]) + rest_words(t);
      } else {
        out.others.push_back(sentence_of(t, changes[i]));
      }
    }
  }
  return out;
}

struct Headline {
  std::string word;
  elements::Outcome outcome;
};

Headline headline_of(history::TrendState state) {
  switch (state) {
    case history::TrendState::warning:
      return {tr("CHANGED"), elements::Outcome::bad};
    case history::TrendState::recovered:
      return {tr("CHANGED AND RETURNED"), elements::Outcome::partial};
    case history::TrendState::apart:
      return {tr("SINGLE CALIBRATIONS FAR OFF"), elements::Outcome::partial};
    case history::TrendState::steady:
      return {tr("NO CHANGE VISIBLE"), elements::Outcome::good};
    case history::TrendState::too_few:
      break;
  }
  return {tr("TOO FEW YET"), elements::Outcome::absent};
}

void fill_verdict(const std::vector<history::JointTrend>& trends, engine::TemplateValues& values) {
  engine::TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  const history::TrendState worst = worst_of(trends);
  const Headline headline = headline_of(worst);
  const Outcomes outcomes = outcomes_of(trends, worst);
  verdict.set("WORD", headline.word);
  verdict.set("SENTENCE", outcomes.sentence);
  elements::fill_outcome(headline.outcome, verdict);
  if (outcomes.others.empty()) return;
  engine::TemplateValues& list = verdict.add_section("FINDINGS");
  for (const std::string& text : outcomes.others) list.add_section("FINDING").set("TEXT", text);
}

bool belongs_to(const elements::FigureCard& card, std::size_t joint) {
  return card.id.rfind(fmt::format("trend-{}-", joint + 1), 0) == 0;
}

void fill_joint(const history::JointTrend& t, std::size_t k,
                const std::vector<elements::FigureCard>& cards, engine::TemplateValues& values) {
  engine::TemplateValues& section = values.add_section("JOINT");
  section.set("JOINT_ID", fmt::format("joint-{}", k + 1));
  section.set("JOINT_TITLE", title_of(t));
  section.set("JOINT_WORDS", wording::as_sentence(joint_words(t)));
  elements::fill_table(trend_table(t, fmt::format("table-joint-{}", k + 1)), "TREND", section);
  const std::vector<std::string> notes = trend_notes(t);
  if (!notes.empty()) {
    engine::TemplateValues& list = section.add_section("NOTES");
    for (const std::string& note : notes) list.add_section("NOTE").set("TEXT", note);
  }
  section.set("CHART_WORDS", chart_words(t));
  for (const elements::FigureCard& card : cards) {
    if (belongs_to(card, k)) elements::fill_figure(card, section);
  }
}

}  // namespace

std::string trend_page(const std::vector<history::JointTrend>& trends,
                       const calibration::Provenance& provenance,
                       const std::vector<figures::ReportFigure>& figures,
                       const std::vector<render::workers::DrawnFigure>& drawn,
                       wording::Language language) {
  const wording::WordsIn words(language);
  engine::TemplateValues values;
  engine::fill_head(provenance, values);
  values.set("TITLE", trends.size() == 1
                          ? title_of(trends.front())
                          : tr_count(static_cast<std::int64_t>(trends.size()), "{joints} joint",
                                     "{joints} joints", {{"joints", trends.size()}}));
  fill_verdict(trends, values);
  const std::vector<elements::FigureCard> cards = elements::figure_cards(figures, drawn);
  for (std::size_t k = 0; k < trends.size(); ++k) {
    engine::TemplateValues& link = values.add_section("JOINT_LINK");
    link.set("LINK_ID", fmt::format("joint-{}", k + 1));
    link.set("LINK_TITLE", title_of(trends[k]));
    fill_joint(trends[k], k, cards, values);
  }
  values.set_checked_by_modifier("RESULT_JSON", history::trend_json(trends));
  return engine::expand_template("trend.tpl", values, language);
}

}  // namespace tribolog::report::timeline
