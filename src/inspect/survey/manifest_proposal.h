#pragma once
// A manifest for logs, as far as they tell by themselves: what `tribolog init` writes.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "inspect/survey/log_survey.h"
#include "joint/dataset.h"
#include "joint/drive.h"
#include "joint/recording.h"

namespace tribolog::inspect::survey {

// Which segment of which log plays which role in an identification (joint/recording.h).

/// A joint in one log.
struct JointInLog {
  std::size_t log{};
  std::size_t table{};
  std::size_t joint{};
};

inline const TableSurvey& table_of(const std::vector<LogSurvey>& logs, const JointInLog& of) {
  return logs[of.log].tables[of.table];
}
inline const JointSurvey& joint_of(const std::vector<LogSurvey>& logs, const JointInLog& of) {
  return table_of(logs, of).joints[of.joint];
}

struct ProposedRecording {
  JointInLog of;
  joint::Role role{};
  std::optional<double> from_s;  ///< Absent: from the log's start.
  std::optional<double> to_s;
  std::string what;  ///< "sine of 0.1 Hz, 5.9 cycles, -189° to -70°".
};

struct RoleProposal {
  std::vector<ProposedRecording> recordings;  ///< In the order of logs and of time.
  std::vector<JointInLog> without_role;       ///< Recordings in which nothing was found to use.
  /// Nothing in any log is a motion that a stage reads: each log is named whole, as a sweep.
  bool is_makeshift{};
};

/// Strokes of constant speed are a rough sweep where they are slow (a stroke of 3 s or longer, up
/// to 0.5 rad/s), as wide as those of any other speed and wider than the slow ones, and a precise
/// one where they are the slowest by far, and narrow, beside a sweep. All others are runs at
/// constant speed.
/// @param has_no_gravity strokes of any course over the same way in both directions then do as a
/// sweep where a log holds nothing else.
RoleProposal propose_roles(const std::vector<LogSurvey>& logs, const std::vector<JointInLog>& joint,
                           bool has_no_gravity = false);

/// "constant speed 10 deg/s, 2 strokes, -30° to 30°", for people.
std::string describe(const motion::MotionSegment& segment);

// The manifest.

/// What the user knows beside the logs.
struct ProposalOptions {
  std::optional<std::string> joint;  ///< Absent: the one that moves most.
  std::optional<double> gear_ratio;
  /// With it an effort of which the log does not say what it is counts as a motor current.
  std::optional<double> torque_constant_Nm_A;
  std::optional<joint::EffortKind> effort_kind;  ///< What is stated so is confirmed.
  std::optional<joint::Side> effort_side;
  std::optional<std::string> robot;
  std::optional<std::string> serial;
  std::optional<std::string> operator_name;
  std::optional<std::string> measured_on;  ///< RFC 3339, a day alone or with a time.
  std::optional<double> temperature_C;     ///< Of the joint, while it was measured.
  std::optional<double> payload_kg;
  /// Gravity's torque at the joint by its design, and the angle where it is largest.
  std::optional<std::pair<double, double>> known_gravity_Nm_deg;
  /// A current whose torque constant is not stated is taken as it is: torques are then numbers of
  /// amperes, and the manifest says so.
  bool takes_amperes{};
  bool registers_are_confirmed{};        ///< Those that are found without their sign.
  bool has_no_gravity{};                 ///< Stated: a vertical axis, or a bare motor.
  ingest::text::TextLogRules log_rules;  ///< The logs were read with them, and with
  StatedColumns columns;                 ///< these.
  std::string directory;                 ///< Of the manifest: files are named relative to it.
};

// What the effort of a joint is proposed to be, and how sure that is.

struct EffortProposal {
  joint::EffortKind kind{joint::EffortKind::none};
  std::vector<std::string> remarks;  ///< For comments, one line each.
  std::vector<std::string> lines;    ///< Of [effort], each a key with its value and a comment.
  std::string unit;                  ///< Of the column, where it is not the survey's; else empty.
  /// Columns that may be the effort but were not understood, and what to state: a sentence each.
  std::vector<std::string> not_understood;
  bool is_confirmed{};    ///< Kind and unit are stated.
  bool lacks_constant{};  ///< A current without its torque constant.
  bool lacks_side{};      ///< A current: nobody stated on which side its constant acts.
  bool is_target{};       ///< No measured effort is there: a controller's value stands in.

