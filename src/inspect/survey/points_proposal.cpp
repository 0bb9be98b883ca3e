// A manifest for friction that was read elsewhere: rows of speed and friction torque, without a
// clock.

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "base/requirements.h"
#include "ingest/manifest/toml_document.h"
#include "inspect/survey/manifest_proposal.h"
#include "inspect/survey/survey_parts.h"

namespace tribolog::inspect::survey {
namespace {

using ingest::log::Quantity;

struct PointColumns {
  std::size_t log{};
  std::size_t table{};
  std::size_t speed{};
  std::size_t torque{};
};

/// The first that is measured, whatever joint its name states: "friction torque".
std::optional<std::size_t> first_of(const TableSurvey& table, Quantity quantity) {
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const auto& meaning = table.columns[k].meaning;
    if (meaning && meaning->quantity == quantity && !meaning->is_target) return k;
  }
  return std::nullopt;
}

/// Of a table without a clock and without an angle that has a speed and a torque of one joint.
std::optional<PointColumns> points_in(const std::vector<LogSurvey>& logs, std::size_t log) {
  for (std::size_t t = 0; t < logs[log].tables.size(); ++t) {
    const TableSurvey& table = logs[log].tables[t];
    const auto speed = first_of(table, Quantity::angular_speed);
    const auto torque = first_of(table, Quantity::torque);
    if (table.clock || !table.joints.empty() || !speed || !torque) continue;
    return PointColumns{log, t, *speed, *torque};
  }
  return std::nullopt;
}

std::string relative_path(const std::string& file, const std::string& directory) {
  namespace fs = std::filesystem;
  const fs::path whole = fs::absolute(file).lexically_normal();
  const fs::path base = fs::absolute(directory.empty() ? "." : directory).lexically_normal();
  const fs::path relative = whole.lexically_relative(base);
  return (relative.empty() ? whole : relative).generic_string();
}

std::string column_text(const char* key, const ColumnSurvey& column, const ProposalOptions& options,
                        bool is_speed) {
  const ingest::layout::ColumnMeaning& meaning = present(column.meaning);
  std::string text =
      fmt::format("{} = {{ name = {}, unit = {}", key, ingest::manifest::toml_text(column.key),
                  ingest::manifest::toml_text(meaning.unit));
  if (is_speed && options.columns.angle_side == joint::Side::motor) text += ", side = \"motor\"";
  if (is_speed && !meaning.unit_is_stated) text += ", confirmed = false";
  return text + " }" + (meaning.unit_is_stated ? "" : "  # unit guessed, the file states none");
}

/// How the files are read, where that was stated or found.
std::string log_rules_text(const std::vector<LogSurvey>& logs, const ProposalOptions& options) {
  const ingest::text::TextLogRules& rules = options.log_rules;
  std::string lines;
  const bool has_commas = std::any_of(logs.begin(), logs.end(), [](const LogSurvey& log) {
    return log.refusal.empty() && log.has_decimal_commas;
  });
  if (has_commas) lines += "decimal_comma = true\n";
  if (rules.encoding == ingest::text::TextEncoding::latin1) lines += "encoding = \"latin1\"\n";
  if (rules.header_line) lines += fmt::format("header_line = {}\n", *rules.header_line);
  if (rules.skip_bad_rows) lines += "skip_bad_rows = true\n";
  return lines.empty() ? lines : "\n[log]\n" + lines;
}

}  // namespace

std::optional<ManifestProposal> propose_friction_points(const std::vector<LogSurvey>& logs,
                                                        const ProposalOptions& options) {
  std::vector<PointColumns> found;
  for (std::size_t log = 0; log < logs.size(); ++log) {
    if (!logs[log].refusal.empty()) continue;
    const auto points = points_in(logs, log);
    if (!points) return std::nullopt;
    found.push_back(*points);
  }
  if (found.empty()) return std::nullopt;
  const TableSurvey& first = logs[found.front().log].tables[found.front().table];
  const bool is_certain = present(first.columns[found.front().torque].meaning).unit_is_stated;
  const joint::EffortKind kind = options.effort_kind.value_or(joint::EffortKind::joint_torque);
  const joint::Side side = options.effort_side.value_or(
      kind == joint::EffortKind::motor_torque ? joint::Side::motor : joint::Side::joint);
  const double gear_ratio = options.gear_ratio.value_or(1);
  const bool knows_side = gear_ratio == 1 || options.effort_kind || options.effort_side;
  ManifestProposal proposal;
  proposal.effort.kind = kind;
  proposal.text = fmt::format(
      "# Proposed by tribolog from the files alone. Each guess is marked; look at it before use.\n"
      "schema = \"tribolog-dataset-1\"\n\n[robot]\nname = {}\n\n[joint]\nname = \"joint\"\n"
      "gear_ratio = {}\n\n[effort]\nkind = \"{}\"\nside = \"{}\"\n{}",
      ingest::manifest::toml_text(options.robot.value_or(joint::unnamed_robot)), gear_ratio,
      joint::to_string(kind), joint::to_string(side),
      is_certain && knows_side ? "" : "confirmed = false  # a guess; true, once it is looked at\n");
  proposal.text += log_rules_text(logs, options);
  for (const PointColumns& points : found) {
    const TableSurvey& table = logs[points.log].tables[points.table];
    proposal.text += fmt::format(
        "\n[[recording]]\nrole = \"friction_points\"  # a row for each point, gravity taken off "
        "before\nfile = {}\n[recording.columns]\n{}\n{}\n",
        ingest::manifest::toml_text(relative_path(logs[points.log].file, options.directory)),
        column_text("speed", table.columns[points.speed], options, true),
        column_text("effort", table.columns[points.torque], options, false));
    ProposedRecording recording;
    recording.of = {points.log, points.table, 0};
    recording.role = joint::Role::friction_points;
    proposal.roles.recordings.push_back(std::move(recording));
    if (!present(table.columns[points.speed].meaning).unit_is_stated) {
      proposal.only_proposed = {"the speed's unit, rad/s (--speed-unit)"};
      proposal.open = {"--speed-unit rad/s"};
    }
  }
  return proposal;
}

}  // namespace tribolog::inspect::survey
