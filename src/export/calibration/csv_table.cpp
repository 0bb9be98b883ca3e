#include "export/calibration/csv_table.h"

#include <string_view>

#include <fmt/format.h>

#include "base/shortest_number.h"
#include "calibration/gear_side.h"
#include "export/calibration/comment_lines.h"

namespace tribolog::archive {
namespace {

constexpr std::string_view formula_starts = "=+-@";

std::string cell(const std::string& text) {
  std::string safe = one_line(text);
  if (!safe.empty() && formula_starts.find(safe.front()) != std::string_view::npos) {
    safe.insert(0, 1, '\'');
  }
  if (safe.find_first_of(",;\"") == std::string::npos) return safe;
  std::string quoted = "\"";
  for (const char c : safe) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// A spreadsheet splits a comment at separators like any line: what follows one is no formula.
std::string comment(const std::string& line) {
  std::string text = "# ";
  bool starts_cell = false;
  for (const char c : line) {
    if (starts_cell && formula_starts.find(c) != std::string_view::npos) text += '\'';
    starts_cell = c == ',' || c == ';' || (starts_cell && (c == ' ' || c == '"'));
    text += c;
  }
  return text + "\n";
}

}  // namespace

std::string csv_table(const ArchivedJoint& joint) {
  std::string text;
  for (const std::string& line : comment_lines(joint)) text += comment(line);
  text += comment("low and high: 95 % interval; empty: not identified");
  text += "quantity,value,low,high,unit,side,verdict,conversion\n";
  for (const SidedQuantity& row : on_both_sides(joint.quantities, joint.entry.facts.gear_ratio)) {
    const Quantity& q = row.quantity;
    text += cell(q.name) + ",";
    if (q.estimate) append_number(text, q.estimate->value);
    text += ",";
    if (q.estimate) append_number(text, q.estimate->low);
    text += ",";
    if (q.estimate) append_number(text, q.estimate->high);
    text += fmt::format(",{},{},{},{}\n", cell(q.unit), to_string(row.side),
                        tribolog::to_string(q.verdict), conversion_words(row.gear_power));
  }
  return text;
}

}  // namespace tribolog::archive
