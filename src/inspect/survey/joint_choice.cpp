#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "base/requirements.h"
#include "ingest/layout/log_layout.h"
#include "inspect/survey/manifest_proposal.h"
#include "wording/words.h"

namespace tribolog::inspect::survey {

namespace {

constexpr double moves_share = 0.01;
constexpr double as_wide = 0.98;  // of the widest range: two joints that move as one

struct Found {
  JointInLog in_log;
  const JointSurvey* joint;
  bool is_only;  ///< Of its log.
};

std::vector<Found> all_joints(const std::vector<LogSurvey>& logs) {
  std::vector<Found> found;
  for (std::size_t l = 0; l < logs.size(); ++l) {
    const std::size_t before = found.size();
    for (std::size_t t = 0; t < logs[l].tables.size(); ++t) {
      const TableSurvey& table = logs[l].tables[t];
      if (!table.clock) continue;
      for (std::size_t j = 0; j < table.joints.size(); ++j) {
        found.push_back({{l, t, j}, &table.joints[j], false});
      }
    }
    for (std::size_t k = before; k < found.size(); ++k) {
      const TableSurvey& table = logs[l].tables[found[k].in_log.table];
      found[k].is_only =
          found.size() == before + 1 || (table.is_one_of_several && table.joints.size() == 1);
    }
  }
  return found;
}

/// What the columns of a log are not known as.
[[noreturn]] void refuse_without_angle(const std::vector<LogSurvey>& logs) {
  const auto read = std::find_if(logs.begin(), logs.end(),
                                 [](const LogSurvey& log) { return log.refusal.empty(); });
  const std::string file = read == logs.end() ? "" : read->file;
  std::vector<std::string> columns;
  std::string counter;
  bool has_clock = false;
  bool has_angle = false;
  for (const LogSurvey& log : logs) {
    if (log.file != file) continue;
    for (const TableSurvey& table : log.tables) {
      has_clock = has_clock || table.clock;
      has_angle = has_angle || !table.joints.empty();
      if (counter.empty()) counter = table.counter;
      for (const ColumnSurvey& column : table.columns) columns.push_back(column.name);
    }
  }
  std::string commas;
  for (const LogSurvey& log : logs) {
    for (const Statement& note : log.notes) {
      if (note.is("reading.commas_in_numbers")) commas += "; " + wording::words(note);
    }
  }
  const std::string rate = "--rate HZ, of rows without a clock";
  throw InputError(
      {file, 0, 0},
      {std::string("no column is known as ") + (has_clock ? "" : "time") +
           (has_clock || has_angle ? "" : " and none as ") + (has_angle ? "" : "angle of a joint"),
       list_of_names(columns), "a clock and an angle, as \"t_s\" and \"q_rad\"",
       (has_clock          ? "--column angle=NAME states it, in a manifest [columns] angle"
        : !counter.empty() ? in_quotes(counter) + " counts rows or milliseconds: state " + rate +
                                 ", or --column time=NAME"
                           : "--column time=NAME states it, or " + rate +
                                 (has_angle ? "" : "; --column angle=NAME the angle")) +
           commas});
}

/// In the effort's own unit; 0 where none was logged.
double effort_range(const std::vector<LogSurvey>& logs, const Found& of) {
  if (!of.joint->effort) return 0;
  const ColumnSurvey& effort = table_of(logs, of.in_log).columns[*of.joint->effort];
  return effort.highest - effort.lowest;
}

/// Of the same log.
bool is_another_recording(const std::vector<LogSurvey>& logs, const JointInLog& a,
                          const JointInLog& b) {
  return a.table != b.table && table_of(logs, a).is_one_of_several &&
         table_of(logs, b).is_one_of_several;
}

std::vector<std::string> names_of(const std::vector<Found>& found) {
  std::vector<std::string> names;
  for (const Found& f : found) {
    if (std::find(names.begin(), names.end(), f.joint->name) == names.end()) {
      names.push_back(f.joint->name);
    }
  }
  return names;
}

}  // namespace

std::vector<std::string> joints_in(const std::vector<LogSurvey>& logs) {
  const std::vector<Found> found = all_joints(logs);
  if (found.empty()) refuse_without_angle(logs);
  return names_of(found);
}

JointChoice choose_joint(const std::vector<LogSurvey>& logs,
                         const std::optional<std::string>& name) {
  const std::vector<Found> found = all_joints(logs);
  if (found.empty()) refuse_without_angle(logs);
  JointChoice choice;
  const auto range = [](const Found& f) { return f.joint->range_rad(); };
  if (name) {
    const std::vector<std::string> names = names_of(found);
    if (std::find(names.begin(), names.end(), *name) == names.end()) {
      if (names.size() == 1 && names.front().empty()) {
        throw UsageError("the logs name no joint: leave --joint " + printable(*name) + " out");
      }
      throw UsageError("no log has a joint " + in_quotes(*name) + ", only " + list_of_names(names));
    }
    choice.name = *name;
  } else {
    const auto widest =
        std::max_element(found.begin(), found.end(),
                         [&](const Found& a, const Found& b) { return range(a) < range(b); });
    // Of two that are coupled the one that drives.
    const double least = as_wide * range(*widest);
    const auto driven =
        std::max_element(found.begin(), found.end(), [&](const Found& a, const Found& b) {
          return (range(a) < least ? -1 : effort_range(logs, a)) <
                 (range(b) < least ? -1 : effort_range(logs, b));
        });
    choice.name = driven->joint->name;
  }
  double widest = 0;
  for (const Found& f : found) {
    const bool is_it = f.joint->name == choice.name || (f.is_only && f.joint->name.empty());
    if (!is_it) continue;
    widest = std::max(widest, range(f));
    const bool is_next = choice.in_logs.empty() || choice.in_logs.back().log != f.in_log.log ||
                         is_another_recording(logs, choice.in_logs.back(), f.in_log);
    if (is_next) {
      choice.in_logs.push_back(f.in_log);
      continue;
    }
    const JointInLog& known = choice.in_logs.back();
    if (range(f) > logs[known.log].tables[known.table].joints[known.joint].range_rad()) {
      choice.in_logs.back() = f.in_log;
    }
  }
  for (const Found& f : found) {
    const bool is_known = f.joint->name == choice.name || f.joint->name.empty() ||
                          std::find(choice.moves_too.begin(), choice.moves_too.end(),
                                    f.joint->name) != choice.moves_too.end();
    if (!is_known && range(f) > moves_share * widest) choice.moves_too.push_back(f.joint->name);
  }
  return choice;
}

namespace {

constexpr std::array torque_words = {"torque", "torques", "tau",        "moment", "trq",
                                     "jts",    "couple",  "drehmoment", "mt"};
constexpr std::array voltage_words = {"v", "volt", "volts", "voltage", "pwm", "duty"};

bool says_motor(const std::string& name) {
  const std::vector<std::string> words = ingest::layout::words_of_name(name);
  return std::find(words.begin(), words.end(), "motor") != words.end() ||
         std::find(words.begin(), words.end(), "drive") != words.end();
}

/// "tau", "joint_torque": whatever else is stated, it is no current by its name. An "effort" may
/// be.
bool is_called_torque(const ColumnSurvey& column) {
  const std::vector<std::string> words = ingest::layout::words_of_name(column.name);
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return std::find(torque_words.begin(), torque_words.end(), word) != torque_words.end();
  });
}

