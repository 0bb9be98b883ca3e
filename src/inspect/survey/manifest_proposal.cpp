#include "inspect/survey/manifest_proposal.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "base/requirements.h"
#include "base/shown_text.h"
#include "base/utf8.h"
#include "ingest/manifest/manifest_file.h"
#include "ingest/manifest/toml_document.h"
#include "ingest/manifest/toml_table.h"
#include "inspect/survey/survey_parts.h"

namespace tribolog::inspect::survey {
namespace {

constexpr std::size_t usual_decimals = 3;
constexpr double shares_of_interval = 10;

/// A comment may not break its line, whatever a log's name holds.
std::string comment(const std::string& text) {
  return text.empty() ? "" : "  # " + printable(text, 200);
}

class ManifestText {
 public:
  ManifestText(const std::vector<LogSurvey>& logs, const ProposalOptions& options,
               const JointChoice& choice, const RoleProposal& roles)
      : logs_(logs),
        options_(options),
        choice_(choice),
        roles_(roles),
        first_(roles.recordings.front().of),
        effort_(propose_effort(logs, choice.in_logs, options)) {}

  /// A manifest of this joint alone.
  std::string text() {
    add_robot();
    text_ += "\n[joint]\n";
    add_joint(true);
    add_conditions();
    add_effort();
    add_log_rules();
    add_recordings();
    add_other_joints();
    return std::move(text_);
  }

  /// What the manifest of a whole robot has before its joints.
  std::string shared_text() {
    add_robot();
    add_conditions();
    add_log_rules();
    return std::move(text_);
  }

  /// Its joint's part.
  std::string part_of_robot() {
    before_table_ = "joints.";
    text_ += "\n[[joints]]\n";
    add_joint(false);
    add_effort();
    add_recordings();
    return std::move(text_);
  }

 private:
  void add_recordings() {
    text_ += "\n[" + before_table_ + "columns]\n";
    for (const std::string& line : columns_of(first_, true)) text_ += line + "\n";
    if (effort_.kind == joint::EffortKind::none) {
      text_ += "# effort = { name = \"...\", unit = \"A\" }  # or \"Nm\": once it is recorded\n";
      add_places_of_effort();
    }
    for (const ProposedRecording& recording : roles_.recordings) add_recording(recording);
    for (const JointInLog& unused : roles_.without_role) {
      const auto& rows_of = table(unused).rows_of;
      text_ += "\n# " + printable(path_of(unused.log), 200) +
               (table(unused).is_one_of_several
                    ? ", " + printable(rows_of->first) + " " + printable(rows_of->second)
                    : "") +
               ": no motion that a stage reads was found; not used.\n";
    }
  }

  /// Of columns without names no reader finds those of the joints that move beside this one.
  void add_other_joints() {
    constexpr double least_motion_rad = std::numbers::pi / 180;
    for (const JointSurvey& other : table(first_).joints) {
      const ColumnSurvey& angle = table(first_).columns[other.angle];
      const bool is_told = !angle.key.starts_with('#') || angle.is_at_motor || other.name.empty();
      if (other.name == choice_.name || is_told || other.range_rad() < least_motion_rad) continue;
      const bool is_everywhere = std::all_of(
          roles_.recordings.begin(), roles_.recordings.end(), [&](const ProposedRecording& one) {
            const TableSurvey& log = table(one.of);
            return other.angle < log.columns.size() && log.columns[other.angle].key == angle.key;
          });
      if (!is_everywhere) continue;
      text_ += "\n[[other_joint]]\nname = " + ingest::manifest::toml_text(other.name) + "\n";
      line("angle = { name = " + name_in_log(first_, angle.key) +
               ", unit = " + ingest::manifest::toml_text(present(angle.meaning).unit) + " }",
           "guessed: " + angle.guessed_by);
    }
  }

