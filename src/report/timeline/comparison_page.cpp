#include "report/timeline/comparison_page.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>

#include "base/requirements.h"
#include "figures/timeline/history_axes.h"
#include "history/history_json.h"
#include "history/quantity_traits.h"
#include "report/elements/element_values.h"
#include "report/elements/elements.h"
#include "report/elements/figure_cards.h"
#include "report/engine/page_style.h"
#include "report/engine/template_engine.h"
#include "report/timeline/quantity_names.h"
#include "report/viewer/review_json.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::timeline {

namespace {

using history::ChangeWord;
using history::ComparedQuantity;
using history::Comparison;
using wording::tr;
using wording::tr_count;

wording::Scale scale_of(const history::ComparedQuantity& q) {
  const statistics::Estimate& e = q.first ? *q.first : present(q.second);
  return wording::quantity_scale(q.unit, e.value);
}

/// "3.8832 ± 0.0043", lopsided "3.8832 (3.8789 … 3.8899)"; the unit stands with the quantity.
std::string text_of(const wording::RoundedEstimate& rounded) {
  if (!rounded.half_width.empty() || rounded.low.empty()) return rounded.plus_minus();
  return rounded.estimate + " (" + rounded.range() + ")";
}

std::string estimate_text(const std::optional<statistics::Estimate>& e,
                          const wording::Scale& scale) {
  return e ? text_of(wording::round_by_interval(*e, scale)) : wording::or_dash("");
}

/// With a plus where it grew by a digit that is printed.
std::string signed_text(const std::optional<statistics::Estimate>& change,
                        const wording::Scale& scale) {
  if (!change) return wording::or_dash("");
  wording::RoundedEstimate rounded = wording::round_by_interval(*change, scale);
  rounded.estimate = wording::with_plus_sign(rounded.estimate);
  return text_of(rounded);
}

std::string name_of(const history::ComparedQuantity& q) {
  return figures::timeline::quantity_words(q.name, q.words);
}

/// "Coulomb torque [mN·m]"
std::string quantity_text(const history::ComparedQuantity& q, const wording::Scale& scale) {
  return scale.unit.empty() ? name_of(q) : name_of(q) + " [" + scale.unit + "]";
}

std::string time_text(const calibration::Facts& f) {
  return f.time_is_stated ? f.measured_at : tr("{time} (identified)", {{"time", f.measured_at}});
}

std::string number_text(const std::optional<double>& value, const char* unit) {
  return value ? wording::with_unit(wording::as_stated(*value), unit) : wording::or_dash("");
}

std::string verdict_text(calibration::Verdict verdict) {
  return wording::words_for("archived_verdict", calibration::to_string(verdict));
}

/// What is said of quantities, with the names of those it is said of.
class SharedStatements {
 public:
  void add(const Statement& statement, const NamedQuantity& of) {
    for (One& one : all_) {
      if (one.statement != statement) continue;
      one.names.push_back(of);
      return;
    }
    all_.push_back({statement, {of}});
  }
  /// @param sentence of the names, listed, and what is said of them.
  template <typename Sentence>
  void append_to(std::vector<std::string>& notes, const Sentence& sentence) const {
    for (const One& one : all_) {
      notes.push_back(wording::as_sentence(sentence(listed_quantities(one.names), one.statement)));
    }
  }

 private:
  struct One {
    Statement statement;
    std::vector<NamedQuantity> names;
  };
  std::vector<One> all_;
};

}  // namespace

namespace {

/// "0.12 N·m (14 %)", without its sign.
std::string size_text(const history::ComparedQuantity& q) {
  const auto size = [](const statistics::Estimate& signed_size, const wording::Scale& scale) {
    const statistics::Estimate e = statistics::scaled(signed_size, signed_size.value < 0 ? -1 : 1);
    return wording::with_unit(wording::round_by_interval(e, scale).estimate, scale.unit);
  };
  const history::Change& change = present(q.change);
  const std::string absolute = size(change.absolute, scale_of(q));
  return change.percent ? absolute + " (" + size(*change.percent, {1, "%"}) + ")" : absolute;
}

/// "Coulomb torque rose by 0.12 N·m (14 %), beyond chance"
std::string change_text(const history::ComparedQuantity& q) {
  const std::initializer_list<StatedValue> values{{"quantity", name_of(q)}, {"size", size_text(q)}};
  return present(q.change).absolute.value > 0
             ? tr("{quantity} rose by {size}, beyond chance", values)
             : tr("{quantity} fell by {size}, beyond chance", values);
}

}  // namespace

