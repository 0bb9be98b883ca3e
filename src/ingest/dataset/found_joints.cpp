#include "ingest/dataset/found_joints.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "base/requirements.h"
#include "ingest/layout/log_layout.h"
#include "ingest/log/units.h"

namespace tribolog::ingest::dataset {

std::vector<log::ColumnHeader> headers_of(const log::LogTable& table) {
  std::vector<log::ColumnHeader> headers;
  for (const log::LogColumn& column : table.columns) headers.push_back(column.header);
  return headers;
}

std::vector<joint::OtherJoint> joints_in_columns(const std::vector<log::ColumnHeader>& header,
                                                 const manifest::RecordingEntry& entry) {
  std::vector<joint::OtherJoint> others;
  if (!entry.columns.angle) return others;
  const manifest::ColumnEntry& own = *entry.columns.angle;
  const layout::LogLayout layout = layout::guess_layout(header);
  const auto is_own = [&](const layout::ColumnMeaning& meaning) {
    const log::ColumnHeader& of = header[meaning.column];
    return of.full == own.name || of.name == own.name || own.name.ends_with("/" + of.full);
  };
  const auto tested = std::find_if(layout.columns.begin(), layout.columns.end(), is_own);
  if (tested == layout.columns.end()) return others;
  for (const layout::ColumnMeaning& meaning : layout.columns) {
    const bool is_one = meaning.quantity == log::Quantity::angle && !meaning.is_target &&
                        meaning.joint != tested->joint && !meaning.joint.empty();
    const auto is_same = [&](const joint::OtherJoint& one) { return one.name == meaning.joint; };
    if (!is_one || std::any_of(others.begin(), others.end(), is_same)) continue;
    joint::OtherJoint& other = others.emplace_back();
    other.name = meaning.joint;
    other.angle = header[meaning.column].full;
    other.radian_per_unit = std::abs(own.si_factor);  // as the tested joint's
    other.stated_at = entry.file;
  }
  return others;
}

void add_joints_in_rows(const manifest::RecordingEntry& entry, const log::LogColumn& named_by,
                        const log::LogColumn& angle, ReadLog& part) {
  constexpr std::size_t most_joints = 64;
  const manifest::ColumnEntry& own = present(entry.columns.angle);
  if (named_by.words.size() > most_joints) return;
  const std::string& value = present(entry.columns.rows).value;
  std::vector<std::vector<double>> angles(named_by.words.size());
  std::vector<double> last(named_by.words.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t row = 0; row < angle.values.size(); ++row) {
    if (std::isnan(named_by.values[row])) continue;
    const auto word = static_cast<std::size_t>(named_by.values[row]);
    last[word] = angle.values[row];
    if (named_by.words[word] != value) continue;
    for (std::size_t k = 0; k < angles.size(); ++k) angles[k].push_back(last[k]);
  }
  for (std::size_t k = 0; k < angles.size(); ++k) {
    if (named_by.words[k] == value) continue;
    joint::OtherJoint& other = part.found_others.emplace_back();
    other.name = other.angle = named_by.words[k];
    other.radian_per_unit = std::abs(own.si_factor);
    other.stated_at = entry.file;
    log::LogColumn column;
    column.header.full = column.header.name = other.angle;
    column.values = std::move(angles[k]);
    part.others.emplace(other.angle, std::move(column));
  }
}

}  // namespace tribolog::ingest::dataset