  /// Where columns without names come in groups, those at the joint's place in the further ones.
  void add_places_of_effort() {
    const TableSurvey& log = table(first_);
    if (!log.groups) return;
    std::string names;
    for (std::size_t k = joint(first_).angle + 2 * log.groups->joints; k < log.columns.size();
         k += log.groups->joints) {
      if (log.columns[k].is_constant() || log.columns[k].meaning) continue;
      names += (names.empty() ? "" : ", ") + log.columns[k].name;
    }
    if (names.empty()) return;
    text_ += "# The columns come in groups of " + std::to_string(log.groups->joints) +
             "; this joint's effort may be one of " + names + ".\n";
  }

  [[nodiscard]] const TableSurvey& table(const JointInLog& of) const { return table_of(logs_, of); }
  [[nodiscard]] const JointSurvey& joint(const JointInLog& of) const { return joint_of(logs_, of); }

  void line(const std::string& content, const std::string& note = "") {
    text_ += content + comment(note) + "\n";
  }

  [[nodiscard]] std::string path_of(std::size_t log) const { return path_to(logs_[log].file); }

  [[nodiscard]] std::string path_to(const std::string& log) const {
    namespace fs = std::filesystem;
    const fs::path file = fs::absolute(log).lexically_normal();
    const fs::path base = fs::absolute(options_.directory.empty() ? "." : options_.directory);
    const fs::path relative = file.lexically_relative(base.lexically_normal());
    std::string path = (relative.empty() ? file : relative).generic_string();
    return path == "-" ? "./-" : path;  // alone it would be standard input
  }

  /// A text as the manifest has it.
  /// @throw InputError: a manifest is UTF-8 and cannot hold it.
  [[nodiscard]] std::string quoted(const std::string& text, const char* what,
                                   std::size_t log) const {
    if (!first_broken_utf8(text)) return ingest::manifest::toml_text(text);
    throw InputError({logs_[log].file, 0, 0},
                     {std::string(what) + " is not UTF-8, and no manifest can hold it",
                      in_quotes(text), "", "rename it"});
  }

  void add_robot() {
    line(
        "# Proposed by tribolog from the logs alone. Each guess is marked; look at it before use.");
    line("schema = \"tribolog-dataset-1\"");
    text_ += "\n[robot]\n";
    line("name = " + ingest::manifest::toml_text(robot_name()),
         options_.robot ? "" : "the report goes by it");
    const auto add = [&](const char* key, const std::optional<std::string>& text) {
      if (text) line(std::string(key) + " = " + ingest::manifest::toml_text(named(*text, key)));
    };
    add("serial", options_.serial);
    add("operator", options_.operator_name);
    if (options_.measured_on && ingest::manifest::is_impossible_time(*options_.measured_on)) {
      throw UsageError("--measured-on '" + printable(*options_.measured_on) +
                       "' is no time that there is");
    }
    add("measured_on", options_.measured_on);
  }

  /// @param alone others that move beside it are named.
  void add_joint(bool alone) {
    const bool has_name = choice_.name.find_first_not_of(' ') != std::string::npos;
    line("name = " + (has_name ? quoted(choice_.name, "the joint's name", first_.log)
                               : ingest::manifest::toml_text(joint::unnamed_joint)),
         !has_name ? "the log names none"
         : alone   ? moves_too()
                   : "");
    if (options_.gear_ratio) {
      line(fmt::format("gear_ratio = {}", *options_.gear_ratio));
    } else {
      line("gear_ratio = 1",
           "not known: everything is then stated at the joint; state motor angle "
           "/ joint angle");
    }
    if (options_.has_no_gravity) line("gravity = \"none\"");
  }

  /// @throw UsageError: a name that no manifest takes.
  [[nodiscard]] std::string robot_name() const {
    return options_.robot ? named(*options_.robot, "robot") : joint::unnamed_robot;
  }

