#pragma once
// What a file is, by its content: its name's ending is no proof.

#include <string>

namespace tribolog::inspect::files {

enum class FileKind {
  missing,       ///< No such file, or one that cannot be read.
  folder,        ///< A directory.
  empty,         ///< A file of no bytes.
  unknown,       ///< None of those below.
  manifest,      ///< Of a joint or of a robot (TOML): what identify and report read.
  scenario,      ///< What simulate, study and paper read (TOML).
  joint,         ///< What plan reads, of a joint or of a robot's joints (TOML).
  arm,           ///< A description of a robot's arm, TOML or URDF.
  report,        ///< The page of one joint (HTML), with its calibration in it.
  robot_page,    ///< The page of a whole robot (HTML).
  other_page,    ///< Another page of this program (HTML): a comparison, a study, ...
  bare_page,     ///< A page of this program without numbers to be read again (HTML).
  foreign_page,  ///< A page of another program (HTML).
  calibration,   ///< The numbers of one joint (JSON).
  plan,          ///< The numbers of a plan (JSON).
  truth,         ///< The true values of a simulation (JSON).
  other_json,    ///< Other numbers of this program (JSON).
  archive,       ///< Of calibrations (SQLite).
  log,           ///< A recording in a format of logs, or text with columns of numbers.
};

/// Reads as much of the file as it takes: its first bytes, of JSON also the last ones, and all of a
/// page.
FileKind kind_of_file(const std::string& path);

}  // namespace tribolog::inspect::files
