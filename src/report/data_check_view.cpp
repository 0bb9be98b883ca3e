// The checks on the data, as rows of their table.

#include <algorithm>
#include <cmath>

#include "report/view_parts.h"

namespace tribolog::report {
namespace {

Outcome outcome_of(CheckState state) {
  switch (state) {
    case CheckState::passed:
      return Outcome::good;
    case CheckState::warns:
      return Outcome::partial;
    case CheckState::fails:
      return Outcome::bad;
    case CheckState::not_applicable:
      break;
  }
  return Outcome::absent;
}

std::string word_of(CheckState state) {
  return state == CheckState::not_applicable ? "not applicable" : to_string(state);
}

std::string with_the_unit(double value, const std::string& unit, int digits) {
  // Below what any limit asks for it is nothing.
  constexpr double nothing = 5e-4;
  const std::string number = std::abs(value) < nothing ? "0" : significant(value, digits);
  return unit == "1" ? number : with_unit(number, unit == "deg" ? "°" : unit);
}

std::string limit_in_words(const DataCheck& check) {
  const auto bound = [&](double value) {
    const std::string number = as_stated(value);
    return check.unit == "1" ? number : with_unit(number, check.unit == "deg" ? "°" : check.unit);
  };
  if (check.at_least && check.at_most) {
    return as_stated(*check.at_least) + " to " + bound(*check.at_most);
  }
  if (check.at_least) return "≥ " + bound(*check.at_least);
  return check.at_most ? "≤ " + bound(*check.at_most) : "";
}

}  // namespace

std::vector<DataCheckRow> data_check_rows(const DataChecksResult& checks) {
  std::vector<DataCheckRow> rows;
  for (const DataCheck& check : checks.checks) {
    DataCheckRow row;
    row.id = "check-" + check.name;
    std::replace(row.id.begin(), row.id.end(), '_', '-');
    row.title = check.title;
    row.measure = check.measure;
    row.outcome = outcome_of(check.state);
    row.state_word = word_of(check.state);
    if (check.measured) row.measured = with_the_unit(*check.measured, check.unit, 3);
    row.limit = limit_in_words(check);
    if (check.recording != "all") row.recording = check.recording;
    row.found = as_sentence(check.found);
    row.consequence = as_sentence(check.consequence);
    row.experiment = as_sentence(check.experiment);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace tribolog::report