  /// @throw UsageError: a text that no manifest takes.
  [[nodiscard]] static std::string named(const std::string& text, const std::string& key) {
    const bool is_blank = text.find_first_not_of(' ') == std::string::npos;
    if (!is_blank && !first_broken_utf8(text)) return text;
    const std::string option = key == "measured_on" ? "measured-on" : key;
    throw UsageError("--" + option + " '" + printable(text) + "' is no name in UTF-8");
  }

  /// What it carried, and how warm it was.
  void add_conditions() {
    if (options_.payload_kg) {
      text_ += fmt::format("\n[payload]\nmass_kg = {}\n", *options_.payload_kg);
    }
    if (options_.known_gravity_Nm_deg) {
      const auto& [amplitude_Nm, peak_deg] = *options_.known_gravity_Nm_deg;
      text_ += fmt::format("\n[known_gravity]\namplitude_Nm = {}\nq_peak_deg = {}\n", amplitude_Nm,
                           peak_deg);
    }
    if (options_.temperature_C) {
      text_ += fmt::format("\n[temperature]\ndegC = {}\n", *options_.temperature_C);
    }
  }

  [[nodiscard]] std::string moves_too() const {
    if (choice_.moves_too.empty()) return "";
    const bool is_stated = options_.joint || states(options_.columns, "angle");
    return std::string(is_stated ? "" : "moves most; ") +
           "these move too: state each as [[other_joint]]; a description of the arm with its "
           "masses, or [[known_load]], takes off what they change of gravity: " +
           list_of_names(choice_.moves_too, 8);
  }

  void add_effort() {
    text_ += "\n[" + before_table_ + "effort]\n";
    for (const std::string& remark : effort_.remarks) text_ += "# " + printable(remark, 300) + "\n";
    for (const std::string& key : effort_.lines) text_ += key + "\n";
  }

  void add_log_rules() {
    const ingest::text::TextLogRules& rules = options_.log_rules;
    std::string lines;
    if (has_decimal_commas()) lines += "decimal_comma = true\n";
    if (rules.encoding == ingest::text::TextEncoding::latin1) lines += "encoding = \"latin1\"\n";
    if (rules.header_line) lines += fmt::format("header_line = {}\n", *rules.header_line);
    const bool is_damaged = std::any_of(logs_.begin(), logs_.end(), [](const LogSurvey& log) {
      return std::any_of(log.tables.begin(), log.tables.end(),
                         [](const TableSurvey& one) { return one.has_impossible_values; });
    });
    if (rules.skip_bad_rows) {
      lines += "skip_bad_rows = true\n";
    } else if (is_damaged) {
      lines += "skip_bad_rows = true  # single numbers that no joint has; their rows are counted\n";
    }
    if (!lines.empty()) text_ += "\n[log]\n" + lines;
  }

  /// @throw InputError: not all logs can be read alike.
  [[nodiscard]] bool has_decimal_commas() const {
    const auto is_text = [](const LogSurvey& log) {
      return log.refusal.empty() && log.format == ingest::log::LogFormat::text;
    };
    const bool has_some = std::any_of(logs_.begin(), logs_.end(), [&](const LogSurvey& log) {
      return is_text(log) && log.has_decimal_commas;
    });
    for (const LogSurvey& log : logs_) {
      if (!has_some || !is_text(log) || log.has_decimal_commas) continue;
      throw InputError({log.file, 0, 0},
                       {"shows no decimal commas, and other logs do", "", "logs that are alike",
                        "a manifest of its own for the others"});
    }
    return has_some;
  }

  /// With the table in front where a log has several.
  [[nodiscard]] std::string name_in_log(const JointInLog& of, const std::string& column) const {
    const bool is_only = logs_[of.log].tables.size() == 1 || table(of).group.empty();
    return quoted(is_only ? column : table(of).group + "/" + column, "the name of a column",
                  of.log);
  }