/// What the effort is: as the user states, else as a known logger writes it, else by its name; an
/// effort of unknown kind with a torque constant is a current.
/// @throw UsageError where what is stated contradicts the log.
joint::EffortKind kind_of(const ColumnSurvey& column, bool is_target,
                          const ProposalOptions& options) {
  const ingest::layout::ColumnMeaning& meaning = present(column.meaning);
  const bool is_current = meaning.quantity == ingest::log::Quantity::current;
  const bool says_torque = !is_current && meaning.unit_is_stated && !meaning.effort.may_be_current;
  if (options.effort_kind) {
    const bool as_current = *options.effort_kind == joint::EffortKind::motor_current;
    if (as_current ? says_torque : is_current) {
      throw UsageError(fmt::format("--effort-kind {}: the log's column {} is in {}",
                                   joint::to_string(*options.effort_kind), in_quotes(column.name),
                                   printable(meaning.unit)));
    }
    return *options.effort_kind;
  }
  if (is_target) return joint::EffortKind::target_torque;
  if (is_current) return joint::EffortKind::motor_current;
  if (meaning.effort.kind) return *meaning.effort.kind;
  if (options.torque_constant_Nm_A && !says_torque && !is_called_torque(column)) {
    return joint::EffortKind::motor_current;
  }
  return says_motor(column.name) ? joint::EffortKind::motor_torque
                                 : joint::EffortKind::joint_torque;
}

