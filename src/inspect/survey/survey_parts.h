#pragma once
// Parts of survey_log(), a file each.

#include <optional>
#include <string>
#include <vector>

#include "inspect/survey/log_survey.h"
#include "inspect/survey/manifest_proposal.h"

namespace tribolog::inspect::survey {

/// How the log is read.
struct HowRead {
  const std::string& path;
  ingest::log::LogFormat format;
  const ingest::text::TextLogRules& rules;
  const StatedColumns& stated;
};

/// @param names of all columns of the log, also those that are not read.
ColumnSurvey survey_column(const ingest::log::LogColumn& column,
                           const std::vector<std::string>& names);

/// Finds the table's clock, or that there is none, and surveys it: one column, the only one of its
/// kind or the first; seconds and nanoseconds, or a time of day and its date, in two; at a stated
/// rate the rows, or a column that counts the samples.
/// @param data its clock becomes what it says in sum, counted from its first reading where that is
/// from 1970 on.
void find_clock(const HowRead& how, ingest::log::LogTable& data, TableSurvey& table);

/// Where all logs hold rows of speed and torque without a clock: friction points.
std::optional<ManifestProposal> propose_friction_points(const std::vector<LogSurvey>& logs,
                                                        const ProposalOptions& options);

/// The first column of a quantity and a joint.
std::optional<std::size_t> first_column(const TableSurvey& table, ingest::log::Quantity quantity,
                                        const std::string& joint, bool is_target);

/// Units of angles, of speeds and of the clock that are not stated. What makes a speed of the
/// angle's slope proves them where one of the three is stated, or where their ratio is that of two
/// usual units; else they are guessed: degrees where radians make no sense.
void find_units(const ingest::log::LogTable& data, TableSurvey& table);

/// The files of a set in one table.
struct JoinedFiles {
  struct Place {
    std::string file;  ///< Empty: the set's first one.
    std::string key;   ///< What a manifest calls the column.
  };
  ingest::log::LogTable table;
  std::vector<Place> files;  ///< Of each column.
  std::vector<ingest::layout::ColumnMeaning> meanings;
};

/// @param beside of the set's other files, in their order.
/// @return nothing where they do not belong together.
std::optional<JoinedFiles> join_files(const FileSet& set, ingest::log::LogTable angles,
                                      std::vector<ingest::log::LogTable> beside,
                                      const StatedColumns& stated);

/// One joint's rows of a log in which each row is one joint's; or one recording's of several.
struct RowsOfOne {
  ingest::log::LogTable table;  ///< Without the column that tells them.
  std::string key;              ///< What a manifest calls that.
  std::string value;            ///< What stands in it.
  bool is_recording{};          ///< Else a joint.
};

/// Joints by a column named so that holds a few words or numbers by turns, or one behind the other;
/// recordings by "episode_index" and the like, where the clock begins anew with each.
/// @return none for a log that is one recording in which a row is all joints'.
std::vector<RowsOfOne> rows_of_each(const std::string& path, ingest::log::LogFormat format,
                                    const ingest::text::TextLogRules& rules,
                                    const ingest::log::LogTable& table);

/// A stretch of a log to which it gives a name.
struct Phase {
  std::string name;
  double from_s{};
  double to_s{};
};

/// By a column of words named so, in a table with a clock.
/// @return in the order of time; none where it has none, or they are too many or too short to be
/// experiments, or they are parts of one motion.
std::vector<Phase> phases_in(const ingest::log::LogTable& data, const TableSurvey& table);

}  // namespace tribolog::inspect::survey