  [[nodiscard]] std::string column(const JointInLog& of, const std::string& key, std::size_t index,
                                   bool with_comments) const {
    const ColumnSurvey& column = table(of).columns[index];
    const ingest::layout::ColumnMeaning& meaning = present(column.meaning);
    const bool has_other_unit = key == "effort" && !effort_.unit.empty();
    std::string entry =
        fmt::format("{} = {{ name = {}, unit = {}", key, name_in_log(of, column.key),
                    ingest::manifest::toml_text(has_other_unit ? effort_.unit : meaning.unit));
    if (column.of_register) {
      entry += fmt::format(", register = \"{}\"", ingest::log::to_string(*column.of_register));
    }
    if (!column.file.empty()) {
      entry += ", file = " + quoted(path_to(column.file), "the log's name", of.log);
    }
    if (column.is_at_motor) entry += ", side = \"motor\"";
    if (is_only_proposed(key, column)) entry += ", confirmed = false";
    entry += " }";
    if (!with_comments) return entry;
    std::string note;
    if (!column.guessed_by.empty()) note = "guessed: " + column.guessed_by;
    if (column.is_one_of_several()) {
      note += std::string(note.empty() ? "" : "; ") + "one of several columns called " +
              in_quotes(column.name);
    }
    if (column.side_is_open) {
      note += std::string(note.empty() ? "" : "; ") +
              "of the joint or of the motor? --angle-side states it";
    }
    if (!meaning.unit_is_stated && !has_other_unit) {
      note += std::string(note.empty() ? "" : "; ") +
              (column.unit_is_proven ? "" : "unit guessed, ") + "the log states " +
              (meaning.unit_is_ambiguous ? "'Grad'"
               : column.unit_is_proven   ? "no unit"
                                         : "none") +
              (column.unit_by.empty() ? "" : ": " + column.unit_by);
    }
    return entry + comment(note);
  }

  /// An angle's unit or side that nothing proves. The speed's is not asked for: no number rests on
  /// it.
  [[nodiscard]] static bool is_only_proposed(const std::string& key, const ColumnSurvey& column) {
    return key == "angle" && !column.is_certain();
  }

  [[nodiscard]] std::string time_column(const JointInLog& of, bool with_comments) const {
    const ClockSurvey& clock = present(table(of).clock);
    const auto& rate_Hz = options_.columns.rate_Hz;
    if (rate_Hz && !clock.is_counter) {
      const std::string& counter = table(of).counter;
      return fmt::format("time = {{ rate_Hz = {} }}", *rate_Hz) +
             comment(counter.empty() || !with_comments
                         ? ""
                         : in_quotes(counter) +
                               " shows that samples are lost, which this does not "
                               "know; it begins anew and is not used");
    }
    const std::string unit = clock.is_counter ? counted_unit(of) : clock.unit;
    std::string entry = fmt::format("time = {{ name = {}, unit = {}", name_in_log(of, clock.key),
                                    ingest::manifest::toml_text(unit));
    if (clock.plus) {
      entry += fmt::format(", plus = {{ name = {}, unit = {} }}", name_in_log(of, clock.plus->key),
                           ingest::manifest::toml_text(clock.plus->unit));
    }
    if (!clock.is_counter && !clock.is_certain()) entry += ", confirmed = false";
    if (clock.has_odd_rate()) entry += ", any_rate = true";
    entry += " }";
    if (!with_comments) return entry;
    if (clock.is_counter) {
      return entry +
             comment(fmt::format("counts the samples, of which {} come in a second", *rate_Hz));
    }
    if (clock.unit_is_stated) return entry;
    if (clock.is_proven) return entry + comment("the log states no unit: " + clock.unit_by);
    return entry +
           comment(fmt::format("unit guessed: {}it makes {:.4g} samples a second",
                               clock.unit_by.empty() ? "" : clock.unit_by + "; ", clock.rate_Hz()));
  }

  /// So many seconds as one count of the column that counts the samples.
  [[nodiscard]] std::string counted_unit(const JointInLog& of) const {
    return fmt::format("{} s", present(table(of).clock).seconds_per_count);
  }

