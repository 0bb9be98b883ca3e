#include "cli/archiving.h"

#include <filesystem>

#include "archive/archive_location.h"
#include "archive/entry_of_calibration.h"
#include "provenance.h"

#include "cli/archive/archived_inputs.h"
#include "error.h"

namespace tribolog {

Archiving::Archiving(const ArchivingOptions& options) : options_(options) {
  if (options.location) {
    archive_.emplace(archive::open_archive(*options.location, sql::Access::write,
                                           static_cast<int>(1e3 * options.wait_s)));
  } else if (options.inputs || options.again) {
    throw UsageError("--archive-inputs and --archive-again need --archive");
  }
}

std::string Archiving::file() const {
  return archive_ && !archive::is_server(archive_->name()) ? archive_->name() : "";
}

void Archiving::keep_numbers(const std::string& calibration, const std::string& file,
                             const std::string& manifest, Console& console) {
  if (!archive_) return;
  archive::NewCalibration made = archive::entry_of_calibration(calibration, file);
  if (options_.inputs) {
    cli::add_inputs(std::filesystem::path(manifest).parent_path().string(), made);
  }
  const archive::Added added = archive_->add(made, options_.again, make_provenance({}).created_utc);
  id_ = added.id;
  cli::tell_added(added, file, console);
}

void Archiving::keep_report(const std::string& html, Console& console) {
  if (!archive_) return;
  if (!archive_->attach_report(id_, html, make_provenance({}).created_utc)) {
    console.say("the archive keeps the report it has of " + id_.substr(0, archive::shown_digits));
  }
}

}  // namespace tribolog