std::string comparison_sentence(const history::Comparison& c) {
  const std::size_t changed = c.count(history::ChangeWord::changed);
  const std::size_t comparable = changed + c.count(history::ChangeWord::no_change_seen);
  const std::size_t others = c.count(history::ChangeWord::not_comparable);
  if (comparable == 0) return tr("Nothing is comparable.");
  const auto n = static_cast<std::int64_t>(comparable);
  std::string sentence = changed == 0
                             ? tr_count(n, "No change seen in {comparable} comparable quantity",
                                        "No change seen in {comparable} comparable quantities",
                                        {{"comparable", comparable}})
                             : tr_count(n, "{changed} of {comparable} comparable quantity changed",
                                        "{changed} of {comparable} comparable quantities changed",
                                        {{"changed", changed}, {"comparable", comparable}});
  if (const history::ComparedQuantity* largest = c.largest_change()) {
    sentence = change_text(*largest) + "; " + sentence;
  }
  if (others > 0) {
    sentence += "; " + tr_count(static_cast<std::int64_t>(others), "{others} is not comparable",
                                "{others} are not comparable", {{"others", others}});
  }
  return wording::capitalised(sentence) + ".";
}

elements::Table compared_quantities_table(const history::Comparison& c) {
  elements::Table table;
  table.id = "table-changes";
  table.is_stacked = true;
  table.caption = tr("Each quantity and its change");
  table.columns = {{tr("Quantity"), "", false, true}, {tr("First"), "", true},
                   {tr("Second"), "", true},          {tr("Change"), "", true},
                   {tr("In per cent"), "", true},     {tr("Word"), "", false}};
  for (const history::ComparedQuantity& q : c.quantities) {
    const wording::Scale scale = scale_of(q);
    std::optional<statistics::Estimate> change;
    std::optional<statistics::Estimate> percent;
    if (q.change) {
      change = q.change->absolute;
      percent = q.change->percent;
    }
    table.rows.push_back(
        {{quantity_text(q, scale), estimate_text(q.first, scale), estimate_text(q.second, scale),
          signed_text(change, scale), signed_text(percent, {1, "%"}),
          wording::words(history::statement_of(q.word))},
         q.word == history::ChangeWord::changed});
  }
  table.note =
      tr("At the motor, with 95 % intervals; that of a change combines both, which are "
         "independent. “changed” requires a chance of at most {chance_percent:.3g} % over all "
         "quantities together (Holm), so that many quantities do not make a change by chance.",
         {{"chance_percent", 100 * history::changed_chance}});
  return table;
}

elements::Table compared_conditions_table(const history::Comparison& c) {
  const calibration::Facts& a = c.first.facts;
  const calibration::Facts& b = c.second.facts;
  elements::Table table;
  table.id = "table-conditions";
  table.is_stacked = true;
  table.caption = tr("How they were measured");
  table.columns = {{tr("Condition"), "", false},
                   {tr("First"), "", false, true},
                   {tr("Second"), "", false, true}};
  const auto add = [&](const std::string& name, const std::string& first,
                       const std::string& second) {
    table.rows.push_back({{name, wording::or_dash(first), wording::or_dash(second)}, false});
  };
  add(tr("Calibration"), c.first.id.substr(0, calibration::shown_digits),
      c.second.id.substr(0, calibration::shown_digits));
  add(tr("Robot"), a.of.robot, b.of.robot);
  add(tr("Serial number"), a.of.serial, b.of.serial);
  add(tr("Joint"), a.of.joint, b.of.joint);
  add(tr("Measured"), time_text(a), time_text(b));
  add(tr("Operator"), a.operator_name, b.operator_name);
  add(tr("Temperature"), number_text(a.temperature_C, "°C"), number_text(b.temperature_C, "°C"));
  add(tr("Payload"), a.payload, b.payload);
  add(tr("Payload's mass"), number_text(a.payload_kg, "kg"), number_text(b.payload_kg, "kg"));
  add(tr("Gear ratio"), wording::as_stated(a.gear_ratio), wording::as_stated(b.gear_ratio));
  add(tr("Sampling rate"), number_text(a.sampling_Hz, "Hz"), number_text(b.sampling_Hz, "Hz"));
  add(tr("Verdict"), verdict_text(a.verdict), verdict_text(b.verdict));
  add(tr("Made by tribolog"), a.tool_version, b.tool_version);
  return table;
}