  [[nodiscard]] std::vector<std::string> columns_of(const JointInLog& of,
                                                    bool with_comments) const {
    const TableSurvey& t = table(of);
    const JointSurvey& j = joint(of);
    std::vector<std::string> lines{time_column(of, with_comments),
                                   column(of, "angle", j.angle, with_comments)};
    if (j.speed) lines.push_back(column(of, "speed", *j.speed, with_comments));
    if (t.rows_of) {
      lines.push_back(fmt::format("rows = {{ name = {}, value = {} }}",
                                  name_in_log(of, t.rows_of->first),
                                  quoted(t.rows_of->second, "the joint's name", of.log)));
    }
    const auto effort = effort_.column_of(j);
    if (effort) lines.push_back(column(of, "effort", *effort, with_comments));
    if (j.temperature &&
        present(t.columns[*j.temperature].meaning).quantity == ingest::log::Quantity::temperature) {
      lines.push_back(column(of, "temperature", *j.temperature, with_comments));
    }
    return lines;
  }

  [[nodiscard]] std::string seconds(const JointInLog& of, double value_s) const {
    const double interval_s = present(table(of).clock).interval_s;
    const double fine = std::ceil(-std::log10(interval_s / shares_of_interval));
    const auto decimals = std::clamp(static_cast<int>(fine), static_cast<int>(usual_decimals), 9);
    std::string text = fmt::format("{:.{}f}", value_s, decimals);
    while (text.ends_with('0') && !text.ends_with(".0")) text.pop_back();
    return text;
  }

  void add_recording(const ProposedRecording& recording) {
    text_ += "\n[[" + before_table_ + "recording]]\n";
    line("role = " + ingest::manifest::toml_text(joint::to_string(recording.role)),
         roles_.is_makeshift ? "a stopgap: no sweep, run, oscillation or ramp was recognised"
                             : recording.what);
    line("file = " + quoted(path_of(recording.of.log), "the log's name", recording.of.log));
    if (recording.from_s) line("from_s = " + seconds(recording.of, *recording.from_s));
    if (recording.to_s) line("to_s = " + seconds(recording.of, *recording.to_s));
    const std::vector<std::string> own = columns_of(recording.of, false);
    const std::vector<std::string> common = columns_of(first_, false);
    std::string others;
    for (const std::string& entry : own) {
      const bool is_common = std::find(common.begin(), common.end(), entry) != common.end();
      if (!is_common) others += (others.empty() ? "" : ", ") + entry;
    }
    if (!others.empty()) line("columns = { " + others + " }");
  }