  /// The column in a joint's own log; nothing where it has none of this kind.
  [[nodiscard]] std::optional<std::size_t> column_of(const JointSurvey& joint) const;
};

struct ManifestProposal {
  std::string joint;                   ///< As in the logs; empty: they tell none.
  std::vector<JointInLog> in_logs;     ///< Where it is.
  std::vector<std::string> moves_too;  ///< Other joints that move beside it.
  RoleProposal roles;
  EffortProposal effort;
  /// What no log shows and nobody stated: options that would, with their values as guessed.
  std::vector<std::string> open{};
  /// What no log shows and nothing proves, in words: "the angle's unit, rad".
  std::vector<std::string> only_proposed{};
  std::string text;  ///< TOML that read_manifest() takes, but for a torque
                     ///< constant nobody stated, which is missing.
};

/// @param logs those refused take no part.
/// @throw InputError if no log has a clock and an angle; UsageError for a joint that no log has.
ManifestProposal propose_manifest(const std::vector<LogSurvey>& logs,
                                  const ProposalOptions& options);

/// A manifest of a whole robot.
struct RobotProposal {
  std::vector<ManifestProposal>
      joints;  ///< In the order of the logs, `text` being the joint's part.
  std::vector<std::string> without_role;  ///< Joints that move in no way that a stage reads.
  std::string text;
};

/// What is known of each joint; one value is that of all.
struct StatedJoints {
  std::vector<double> gear_ratios;
  std::vector<double> torque_constants_Nm_A;
  /// Whose they are; empty: of those that move, in the order of the logs.
  std::vector<std::string> joints{};
};

/// Whose numbers they are where so many are stated: of the joints that move or, if these are not as
/// many, of all; in the order of the logs. Empty: they are neither.
std::vector<std::string> joints_of_numbers(const std::vector<LogSurvey>& logs,
                                           const ProposalOptions& options, std::size_t numbers);

/// All joints that the logs name, but those that do not move.
/// @param options what is known of the robot and of all joints alike; its joint is ignored.
/// @throw as propose_manifest(); UsageError where the numbers of a joint are not as many as joints.
RobotProposal propose_robot_manifest(const std::vector<LogSurvey>& logs,
                                     const ProposalOptions& options, const StatedJoints& known);

// Which joint a manifest is for, and what its effort is.

struct JointChoice {
  std::string name;
  /// One of each recording that has it, and in it the widest.
  std::vector<JointInLog> in_logs;
  std::vector<std::string> moves_too;  ///< Others that move a hundredth as far or further.
};

/// Names of all joints that have a clock, in the order of the logs; one without a name is "".
/// @throw InputError if no log has a clock and an angle.
std::vector<std::string> joints_in(const std::vector<LogSurvey>& logs);

/// The joint of that name, or else the one with the widest motion. Logs whose only joint has no
/// name take part in either case.
/// @throw InputError if no log has a clock and an angle; UsageError if none has that joint.
JointChoice choose_joint(const std::vector<LogSurvey>& logs,
                         const std::optional<std::string>& name);

/// A current is one of the motor. A torque is taken as the known logger has it, as the motor's
/// where its name says so, else as the joint's. What no logger states is not confirmed. The first
/// log of the joint that has an effort decides.
EffortProposal propose_effort(const std::vector<LogSurvey>& logs,
                              const std::vector<JointInLog>& joint, const ProposalOptions& options);

/// "left out: column 'v [qc/s]', an angular speed in a unit that is not known ('qc/s'); ..."
std::string foreign_unit_in_words(const TableSurvey& table,
                                  const ingest::layout::ForeignUnit& foreign);

/// Columns that may be an effort: those known to be one in an unknown unit, else those that nothing
/// is known of. A sentence each, with what to state.
std::vector<std::string> not_understood(const TableSurvey& table);

/// Puts what an effort is taken for in the place of what its name says.
void tell_effort(const ManifestProposal& proposal, std::vector<LogSurvey>& logs);

/// Columns that look like voltages or duty cycles, from which no torque follows.
std::vector<std::string> voltages_of(const TableSurvey& table);

}  // namespace tribolog::inspect::survey
