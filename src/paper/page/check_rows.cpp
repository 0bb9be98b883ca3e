#include <algorithm>
#include <cmath>

#include "paper/page/page_parts.h"
#include "report/elements/element_values.h"
#include "report/engine/template_engine.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/tr.h"

namespace tribolog::paper::page {
namespace {

using wording::tr;

constexpr int most_digits = 8;

std::string small(double value) { return value == 0 ? "0" : wording::significant(value, 2); }

std::string without_end_zeros(std::string number) {
  if (number.find('.') == std::string::npos) return number;
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') number.pop_back();
  return number;
}

/// All the digits that a bound has (checks::as_shown).
std::string bound_text(double bound) {
  if (bound == 0) return "0";
  constexpr int digits = 3;
  const std::string text = wording::significant(bound, digits);
  const std::size_t power = text.find("×");
  return without_end_zeros(text.substr(0, power)) +
         (power == std::string::npos ? "" : text.substr(power));
}

/// As many decimals as show the second digit of what is allowed, and one more; no more digits than
/// a double means.
std::string seen_against(double bound, double value, int least_places) {
  if (bound <= 0 || value == 0) return wording::as_stated(value);
  const int before_point = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  const int places = std::max(wording::decimals_for(bound) + 1, least_places);
  return wording::fixed(value, std::clamp(places, 0, std::max(0, most_digits - before_point)));
}

std::string kind_word(checks::Kind kind) {
  return kind == checks::Kind::print ? tr("print") : tr("independent");
}

/// "−0.0088, 8.8 last places"
std::string with_last_places(const std::string& difference, double last_places) {
  return tr("{difference}, {last_places} last places",
            {{"difference", difference},
             {"last_places", wording::significant(std::abs(last_places), 2)}});
}

}  // namespace

CheckTexts check_texts(const checks::Check& check) {
  CheckTexts out;
  out.kind = kind_word(check.kind);
  if (check.is_words()) {
    out.expected = check.expected_words;
    out.ours = check.ours_words.empty() ? "–" : check.ours_words;
    out.difference = check.holds() ? tr("none") : tr("another");
    out.allowed = tr("none");
    return out;
  }
  const bool is_zero = check.expected == 0;
  if (check.printed_places >= 0) {
    out.expected = wording::fixed(check.expected, check.printed_places);
  } else {
    out.expected = is_zero ? "0" : without_end_zeros(seen_against(check.bound, check.expected, 0));
  }
  out.ours =
      is_zero ? small(check.ours) : seen_against(check.bound, check.ours, check.printed_places);
  out.difference = small(check.difference());
  const std::optional<double> last_places = check.in_last_places();
  if (check.kind == checks::Kind::print && last_places && std::abs(*last_places) >= 1) {
    out.difference = with_last_places(out.difference, *last_places);
  }
  out.allowed = bound_text(check.bound);
  return out;
}

std::string tick(bool is_well) { return is_well ? "✓" : "✗"; }

void fill_checks(const checks::Checks& checks, const std::string& id, const std::string& caption,
                 const std::string& marker, report::engine::TemplateValues& values) {
  if (checks.empty()) return;
  report::engine::TemplateValues& table = values.add_include(marker, "check_table.tpl");
  table.set("TABLE_ID", "checks-" + id);
  table.set("TABLE_CAPTION", caption);
  for (const checks::Check& check : checks) {
    const CheckTexts texts = check_texts(check);
    report::engine::TemplateValues& row = table.add_section("CHECK");
    row.set("STATE", check.holds() ? "holds" : "fails");
    row.set("WHAT", check.what);
    row.set_optional("REASON", check.reason);
    row.set("EXPECTED", texts.expected);
    row.set("KIND_OF_CHECK", texts.kind);
    row.set("OURS", texts.ours);
    row.set("UNIT", check.unit.empty() ? "–" : check.unit);
    row.set("DIFFERENCE", texts.difference);
    row.set("ALLOWED", texts.allowed);
    row.set("TICK", tick(check.holds()));
  }
}

}  // namespace tribolog::paper::page
