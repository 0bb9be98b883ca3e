#include "inspect/survey/column_table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "inspect/survey/text_table.h"

namespace tribolog {
namespace {

std::string number(double value) { return std::isnan(value) ? "-" : fmt::format("{:.5g}", value); }

/// Columns of tables that look alike, over all of them.
struct ColumnOfAll {
  ColumnSurvey column;
  bool is_constant{true};
};

/// Remarks on columns, each once below the table.
class Remarks {
 public:
  /// The mark by which a remark is found: "(1)".
  std::string mark_of(const std::string& remark) {
    auto at = std::find(remarks_.begin(), remarks_.end(), remark);
    if (at == remarks_.end()) at = remarks_.insert(at, remark);
    return fmt::format("({})", at - remarks_.begin() + 1);
  }
  [[nodiscard]] std::string text() const {
    TextTable lines(2);
    for (std::size_t k = 0; k < remarks_.size(); ++k) {
      lines.add({fmt::format("({})", k + 1), remarks_[k]});
    }
    return remarks_.empty() ? "" : lines.text();
  }

 private:
  std::vector<std::string> remarks_;
};

std::vector<std::string> column_cells(const ColumnOfAll& of_all, Remarks& remarks) {
  const ColumnSurvey& c = of_all.column;
  std::vector<std::string> cells{printable(c.name, longest_name)};
  std::vector<std::string> notes;
  if (c.meaning) {
    const ColumnMeaning& m = *c.meaning;
    cells.push_back((m.is_target ? "target " : "") + quantity_word(m.quantity));
    cells.push_back(printable(m.joint, longest_name));
    cells.push_back(printable(m.unit) + (m.unit_is_stated ? "" : "?"));
    if (!c.guessed_by.empty()) notes.push_back("guessed: " + c.guessed_by);
    if (!m.effort.remark.empty()) notes.push_back(remarks.mark_of(m.effort.remark));
  } else {
    cells.insert(cells.end(), {"?", "", printable(c.unit)});
  }
  cells.push_back(number(c.lowest));
  cells.push_back(number(c.highest));
  cells.push_back(c.step > 0 ? fmt::format("{:.3g}", c.step) : "");
  if (std::isnan(c.lowest)) {
    notes.emplace_back("nothing but gaps");
  } else if (of_all.is_constant) {
    notes.emplace_back("constant");
  }
  if (c.gaps > 0 && !std::isnan(c.lowest)) notes.push_back(plural(c.gaps, "gap"));
  std::string note;
  for (const std::string& one : notes) note += (note.empty() ? "" : "; ") + one;
  cells.push_back(note);
  return cells;
}

void take_in(const ColumnSurvey& other, ColumnOfAll& all) {
  const bool same = other.lowest == all.column.lowest && other.highest == all.column.highest;
  all.is_constant = all.is_constant && other.is_constant() && same;
  all.column.gaps += other.gaps;
  all.column.lowest = std::fmin(all.column.lowest, other.lowest);
  all.column.highest = std::fmax(all.column.highest, other.highest);
  if (other.step > 0) {
    all.column.step = all.column.step > 0 ? std::min(all.column.step, other.step) : other.step;
  }
}

}  // namespace

std::string columns_text(const std::vector<const TableSurvey*>& tables) {
  TextTable table(2);
  Remarks remarks;
  table.add({"column", "meaning", "joint", "unit", "lowest", "highest", "step", ""});
  for (std::size_t k = 0; k < tables.front()->columns.size(); ++k) {
    const ColumnSurvey& first = tables.front()->columns[k];
    ColumnOfAll all{first, first.is_constant()};
    for (std::size_t t = 1; t < tables.size(); ++t) take_in(tables[t]->columns[k], all);
    table.add(column_cells(all, remarks));
  }
  std::string text = table.text();
  const bool guessed = text.find("?") != std::string::npos;
  if (guessed) text += "  (?: not stated by the log)\n";
  return text + remarks.text();
}

}  // namespace tribolog