void propose_none(const TableSurvey& table, EffortProposal& proposal) {
  const std::vector<std::string> voltages = voltages_of(table);
  proposal.remarks.push_back(
      "The log holds no torque and no motor current that its names tell: the motion alone is "
      "checked.");
  if (!voltages.empty()) {
    proposal.remarks.push_back("No torque follows from a voltage or a duty cycle (" +
                               list_of_names(voltages, 6) + ").");
  }
  proposal.not_understood = not_understood(table);
  for (const std::string& column : proposal.not_understood) proposal.remarks.push_back(column);
  proposal.remarks.push_back(
      "Record the motor current or the torque at every sample, and state it here and in "
      "[columns].");
  proposal.lines.emplace_back("kind = \"none\"");
}

}  // namespace

std::optional<std::size_t> EffortProposal::column_of(const JointSurvey& joint) const {
  if (kind == joint::EffortKind::none) return std::nullopt;
  if (!is_target) return joint.effort;
  return joint.targets.empty() ? std::nullopt : std::optional(joint.targets.front());
}

void tell_effort(const ManifestProposal& proposal, std::vector<LogSurvey>& logs) {
  if (proposal.effort.unit.empty()) return;
  for (const JointInLog& of : proposal.in_logs) {
    TableSurvey& table = logs[of.log].tables[of.table];
    const auto column = proposal.effort.column_of(table.joints[of.joint]);
    if (!column) continue;
    ingest::layout::ColumnMeaning& meaning = present(table.columns[*column].meaning);
    meaning.quantity = ingest::log::Quantity::current;
    meaning.unit = proposal.effort.unit;
    meaning.unit_is_stated = false;
  }
}

std::vector<std::string> voltages_of(const TableSurvey& table) {
  std::vector<std::string> names;
  for (const ColumnSurvey& column : table.columns) {
    const std::vector<std::string> words = ingest::layout::words_of_name(column.name);
    const bool is_one =
        column.unit == "V" || std::any_of(words.begin(), words.end(), [](const std::string& word) {
          return std::find(voltage_words.begin(), voltage_words.end(), word) != voltage_words.end();
        });
    if (is_one && !column.meaning) names.push_back(column.name);
  }
  return names;
}

std::string foreign_unit_in_words(const TableSurvey& table,
                                  const ingest::layout::ForeignUnit& foreign) {
  const ColumnSurvey& column = table.columns[foreign.column];
  const bool is_effort = foreign.quantity == ingest::log::Quantity::torque ||
                         foreign.quantity == ingest::log::Quantity::current;
  const std::string option = is_effort ? "effort" : ingest::log::quantity_word(foreign.quantity);
  return fmt::format(
      "left out: column {}, {} in a unit that is not known; --{}-unit states it, '{}' "
      "say",
      in_quotes(column.name), ingest::log::to_string(foreign.quantity), option,
      ingest::log::example_of_multiple(foreign.quantity));
}

