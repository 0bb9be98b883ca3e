#pragma once
// How a result was made: program, libraries, command and time.

#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"

namespace tribolog::calibration {

/// A name and what belongs to it: a library and its version.
struct NamedText {
  std::string name;
  std::string text;
};

/// An option and its chosen value.
struct Setting {
  Statement name;
  Statement text;
};

/// The graphics stack; known only where figures were drawn.
struct DrawingSoftware {
  std::string vtk_version;
  std::string back_end;
  std::string gl_version;
  std::string gl_renderer;
  std::string font;
  std::string freetype_version;
};

struct Provenance {
  std::string tool_version;
  std::string git_revision;  ///< "unknown" if the program was not built from a checkout.
  std::string compiler;
  std::string eigen_version;  ///< "unknown" if not recorded at build time.
  std::optional<DrawingSoftware> drawing;
  std::string created_utc;   ///< "2026-01-31T12:00:00Z"
  std::string command_line;  ///< As given, directories of absolute paths removed.
  std::vector<Setting> configuration;
};

/// Everything but drawing and configuration.
/// @param arguments of the command line, the program's name first; may be empty.
/// @throw UsageError if SOURCE_DATE_EPOCH is set to anything but whole seconds from 0 to the end
///        of the year 9999.
Provenance make_provenance(const std::vector<std::string>& arguments);

/// `source_date_epoch` as UTC text, or the clock's time if nullptr or empty.
/// @throw UsageError as above.
std::string creation_time_utc(const char* source_date_epoch);

/// The arguments as one line for a shell. An absolute path (from `/` or `~`), alone or behind an
/// option's `=`, is cut to its last part, so that results do not reveal anything about the machine;
/// a PostgreSQL connection string, which may hold a password, is removed altogether.
std::string command_line_text(const std::vector<std::string>& arguments);

}  // namespace tribolog::calibration