std::vector<std::string> comparison_notes(const history::Comparison& c) {
  SharedStatements why_not;
  SharedStatements cautions;
  for (const history::ComparedQuantity& q : c.quantities) {
    const NamedQuantity name{q.name, wording::within_a_sentence(name_of(q))};
    for (const Statement& why : q.why_not) why_not.add(why, name);
    if (q.word == history::ChangeWord::not_comparable) continue;
    for (const Statement& caution : q.cautions) cautions.add(caution, name);
  }
  std::vector<std::string> notes;
  for (const Statement& remark : c.remarks) notes.push_back(wording::as_sentence(remark));
  why_not.append_to(notes, [](const std::string& quantities, const Statement& why) {
    return wording::as_sentence(
        tr("{quantities}, not comparable: {why}", {{"quantities", quantities}, {"why", why}}));
  });
  cautions.append_to(notes, [](const std::string& quantities, const Statement& caution) {
    return wording::as_sentence(tr("{quantities}, with caution: {caution}",
                                   {{"quantities", quantities}, {"caution", caution}}));
  });
  return notes;
}

namespace {

void fill_verdict(const history::Comparison& c, engine::TemplateValues& values) {
  engine::TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  const std::size_t changed = c.count(history::ChangeWord::changed);
  const std::size_t same = c.count(history::ChangeWord::no_change_seen);
  const std::size_t others = c.count(history::ChangeWord::not_comparable);
  const elements::Outcome outcome = same + changed == 0         ? elements::Outcome::absent
                                    : changed > 0 || others > 0 ? elements::Outcome::partial
                                                                : elements::Outcome::good;
  verdict.set("WORD", changed > 0 ? tr("CHANGED")
                      : same > 0  ? tr("NO CHANGE SEEN")
                                  : tr("NOT COMPARABLE"));
  verdict.set("SENTENCE", comparison_sentence(c));
  elements::fill_outcome(outcome, verdict);
  const std::vector<std::string> notes = comparison_notes(c);
  if (notes.empty()) return;
  engine::TemplateValues& findings = verdict.add_section("FINDINGS");
  for (const std::string& note : notes) findings.add_section("FINDING").set("TEXT", note);
}

/// The panel of the differences: in percent, each as a dot with its interval.
class DifferenceAxis {
 public:
  /// Holds all changes that were found and the other intervals, but for those that would squash the
  /// rest: they are cut.
  explicit DifferenceAxis(const history::Comparison& c) {
    std::vector<double> reach;
    double changed = 0;
    for (const history::ComparedQuantity& q : c.quantities) {
      const statistics::Estimate* percent = percent_of(q);
      if (percent == nullptr || q.word == history::ChangeWord::not_comparable) continue;
      reach.push_back(std::max(std::abs(percent->low), std::abs(percent->high)));
      if (q.word == history::ChangeWord::changed) changed = std::max(changed, reach.back());
    }
    if (reach.empty()) return;
    std::sort(reach.begin(), reach.end());
    constexpr double most = 4;  // times the median
    const double limit = std::max(changed, std::min(reach.back(), most * reach[reach.size() / 2]));
    if (!(limit > 0)) return;
    const double power = std::pow(10.0, std::floor(std::log10(limit)));
    for (const double step : {1.0, 2.0, 5.0, 10.0}) {
      end_ = step * power;
      if (end_ >= limit) break;
    }
  }
  [[nodiscard]] static const statistics::Estimate* percent_of(const history::ComparedQuantity& q) {
    if (!q.change || !q.change->percent) return nullptr;
    const statistics::Estimate& percent = *q.change->percent;
    return std::isfinite(percent.low) && std::isfinite(percent.high) ? &percent : nullptr;
  }
  [[nodiscard]] double end() const { return end_; }
  [[nodiscard]] bool holds(double percent) const { return std::abs(percent) <= end_; }
  /// From 0 to the width of the picture.
  [[nodiscard]] double at(double percent) const {
    constexpr double margin = 12;
    const double share = (std::clamp(percent, -end_, end_) + end_) / (2 * end_);
    return margin + share * (difference_width - 2 * margin);
  }
  static constexpr double difference_width = 400;