std::vector<std::string> not_understood(const TableSurvey& table) {
  std::vector<std::string> remarks;
  for (const ingest::layout::ForeignUnit& foreign : table.foreign) {
    if (foreign.quantity != ingest::log::Quantity::torque &&
        foreign.quantity != ingest::log::Quantity::current) {
      continue;
    }
    const ColumnSurvey& column = table.columns[foreign.column];
    remarks.push_back(fmt::format(
        "column {} looks like {} in a unit that is not known: --effort-unit states what one of it "
        "is, '{}' say",
        in_quotes(column.name), ingest::log::to_string(foreign.quantity),
        ingest::log::example_of_multiple(foreign.quantity)));
  }
  if (!remarks.empty()) return remarks;
  std::vector<std::string> unknown;
  const std::vector<std::string> voltages = voltages_of(table);
  for (const ColumnSurvey& column : table.columns) {
    constexpr std::size_t of_a_flag = 2;
    const bool may_be = !column.meaning && column.words.empty() && column.distinct > of_a_flag &&
                        !std::isnan(column.lowest) &&
                        std::find(voltages.begin(), voltages.end(), column.name) == voltages.end();
    if (may_be) unknown.push_back(column.name);
  }
  if (unknown.empty()) return remarks;
  remarks.push_back(
      "columns that were not understood: " + list_of_names(unknown, 8) +
      "; if one is the torque or the current: --column effort=NAME --effort-unit UNIT");
  return remarks;
}

