#pragma once
// Files given to a command that reads others: recognised by their content, and the command that
// reads them is named.

#include <string>
#include <vector>

#include "inspect/files/file_kind.h"
#include "report/engine/embedded_json.h"

namespace CLI {
class App;
}

namespace tribolog::cli {

/// "a report"; empty of what is not recognised, and of pages of other programs.
std::string name_of(inspect::files::FileKind kind);

/// The command that reads such a file: "tribolog show r.html"; empty: none does.
std::string command_for(inspect::files::FileKind kind, const std::string& file);

/// A file of a known kind that is not wanted here is refused with what it is and the
/// command that reads it. What is missing, empty, a directory or not recognised is left to who
/// reads it.
/// @param wanted for the message: "a scenario (TOML)".
/// @throw InputError
void refuse_other_kind(const std::string& file, const std::vector<inspect::files::FileKind>& kinds,
                       const std::string& wanted);

/// refuse_other_kind() for every file that the command line names.
/// @param command the one that was chosen, parsed as far as it could be.
/// @throw InputError
void check_given_files(const CLI::App& command);

/// The element of a page that carries a calibration.
inline constexpr const char* calibration_element = "tribolog-result";

/// The numbers that a page carries, or the calibration that the file is.
/// @throw InputError: neither of both.
report::engine::EmbeddedJson numbers_in(const std::string& file);

/// The calibration (JSON) that a report carries, or that the file is.
/// @throw UsageError: a page without one. InputError as numbers_in().
std::string calibration_in(const std::string& file);

}  // namespace tribolog::cli
