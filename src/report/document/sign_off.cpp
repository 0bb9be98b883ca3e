#include "report/document/sign_off.h"

#include <string_view>

#include <fmt/format.h>

#include "base/error.h"
#include "report/document/view_parts.h"
#include "report/elements/element_values.h"
#include "report/engine/template_engine.h"
#include "wording/number_text.h"

namespace tribolog::report::document {
namespace {

// No text of a report holds a raw '<', so these are the page's own.
constexpr std::string_view content = "<main id=\"content\">\n";
constexpr std::string_view opening = "<!-- sign-off -->\n";
constexpr std::string_view closing = "<!-- end of sign-off -->\n";

/// "2026-11-22T10:05:00Z" -> "2026-11-22 10:05 UTC"
std::string readable(const std::string& utc) {
  const std::string date = wording::date_of(utc);
  const std::size_t time = date.size() + 1;
  constexpr std::size_t minutes = std::string_view("10:05").size();
  if (utc.size() < time + minutes) return wording::or_dash(utc);
  return date + " " + utc.substr(time, minutes) + " UTC";
}

void fill(const SignOff& decision, engine::TemplateValues& values) {
  values.set("DECISION", decision.is_approved ? "Approved" : "Rejected");
  values.set("REVIEWER", wording::or_dash(decision.reviewer));
  values.set("AT", readable(decision.at_utc));
  elements::fill_lines(decision.note, "NOTE", "LINE", values);
}

/// As the page states it.
wording::Language language_of(const std::string& page) {
  for (const wording::Language& language : wording::languages()) {
    if (page.find(fmt::format("<html lang=\"{}\">", language.code)) != std::string::npos) {
      return language;
    }
  }
  return wording::Language{};
}

}  // namespace

std::string with_sign_off(const std::string& report, const std::string& id,
                          const std::vector<SignOff>& decisions, const std::string& file) {
  std::string page = without_sign_off(report);
  const std::size_t at = page.find(content);
  if (at == std::string::npos || decisions.empty()) {
    throw InputError({file, 0, 0},
                     {"no report of tribolog: decisions have no place in it", "", "", ""});
  }
  engine::TemplateValues values;
  const SignOff& last = decisions.back();
  values.set("OUTCOME", last.is_approved ? "good" : "bad");
  values.set("WORD", last.is_approved ? "✓ Approved" : "✗ Rejected");
  constexpr std::size_t shown_digits = 10;
  values.set("ID", wording::or_dash(id.substr(0, shown_digits)));
  fill(last, values);
  if (decisions.size() > 1) {
    engine::TemplateValues& earlier = values.add_section("EARLIER");
    earlier.set("COUNT", std::to_string(decisions.size() - 1));
    for (std::size_t k = 0; k + 1 < decisions.size(); ++k) {
      fill(decisions[k], earlier.add_section("REVIEW"));
    }
  }
  std::string block(opening);
  block += engine::expand_template("sign_off.tpl", values, language_of(page));
  block += closing;
  return page.insert(at + content.size(), block);
}

std::string without_sign_off(const std::string& report) {
  const std::size_t from = report.find(opening);
  const std::size_t to = report.find(closing, from);
  if (from == std::string::npos || to == std::string::npos) return report;
  return report.substr(0, from) + report.substr(to + closing.size());
}

}  // namespace tribolog::report::document