EffortProposal propose_effort(const std::vector<LogSurvey>& logs,
                              const std::vector<JointInLog>& joint,
                              const ProposalOptions& options) {
  EffortProposal proposal;
  const TableSurvey* table = &logs[joint.front().log].tables[joint.front().table];
  const ColumnSurvey* column = nullptr;
  const ColumnSurvey* angle = nullptr;
  for (const bool is_target : {false, true}) {
    for (const JointInLog& of : joint) {
      const TableSurvey& in = logs[of.log].tables[of.table];
      const JointSurvey& j = in.joints[of.joint];
      if (column != nullptr || (is_target ? j.targets.empty() : !j.effort)) continue;
      const ColumnSurvey& found = in.columns[is_target ? j.targets.front() : present(j.effort)];
      if (is_target && present(found.meaning).quantity != ingest::log::Quantity::torque) continue;
      table = &in;
      column = &found;
      angle = &in.columns[j.angle];
      proposal.is_target = is_target;
    }
  }
  if (column == nullptr) {
    propose_none(*table, proposal);
    return proposal;
  }
  const ingest::layout::ColumnMeaning& meaning = present(column->meaning);
  proposal.kind = kind_of(*column, proposal.is_target, options);
  const bool is_current = proposal.kind == joint::EffortKind::motor_current;
  const bool is_taken_as_current = is_current && meaning.quantity != ingest::log::Quantity::current;
  if (is_taken_as_current) proposal.unit = "A";
  // Makers state the constant of the motor as well as that behind the gear.
  const bool lacks_gear = is_current && options.torque_constant_Nm_A && !options.gear_ratio;
  proposal.lacks_side = is_current && !options.effort_side && options.gear_ratio.value_or(0) != 1;
  const bool side_is_guess = proposal.lacks_side && options.torque_constant_Nm_A;
  const joint::Side likely = proposal.kind == joint::EffortKind::motor_torque ||
                                     (is_current && (options.gear_ratio || lacks_gear))
                                 ? joint::Side::motor
                                 : joint::Side::joint;
  const joint::Side side =
      options.effort_side.value_or(is_current ? likely : meaning.effort.side.value_or(likely));

  const bool is_stated_column = states(options.columns, "effort");
  proposal.remarks.push_back(
      fmt::format("{} in {}{}", in_quotes(column->name),
                  is_taken_as_current ? proposal.unit : printable(meaning.unit),
                  is_stated_column        ? ": the column that was stated"
                  : column->is_guess      ? ": guessed " + column->guessed_by
                  : table->logger.empty() ? ": taken by its name"
                                          : ": as " + table->logger + " writes it"));
  if (!meaning.effort.remark.empty()) proposal.remarks.push_back(meaning.effort.remark);
  if (proposal.is_target) {
    proposal.remarks.emplace_back(
        "There is no measured effort: friction found in a set point is the controller's own.");
  }
  if (options.torque_constant_Nm_A && !is_current) {
    proposal.remarks.push_back(
        fmt::format("It is called a torque: the torque constant of {} N·m/A is not used. "
                    "--effort-kind motor_current states that it is a current.",
                    *options.torque_constant_Nm_A));
    proposal.not_understood.push_back(proposal.remarks.back());
  }
  if (is_taken_as_current && !options.effort_kind) {
    proposal.remarks.emplace_back(
        "The log does not say what it is: with a torque constant it is the motor's current.");
  }
  if (!is_current && !proposal.is_target && !meaning.effort.kind && !options.effort_kind) {
    proposal.remarks.emplace_back(
        "Is it measured? Before the gear (motor_torque, side motor) or behind it (joint_torque, "
        "side joint)?");
  }
  proposal.lines.push_back(fmt::format("kind = \"{}\"", joint::to_string(proposal.kind)));
  if (meaning.effort.is_without_gravity && !is_current) {
    proposal.lines.emplace_back("gravity_removed = true  # by the controller");
  }
  proposal.lines.push_back(fmt::format(
      "side = \"{}\"{}", side == joint::Side::motor ? "motor" : "joint",
      is_current && !options.effort_side ? "  # on which the torque constant below acts" : ""));
  if (proposal.kind == joint::EffortKind::motor_current) {
    proposal.lines.push_back(
        options.torque_constant_Nm_A
            ? fmt::format("torque_constant_Nm_A = {}", *options.torque_constant_Nm_A)
        : options.takes_amperes
            ? "torque_constant_Nm_A = \"unknown\"  # not in the log: torques are numbers of amperes"
            : "# torque_constant_Nm_A =  # not in the log, and needed: N·m per ampere on that "
              "side");
    proposal.lacks_constant = !options.torque_constant_Nm_A;
  }
  // A stated kind says nothing of the unit.
  const bool is_stated = (options.effort_kind && meaning.unit_is_stated) || is_taken_as_current ||
                         (is_current && meaning.unit_is_stated);
  const bool is_one_of_several = (column->is_one_of_several() && !is_stated_column) ||
                                 (angle->is_one_of_several() && !states(options.columns, "angle"));
  // What a register holds is a guess until the user has looked at it.
  const bool is_of_register = column->of_register.has_value() && !options.registers_are_confirmed;
  if (is_of_register) {
    proposal.remarks.push_back(
        fmt::format("{} is read as a register without its sign ({}): --signed-registers confirms "
                    "it.",
                    in_quotes(column->name), ingest::log::to_string(*column->of_register)));
    proposal.not_understood.push_back(proposal.remarks.back());
  }
  const bool is_guess = column->is_guess && !is_stated_column;
  proposal.is_confirmed = !side_is_guess && is_stated && !is_one_of_several && !is_guess;
  if (lacks_gear && !options.effort_side) {
    proposal.lines.emplace_back(
        "confirmed = false  # the gear ratio is not known, and with it no torque of the joint; "
        "true, or no such line, once it is stated");
  } else if (options.effort_kind && !is_stated) {
    proposal.lines.emplace_back(
        "confirmed = false  # the unit in [columns] is a guess; true, or no such line, once it is "
        "looked at");
  } else if (side_is_guess) {
    proposal.lines.emplace_back(
        "confirmed = false  # the side is a guess: the torque constant may be that of the motor or "
        "that behind the gear; true, or no such line, once it is looked at");
  } else if (!is_stated || is_one_of_several || is_of_register || is_guess) {
    proposal.lines.emplace_back(
        "confirmed = false  # a guess; true, or no such line, once it is "
        "looked at");
  }
  return proposal;
}

}  // namespace tribolog::inspect::survey
