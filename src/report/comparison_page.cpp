#include "report/comparison_page.h"

#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "base/requirements.h"
#include "history/history_json.h"
#include "history/quantity_traits.h"
#include "report/element_values.h"
#include "report/page_style.h"
#include "report/view_parts.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report {

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
  return e ? text_of(wording::round_by_interval(*e, scale)) : or_dash("");
}

/// With a plus where it grew by a digit that is printed.
std::string signed_text(const std::optional<statistics::Estimate>& change,
                        const wording::Scale& scale) {
  if (!change) return or_dash("");
  wording::RoundedEstimate rounded = wording::round_by_interval(*change, scale);
  rounded.estimate = wording::with_plus_sign(rounded.estimate);
  return text_of(rounded);
}

std::string name_of(const history::ComparedQuantity& q) {
  return wording::words_for("quantity", q.name, q.words);
}

/// "Coulomb torque [mN·m]"
std::string quantity_text(const history::ComparedQuantity& q, const wording::Scale& scale) {
  return scale.unit.empty() ? name_of(q) : name_of(q) + " [" + scale.unit + "]";
}

std::string time_text(const calibration::Facts& f) {
  return f.time_is_stated ? f.measured_at : tr("{time} (identified)", {{"time", f.measured_at}});
}

std::string number_text(const std::optional<double>& value, const char* unit) {
  return value ? wording::with_unit(wording::as_stated(*value), unit) : or_dash("");
}

std::string verdict_text(calibration::Verdict verdict) {
  return wording::words_for("archived_verdict", calibration::to_string(verdict));
}

/// What is said of quantities, with the names of those it is said of.
class SharedStatements {
 public:
  void add(const Statement& statement, const std::string& of) {
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
      notes.push_back(as_sentence(sentence(wording::listed(one.names), one.statement)));
    }
  }

 private:
  struct One {
    Statement statement;
    std::vector<std::string> names;
  };
  std::vector<One> all_;
};

}  // namespace

std::string comparison_sentence(const history::Comparison& c) {
  const std::size_t changed = c.count(history::ChangeWord::changed);
  const std::size_t comparable = changed + c.count(history::ChangeWord::no_change_seen);
  const std::size_t others = c.count(history::ChangeWord::not_comparable);
  if (comparable == 0) return tr("Nothing is comparable.");
  const auto n = static_cast<std::int64_t>(comparable);
  std::string sentence = changed > 0
                             ? tr_count(n, "{changed} of {comparable} comparable quantity changed",
                                        "{changed} of {comparable} comparable quantities changed",
                                        {{"changed", changed}, {"comparable", comparable}})
                             : tr_count(n, "No change seen in {comparable} comparable quantity",
                                        "No change seen in {comparable} comparable quantities",
                                        {{"comparable", comparable}});
  if (others > 0) {
    sentence += "; " + tr_count(static_cast<std::int64_t>(others), "{others} is not comparable",
                                "{others} are not comparable", {{"others", others}});
  }
  return sentence + ".";
}

Table compared_quantities_table(const history::Comparison& c) {
  Table table;
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

Table compared_conditions_table(const history::Comparison& c) {
  const calibration::Facts& a = c.first.facts;
  const calibration::Facts& b = c.second.facts;
  Table table;
  table.id = "table-conditions";
  table.is_stacked = true;
  table.caption = tr("How they were measured");
  table.columns = {{tr("Condition"), "", false},
                   {tr("First"), "", false, true},
                   {tr("Second"), "", false, true}};
  const auto add = [&](const std::string& name, const std::string& first,
                       const std::string& second) {
    table.rows.push_back({{name, or_dash(first), or_dash(second)}, false});
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
    for (const Statement& why : q.why_not) why_not.add(why, name_of(q));
    if (q.word == history::ChangeWord::not_comparable) continue;
    for (const Statement& caution : q.cautions) cautions.add(caution, name_of(q));
  }
  std::vector<std::string> notes;
  for (const Statement& remark : c.remarks) notes.push_back(as_sentence(remark));
  why_not.append_to(notes, [](const std::string& quantities, const Statement& why) {
    return tr("{quantities}, not comparable: {why}", {{"quantities", quantities}, {"why", why}});
  });
  cautions.append_to(notes, [](const std::string& quantities, const Statement& caution) {
    return tr("{quantities}, with caution: {caution}",
              {{"quantities", quantities}, {"caution", caution}});
  });
  return notes;
}

namespace {

void fill_verdict(const history::Comparison& c, TemplateValues& values) {
  TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  const std::size_t changed = c.count(history::ChangeWord::changed);
  const std::size_t same = c.count(history::ChangeWord::no_change_seen);
  const std::size_t others = c.count(history::ChangeWord::not_comparable);
  const Outcome outcome = same + changed == 0         ? Outcome::absent
                          : changed > 0 || others > 0 ? Outcome::partial
                                                      : Outcome::good;
  verdict.set("WORD", changed > 0 ? tr("CHANGED")
                      : same > 0  ? tr("NO CHANGE SEEN")
                                  : tr("NOT COMPARABLE"));
  verdict.set("SENTENCE", comparison_sentence(c));
  fill_outcome(outcome, verdict);
  const std::vector<std::string> notes = comparison_notes(c);
  if (notes.empty()) return;
  TemplateValues& findings = verdict.add_section("FINDINGS");
  for (const std::string& note : notes) findings.add_section("FINDING").set("TEXT", note);
}

}  // namespace

std::string comparison_page(const history::Comparison& comparison,
                            const calibration::Provenance& provenance,
                            const std::string& curves_missing,
                            const std::vector<figures::ReportFigure>& figures,
                            const std::vector<render::workers::DrawnFigure>& drawn,
                            wording::Language language) {
  const wording::WordsIn words(language);
  TemplateValues values;
  fill_head(provenance, values);
  const calibration::JointName& of = comparison.first.facts.of;
  values.set("TITLE", tr("{robot}, joint {joint}",
                         {{"robot", or_dash(of.robot)}, {"joint", or_dash(of.joint)}}));
  fill_verdict(comparison, values);
  fill_table(compared_quantities_table(comparison), "CHANGES", values);
  fill_table(compared_conditions_table(comparison), "CONDITIONS", values);
  for (const FigureCard& card : figure_cards(figures, drawn)) fill_figure(card, values);
  values.set_optional("CURVES_MISSING", curves_missing);
  values.set_checked_by_modifier("RESULT_JSON", history::comparison_json(comparison));
  return expand_template("diff.tpl", values, language);
}

}  // namespace tribolog::report