  const std::vector<LogSurvey>& logs_;
  const ProposalOptions& options_;
  const JointChoice& choice_;
  const RoleProposal& roles_;
  JointInLog first_;
  EffortProposal effort_;
  std::string before_table_;  ///< Of a joint's tables in a robot's manifest.
  std::string text_;
};

ManifestProposal without_text(const std::vector<LogSurvey>& logs, const JointChoice& choice,
                              bool has_no_gravity) {
  ManifestProposal proposal;
  proposal.joint = choice.name;
  proposal.in_logs = choice.in_logs;
  proposal.moves_too = choice.moves_too;
  proposal.roles = propose_roles(logs, choice.in_logs, has_no_gravity);
  return proposal;
}

/// Never one that cannot be read.
void check_that_it_reads(const std::string& text) {
  static_cast<void>(ingest::manifest::TomlTable::parse(text, "the proposed manifest"));
}

/// The joint's own of numbers that are stated for all, or for each.
/// @param joints whose they are.
std::optional<double> own(const std::vector<double>& values, const std::vector<std::string>& joints,
                          const std::string& joint) {
  if (values.empty()) return std::nullopt;
  if (values.size() == 1) return values.front();
  const auto at = std::find(joints.begin(), joints.end(), joint) - joints.begin();
  const auto place = static_cast<std::size_t>(at);
  return place < values.size() ? std::optional(values[place]) : std::nullopt;
}

void check_count(const std::vector<double>& values, const char* option,
                 const std::vector<std::string>& names) {
  if (values.size() <= 1 || values.size() == names.size()) return;
  throw UsageError(fmt::format("{}: {} values for {} joints, {}; one for all, or one for each",
                               option, values.size(), names.size(), list_of_names(names)));
}

}  // namespace

namespace {

/// What is written with `confirmed = false`, and columns that are left out for their unit.
std::vector<std::string> only_proposed(const std::vector<LogSurvey>& logs,
                                       const ManifestProposal& proposal) {
  std::vector<std::string> unproven;
  const JointInLog& first = proposal.in_logs.front();
  const TableSurvey& table = table_of(logs, first);
  const ColumnSurvey& angle = table.columns[joint_of(logs, first).angle];
  const ingest::layout::ColumnMeaning& meaning = present(angle.meaning);
  if (!meaning.unit_is_stated && !angle.unit_is_proven) {
    unproven.push_back("the angle's unit, " + meaning.unit + " (--angle-unit)");
  }
  if (angle.side_is_open)
    unproven.emplace_back("the angle's side of the gear, joint (--angle-side)");
  const ClockSurvey& clock = present(table.clock);
  if (!clock.is_certain()) unproven.push_back("the clock's unit, " + clock.unit + " (--time-unit)");
  return unproven;
}

/// What would have to be stated for a proposal without guesses.
std::vector<std::string> open_options(const std::vector<LogSurvey>& logs,
                                      const ManifestProposal& proposal,
                                      const ProposalOptions& options) {
  std::vector<std::string> open;
  const JointInLog& first = proposal.in_logs.front();
  const TableSurvey& table = table_of(logs, first);
  const ColumnSurvey& angle = table.columns[joint_of(logs, first).angle];
  const ClockSurvey& clock = present(table.clock);
  const std::string& unit = present(angle.meaning).unit;
  if (!angle.meaning->unit_is_stated && !angle.unit_is_proven)
    open.push_back("--angle-unit " + unit);
  if (angle.side_is_open) open.emplace_back("--angle-side motor");
  if (!clock.is_certain()) open.push_back("--time-unit " + clock.unit);
  if (!options.gear_ratio) open.emplace_back("--gear-ratio RATIO");
  const auto& recordings = proposal.roles.recordings;
  const bool has_runs_alone =
      std::all_of(recordings.begin(), recordings.end(), [](const ProposedRecording& recording) {
        return recording.role == joint::Role::constant_speed;
      });
  if (has_runs_alone && !options.has_no_gravity) open.emplace_back("[--no-gravity]");
  const EffortProposal& effort = proposal.effort;
  if (effort.kind == joint::EffortKind::none || effort.is_target) return open;
  const auto column = effort.column_of(joint_of(logs, first));
  const bool is_guess = column && table.columns[*column].is_guess;
  if (is_guess && !states(options.columns, "effort")) {
    open.push_back("--column " + quoted_for_shell("effort=" + table.columns[*column].name));
  }
  if (effort.lacks_constant) open.emplace_back("--torque-constant NM_PER_A");
  if (effort.lacks_side) open.emplace_back("--effort-side SIDE");
  const bool is_current = effort.kind == joint::EffortKind::motor_current;
  if (!effort.is_confirmed && !is_current) {
    open.push_back("--effort-kind " + joint::to_string(effort.kind));
    open.emplace_back("--effort-unit Nm");
  }
  return open;
}

/// Whose angle the user names, where the others of the log are known too.
std::optional<std::string> joint_of_stated_angle(const std::vector<LogSurvey>& logs,
                                                 const StatedColumns& stated) {
  const auto name = std::find_if(stated.names.begin(), stated.names.end(),
                                 [](const auto& one) { return one.first == "angle"; });
  if (name == stated.names.end()) return std::nullopt;
  for (const LogSurvey& log : logs) {
    for (const TableSurvey& table : log.tables) {
      for (const JointSurvey& joint : table.joints) {
        const ColumnSurvey& angle = table.columns[joint.angle];
        const bool is_it = angle.file.empty() && angle.key == name->second;
        if (is_it && table.joints.size() > 1 && !joint.name.empty()) return joint.name;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

ManifestProposal propose_manifest(const std::vector<LogSurvey>& logs,
                                  const ProposalOptions& options) {
  if (auto points = propose_friction_points(logs, options)) {
    check_that_it_reads(points->text);
    return *points;
  }
  const auto joint = options.joint ? options.joint : joint_of_stated_angle(logs, options.columns);
  const JointChoice choice = choose_joint(logs, joint);
  ManifestProposal proposal = without_text(logs, choice, options.has_no_gravity);
  proposal.effort = propose_effort(logs, choice.in_logs, options);
  proposal.open = open_options(logs, proposal, options);
  proposal.only_proposed = only_proposed(logs, proposal);
  proposal.text = ManifestText(logs, options, choice, proposal.roles).text();
  check_that_it_reads(proposal.text);
  return proposal;
}

std::vector<std::string> joints_of_numbers(const std::vector<LogSurvey>& logs,
                                           const ProposalOptions& options, std::size_t numbers) {
  const std::vector<std::string> all = joints_in(logs);
  std::vector<std::string> moving;
  for (const std::string& name : all) {
    const JointChoice choice = choose_joint(logs, name);
    if (!propose_roles(logs, choice.in_logs, options.has_no_gravity).is_makeshift) {
      moving.push_back(name);
    }
  }
  if (moving.size() == numbers) return moving;
  return all.size() == numbers ? all : std::vector<std::string>();
}

RobotProposal propose_robot_manifest(const std::vector<LogSurvey>& logs,
                                     const ProposalOptions& options, const StatedJoints& known) {
  std::vector<JointChoice> moving;
  RobotProposal robot;
  for (const std::string& name : joints_in(logs)) {
    JointChoice choice = choose_joint(logs, name);
    ManifestProposal proposal = without_text(logs, choice, options.has_no_gravity);
    if (proposal.roles.is_makeshift) {
      robot.without_role.push_back(name);
      continue;
    }
    moving.push_back(std::move(choice));
    robot.joints.push_back(std::move(proposal));
  }
  if (moving.empty()) {
    throw InputError(
        {logs.front().file, 0, 0},
        {"no joint moves in a way that a stage reads", list_of_names(robot.without_role),
         "sweeps, runs at constant speed, oscillations or ramps of the torque",
         "without --all-joints a manifest for one of them is proposed all the same"});
  }
  std::vector<std::string> names;
  for (const JointChoice& choice : moving) names.push_back(choice.name);
  if (!known.joints.empty()) names = known.joints;
  check_count(known.gear_ratios, "--gear-ratio", names);
  check_count(known.torque_constants_Nm_A, "--torque-constant", names);
  for (std::size_t k = 0; k < moving.size(); ++k) {
    ProposalOptions of_joint = options;
    of_joint.gear_ratio = own(known.gear_ratios, names, moving[k].name);
    of_joint.torque_constant_Nm_A = own(known.torque_constants_Nm_A, names, moving[k].name);
    ManifestProposal& joint = robot.joints[k];
    if (k == 0) robot.text = ManifestText(logs, of_joint, moving[k], joint.roles).shared_text();
    joint.effort = propose_effort(logs, moving[k].in_logs, of_joint);
    joint.open = open_options(logs, joint, of_joint);
    joint.only_proposed = only_proposed(logs, joint);
    joint.text = ManifestText(logs, of_joint, moving[k], joint.roles).part_of_robot();
    robot.text += joint.text;
  }
  for (const std::string& name : robot.without_role) {
    robot.text += "\n# Joint " + in_quotes(name) + ": no motion that a stage reads; left out.\n";
  }
  check_that_it_reads(robot.text);
  return robot;
}

}  // namespace tribolog::inspect::survey
