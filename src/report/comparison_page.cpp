#include "report/comparison_page.h"

#include <cmath>

#include <fmt/format.h>

#include "base/requirements.h"
#include "history/history_json.h"
#include "history/quantity_traits.h"
#include "report/element_values.h"
#include "report/page_style.h"
#include "report/view_parts.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/units.h"

namespace tribolog::report {

namespace {

using history::ChangeWord;
using history::ComparedQuantity;
using history::Comparison;

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

/// "Coulomb torque [mN·m]"
std::string quantity_text(const history::ComparedQuantity& q, const wording::Scale& scale) {
  return scale.unit.empty() ? q.words : q.words + " [" + scale.unit + "]";
}

std::string time_text(const calibration::Facts& f) {
  return f.measured_at + (f.time_is_stated ? "" : " (identified)");
}

std::string number_text(const std::optional<double>& value, const char* unit) {
  return value ? wording::with_unit(wording::as_stated(*value), unit) : or_dash("");
}

/// What is said of quantities, with the names of those it is said of.
class SharedTexts {
 public:
  void add(const std::string& text, const std::string& of) {
    for (auto& [known, names] : texts_) {
      if (known != text) continue;
      names.push_back(of);
      return;
    }
    texts_.push_back({text, {of}});
  }
  void append_to(std::vector<std::string>& notes, const std::string& word) const {
    for (const auto& [text, names] : texts_) {
      notes.push_back(as_sentence(fmt::format("{}{}: {}", wording::listed(names), word, text)));
    }
  }

 private:
  std::vector<std::pair<std::string, std::vector<std::string>>> texts_;
};

}  // namespace

std::string comparison_sentence(const history::Comparison& c) {
  const std::size_t changed = c.count(history::ChangeWord::changed);
  const std::size_t comparable = changed + c.count(history::ChangeWord::no_change_seen);
  const std::size_t others = c.count(history::ChangeWord::not_comparable);
  std::string sentence = "Nothing is comparable";
  if (changed > 0) {
    sentence = fmt::format("{} of {} comparable {} changed", changed, comparable,
                           comparable == 1 ? "quantity" : "quantities");
  } else if (comparable > 0) {
    sentence = fmt::format("No change seen in {} comparable {}", comparable,
                           comparable == 1 ? "quantity" : "quantities");
  }
  if (others > 0 && comparable > 0) {
    sentence += fmt::format("; {} {} not comparable", others, others == 1 ? "is" : "are");
  }
  return sentence + ".";
}

Table compared_quantities_table(const history::Comparison& c) {
  Table table;
  table.id = "table-changes";
  table.is_stacked = true;
  table.caption = "Each quantity and its change";
  table.columns = {{"Quantity", "", false, true}, {"First", "", true},      {"Second", "", true},
                   {"Change", "", true},          {"In percent", "", true}, {"Word", "", false}};
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
          signed_text(change, scale), signed_text(percent, {1, "%"}), history::to_string(q.word)},
         q.word == history::ChangeWord::changed});
  }
  table.note = fmt::format(
      "At the motor, with 95 % intervals; that of a change is of both, which are independent. "
      "“changed” needs a chance of at most {:.3g} % over all quantities together (Holm), so that "
      "many quantities do not make a change by chance.",
      100 * history::changed_chance);
  return table;
}

Table compared_conditions_table(const history::Comparison& c) {
  const calibration::Facts& a = c.first.facts;
  const calibration::Facts& b = c.second.facts;
  Table table;
  table.id = "table-conditions";
  table.is_stacked = true;
  table.caption = "How they were measured";
  table.columns = {
      {"Condition", "", false}, {"First", "", false, true}, {"Second", "", false, true}};
  const auto add = [&](const char* name, const std::string& first, const std::string& second) {
    table.rows.push_back({{name, or_dash(first), or_dash(second)}, false});
  };
  add("Calibration", c.first.id.substr(0, calibration::shown_digits),
      c.second.id.substr(0, calibration::shown_digits));
  add("Robot", a.of.robot, b.of.robot);
  add("Serial number", a.of.serial, b.of.serial);
  add("Joint", a.of.joint, b.of.joint);
  add("Measured", time_text(a), time_text(b));
  add("Operator", a.operator_name, b.operator_name);
  add("Temperature", number_text(a.temperature_C, "°C"), number_text(b.temperature_C, "°C"));
  add("Payload", a.payload, b.payload);
  add("Payload's mass", number_text(a.payload_kg, "kg"), number_text(b.payload_kg, "kg"));
  add("Gear ratio", wording::as_stated(a.gear_ratio), wording::as_stated(b.gear_ratio));
  add("Sampling rate", number_text(a.sampling_Hz, "Hz"), number_text(b.sampling_Hz, "Hz"));
  add("Verdict", calibration::to_string(a.verdict), calibration::to_string(b.verdict));
  add("Made by tribolog", a.tool_version, b.tool_version);
  return table;
}

std::vector<std::string> comparison_notes(const history::Comparison& c) {
  SharedTexts why_not;
  SharedTexts cautions;
  for (const history::ComparedQuantity& q : c.quantities) {
    for (const std::string& text : q.why_not) why_not.add(text, q.words);
    if (q.word == history::ChangeWord::not_comparable) continue;
    for (const std::string& text : q.cautions) cautions.add(text, q.words);
  }
  std::vector<std::string> notes;
  for (const std::string& remark : c.remarks) notes.push_back(as_sentence(remark));
  why_not.append_to(notes, ", not comparable");
  cautions.append_to(notes, ", with caution");
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
  verdict.set("WORD", changed > 0 ? "CHANGED" : same > 0 ? "NO CHANGE SEEN" : "NOT COMPARABLE");
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
  TemplateValues values;
  fill_head(provenance, values);
  const calibration::JointName& of = comparison.first.facts.of;
  values.set("TITLE", fmt::format("{}, joint {}", or_dash(of.robot), or_dash(of.joint)));
  fill_verdict(comparison, values);
  fill_table(compared_quantities_table(comparison), "CHANGES", values);
  fill_table(compared_conditions_table(comparison), "CONDITIONS", values);
  for (const FigureCard& card : figure_cards(figures, drawn)) fill_figure(card, values);
  values.set_optional("CURVES_MISSING", curves_missing);
  values.set_checked_by_modifier("RESULT_JSON", history::comparison_json(comparison));
  return expand_template("diff.tpl", values, language);
}

}  // namespace tribolog::report
