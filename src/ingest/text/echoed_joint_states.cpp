#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/requirements.h"
#include "ingest/text/csv_rows.h"
#include "ingest/text/fields.h"

namespace tribolog::ingest::text {
namespace {

constexpr std::size_t before_names = 3;  // sec, nanosec, frame_id
constexpr std::array joint_arrays = {"position", "velocity", "effort"};

bool is_joint_name(const Field& field) { return read_number(field.text).kind == FieldKind::text; }

/// Digits alone, as seconds and nanoseconds are.
bool is_whole_number(const Field& field) {
  constexpr std::size_t most_digits = 10;
  return !field.text.empty() && field.text.size() <= most_digits &&
         std::all_of(field.text.begin(), field.text.end(), is_digit);
}

/// The joints that a row names; empty: it is another message.
std::vector<std::string> joints_of(const std::vector<Field>& row) {
  if (row.size() <= before_names || !is_whole_number(row[0]) || !is_whole_number(row[1]) ||
      is_whole_number(row[2])) {
    return {};
  }
  std::vector<std::string> joints;
  for (std::size_t k = before_names; k < row.size() && is_joint_name(row[k]); ++k) {
    joints.push_back(row[k].text);
  }
  const auto rest = row.begin() + static_cast<std::ptrdiff_t>(before_names + joints.size());
  return std::any_of(rest, row.end(), is_joint_name) ? std::vector<std::string>() : joints;
}

/// Where each of the three arrays begins, and whether it is there; nothing where the cells do not
/// show it.
std::optional<std::array<std::optional<std::size_t>, joint_arrays.size()>> arrays_in(
    const std::vector<Field>& row, std::size_t joints) {
  std::array<std::optional<std::size_t>, joint_arrays.size()> begins;
  std::size_t at = before_names + joints;
  for (auto& begin : begins) {
    if (at >= row.size()) return std::nullopt;
    if (row[at].text.empty()) {
      ++at;
      continue;
    }
    begin = at;
    at += joints;
  }
  const auto first = row.begin() + static_cast<std::ptrdiff_t>(before_names + joints);
  const auto empty = std::count_if(first, row.end(), [](const Field& f) { return f.text.empty(); });
  const auto absent = std::count(begins.begin(), begins.end(), std::nullopt);
  return at == row.size() && empty == absent ? std::optional(begins) : std::nullopt;
}

}  // namespace

bool EchoedJointStates::may_begin_with(const std::vector<Field>& row) {
  return !joints_of(row).empty();
}

std::optional<EchoedJointStates> EchoedJointStates::in(
    const std::vector<std::vector<Field>>& rows) {
  std::map<std::vector<std::string>, std::size_t> rows_of_joints;
  std::size_t messages = 0;
  for (const std::vector<Field>& row : rows) {
    const std::vector<std::string> joints = joints_of(row);
    if (joints.empty()) continue;
    ++messages;
    ++rows_of_joints[joints];
  }
  if (rows.empty() || !may_begin_with(rows.front()) || 2 * messages <= rows.size()) {
    return std::nullopt;
  }
  const auto most =
      std::max_element(rows_of_joints.begin(), rows_of_joints.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most->second < 2) return std::nullopt;
  EchoedJointStates found;
  found.joints_ = most->first;
  const std::size_t joints = found.joints_.size();
  std::size_t widest = 0;
  for (const std::vector<Field>& row : rows) {
    if (joints_of(row) != found.joints_) continue;
    if (arrays_in(row, joints)) return found;
    widest = std::max(widest, row.size() - before_names - joints);
  }
  if (widest == 0 || widest % joints != 0 || widest > joint_arrays.size() * joints) {
    return std::nullopt;
  }
  found.unknown_numbers_ = widest;
  return found;
}

std::vector<Field> EchoedJointStates::header() const {
  const std::size_t joints = joints_.size();
  std::vector<Field> names = names_by_position(
      before_names + joints + unknown_numbers_.value_or(joint_arrays.size() * joints));
  names[0].text = "sec";
  names[1].text = "nanosec";
  names[2].text = "frame_id";
  for (std::size_t k = 0; k < joints; ++k) {
    names[before_names + k].text = fmt::format("name_{}", k);
    for (std::size_t a = 0; a < joint_arrays.size() && !unknown_numbers_; ++a) {
      names[before_names + (1 + a) * joints + k].text =
          fmt::format("{}.{}", joints_[k], joint_arrays[a]);
    }
  }
  return names;
}

bool EchoedJointStates::lay_out(std::vector<Field>& row) const {
  const std::size_t joints = joints_.size();
  if (row.size() < before_names + joints) return false;
  for (std::size_t k = 0; k < joints; ++k) {
    if (row[before_names + k].text != joints_[k]) return false;
  }
  if (unknown_numbers_) return row.size() == before_names + joints + *unknown_numbers_;
  const auto arrays = arrays_in(row, joints);
  if (!arrays) return false;
  std::vector<Field> whole(row.begin(),
                           row.begin() + static_cast<std::ptrdiff_t>(before_names + joints));
  for (const auto& begin : *arrays) {
    for (std::size_t k = 0; k < joints; ++k) {
      whole.push_back(begin ? row[present(begin) + k] : Field{"", row.back().column});
    }
  }
  row = std::move(whole);
  return true;
}

}  // namespace tribolog::ingest::text