 private:
  double end_{1};
};

/// Interval with its end marks, and an arrow where it goes on beyond the axis.
std::string interval_path(const statistics::Estimate& percent, const DifferenceAxis& axis) {
  const auto end = [&](double value) {
    const double x = axis.at(value);
    if (axis.holds(value)) return fmt::format("M{:.1f} 7V17", x);
    const double back = value > 0 ? x - 6 : x + 6;
    return fmt::format("M{:.1f} 6L{:.1f} 12L{:.1f} 18", back, x, back);
  };
  return fmt::format("M{:.1f} 12H{:.1f}", axis.at(percent.low), axis.at(percent.high)) +
         end(percent.low) + end(percent.high);
}

void fill_differences(const history::Comparison& c, engine::TemplateValues& values) {
  const DifferenceAxis axis(c);
  engine::TemplateValues& panel = values.add_section("DIFFERENCES");
  const std::string end = wording::significant(axis.end(), 1);
  panel.set("FROM", "−" + wording::with_unit(end, "%"));
  panel.set("TO", "+" + wording::with_unit(end, "%"));
  panel.set("ZERO", fmt::format("M{:.1f} 0V24", axis.at(0)));
  for (const history::ComparedQuantity& q : c.quantities) {
    engine::TemplateValues& row = panel.add_section("DIFFERENCE");
    const wording::Scale scale = scale_of(q);
    row.set("QUANTITY", name_of(q));
    row.set("KIND", q.word == history::ChangeWord::changed          ? "changed"
                    : q.word == history::ChangeWord::no_change_seen ? "same"
                                                                    : "not-comparable");
    row.set("WORD", wording::words(history::statement_of(q.word)));
    std::optional<statistics::Estimate> change;
    if (q.change) change = q.change->absolute;
    row.set("CHANGE", wording::with_unit(signed_text(change, scale), change ? scale.unit : ""));
    const statistics::Estimate* const percent = DifferenceAxis::percent_of(q);
    if (percent == nullptr) continue;
    engine::TemplateValues& drawn = row.add_section("DRAWN");
    drawn.set("ZERO", fmt::format("M{:.1f} 0V24", axis.at(0)));
    drawn.set("INTERVAL", interval_path(*percent, axis));
    drawn.set("DOT", axis.holds(percent->value)
                         ? fmt::format("M{:.1f} 12h0", axis.at(percent->value))
                         : std::string("M0 0"));
    row.set_optional("PERCENT", wording::with_unit(signed_text(*percent, {1, "%"}), "%"));
  }
}

}  // namespace

std::string comparison_page(
    const history::Comparison& comparison, const calibration::RecordedCurves& first,
    const calibration::RecordedCurves& second, const calibration::Provenance& provenance,
    const std::string& curves_missing, const std::vector<figures::ReportFigure>& figures,
    const std::vector<render::workers::DrawnFigure>& drawn, wording::Language language) {
  const wording::WordsIn words(language);
  engine::TemplateValues values;
  engine::fill_head(provenance, values, engine::PageKind::comparison);
  if (std::string loops = viewer::compared_curves_json(comparison, first, second); !loops.empty()) {
    engine::allow_script(values, engine::PageKind::comparison);
    values.add_section("REVIEW");
    values.add_section("REVIEW_DATA").set_checked_by_modifier("LOOPS_JSON", std::move(loops));
  }
  const calibration::JointName& of = comparison.first.facts.of;
  values.set("TITLE", tr("{robot}, joint {joint}", {{"robot", wording::or_dash(of.robot)},
                                                    {"joint", wording::or_dash(of.joint)}}));
  fill_verdict(comparison, values);
  fill_differences(comparison, values);
  elements::fill_table(compared_quantities_table(comparison), "CHANGES", values);
  elements::fill_table(compared_conditions_table(comparison), "CONDITIONS", values);
  for (const elements::FigureCard& card : elements::figure_cards(figures, drawn))
    elements::fill_figure(card, values);
  values.set_optional("CURVES_MISSING", curves_missing);
  values.set_checked_by_modifier("RESULT_JSON", history::comparison_json(comparison));
  return engine::expand_template("diff.tpl", values, language);
}

}  // namespace tribolog::report::timeline
