#include "cli/archived_inputs.h"

#include <filesystem>

#include <fmt/format.h>

#include "base/early_end.h"
#include "base/error.h"
#include "base/file_contents.h"
#include "base/sha256.h"

namespace tribolog::cli {

void add_inputs(const std::string& directory, archive::NewCalibration& calibration) {
  for (const archive::Input& input : calibration.inputs) {
    const std::string path = (std::filesystem::path(directory) / input.name).string();
    std::string bytes = read_file(path);
    if (sha256_hex(bytes) != input.sha256) {
      throw InputError({path, 0, 0}, {"is not the file that the calibration was made from",
                                      "another SHA-256", input.sha256, "identify it again"});
    }
    calibration.documents.push_back({archive::DocumentKind::input, input.name, std::move(bytes)});
  }
}

void tell_added(const archive::Added& added, const std::string& what, Console& console) {
  const std::string id = added.id.substr(0, archive::shown_digits);
  const std::string file = printable(what, longest_path);
  if (added.is_new) {
    note_kept("its entry " + id);
    console.say(fmt::format("archived: {} ({})", id, file));
  } else {
    console.say(fmt::format(
        "already archived: {} ({}), identified by tribolog {}; --again keeps this one beside it",
        id, file, printable(added.tool_version)));
  }
}

}  // namespace tribolog::cli
