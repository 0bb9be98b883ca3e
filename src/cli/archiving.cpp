#include "cli/archiving.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "archive/store/archive_location.h"
#include "base/early_end.h"
#include "base/encodings.h"
#include "base/error.h"
#include "base/input_file.h"
#include "calibration/provenance.h"
#include "calibration/read_calibration.h"
#include "inspect/survey/manifest_proposal.h"
#include "tribolog/failure.h"

namespace tribolog::cli {

void add_inputs(const std::string& directory, calibration::NewCalibration& calibration) {
  for (const calibration::Input& input : calibration.inputs) {
    const std::string path = (std::filesystem::path(directory) / input.name).string();
    std::string bytes = read_file(path);
    if (sha256_hex(bytes) != input.sha256) {
      throw InputError({path, 0, 0}, {"is not the file that the calibration was made from",
                                      "another SHA-256", input.sha256, "identify it again"});
    }
    calibration.documents.push_back(
        {calibration::DocumentKind::input, input.name, std::move(bytes)});
  }
}

void tell_added(const archive::store::Added& added, const std::string& what, Console& console) {
  const std::string id = added.id.substr(0, calibration::shown_digits);
  const std::string file = printable(what, longest_path);
  if (added.is_new) {
    note_kept("its entry " + id);
    console.say(fmt::format("archived: {} ({})", id, file));
  } else {
    console.say(fmt::format(
        "already archived: {} ({}), identified by tribolog {}; --again (of identify and report: "
        "--archive-again) keeps this one as well",
        id, file, printable(added.tool_version)));
  }
}

void DoubtfulIdentities::add(const calibration::Facts& facts, const std::string& now_utc) {
  ++all_;
  const bool has_name = facts.of.robot != joint::unnamed_robot;
  unnamed_ += has_name ? 0 : 1;
  without_serial_ += has_name && facts.of.serial.empty() ? 1 : 0;
  ahead_ += facts.time_is_stated && facts.measured_at > now_utc ? 1 : 0;
}

void DoubtfulIdentities::tell(Console& console) const {
  const auto tell = [&](std::size_t count, const char* what) {
    if (count == 0) return;
    const std::string of = all_ == 1 ? "" : fmt::format("{} of {} ", count, all_);
    console.warn(fmt::format("note: {}{}", of, what));
  };
  tell(unnamed_,
       "archived without the robot's name: all such robots are one in trend and fleet; state name "
       "under [robot]");
  tell(without_serial_,
       "archived without a serial number: robots of one name are one in trend and fleet; state "
       "serial under [robot]");
  tell(ahead_, "archived with a date of measurement that lies in the future");
}

std::string ArchivingOptions::file() const {
  if (!location || archive::store::is_server(*location)) return "";
  return location->empty() ? archive::store::default_location() : *location;
}

Archiving::Archiving(const ArchivingOptions& options) : options_(options) {
  if (options.location) {
    // A new one is made when it has something to keep.
    if (archive::store::is_there(*options.location)) {
      open();
    } else {
      archive::store::check_can_be_made(*options.location);
    }
  } else if (options.inputs || options.again) {
    throw UsageError("--archive-inputs and --archive-again need --archive");
  }
}

void Archiving::open() {
  archive_.emplace(archive::store::open_archive(*options_.location, archive::sql::Access::write,
                                                static_cast<int>(1e3 * options_.wait_s)));
}

std::vector<std::string> Archiving::keep_numbers(const std::vector<NumbersToKeep>& numbers,
                                                 const std::string& manifest, Console& console) {
  if (!options_.location || numbers.empty()) return {};
  std::vector<calibration::NewCalibration> made;
  for (const NumbersToKeep& one : numbers) {
    made.push_back(calibration::entry_of_calibration(one.calibration, one.file));
    if (options_.inputs) {
      add_inputs(std::filesystem::path(manifest).parent_path().string(), made.back());
    }
  }
  if (!archive_) open();
  const std::string now = calibration::make_provenance({}).created_utc;
  const std::vector<archive::store::Added> added = archive_->add(made, options_.again, now);
  std::vector<std::string> ids;
  DoubtfulIdentities doubtful;
  for (std::size_t k = 0; k < added.size(); ++k) {
    ids.push_back(added[k].id);
    tell_added(added[k], numbers[k].file, console);
    if (added[k].is_new) doubtful.add(made[k].facts, now);
  }
  doubtful.tell(console);
  return ids;
}

std::string Archiving::keep_numbers(const NumbersToKeep& numbers, const std::string& manifest,
                                    Console& console) {
  const std::vector<std::string> ids = keep_numbers(std::vector{numbers}, manifest, console);
  return ids.empty() ? "" : ids.front();
}

std::optional<EarlierCalibration> Archiving::since_last(const std::string& id) {
  if (!archive_ || id.empty()) return std::nullopt;
  const calibration::JointName of = archive_->find(id).facts.of;
  const auto all = archive_->measured({of.robot, of.serial, of.joint, true});
  const auto is_this = [&](const calibration::Measured& one) { return one.entry.id == id; };
  const auto now = std::find_if(all.begin(), all.end(), is_this);
  if (now == all.end()) return std::nullopt;  // it has a later revision
  const calibration::Measured* before = nullptr;
  for (const calibration::Measured& one : all) {
    if (one.entry.facts.measured_at < now->entry.facts.measured_at) before = &one;
  }
  if (before == nullptr) return std::nullopt;
  const auto json = archive_->document(before->entry, calibration::DocumentKind::calibration);
  const std::string shown = before->entry.id.substr(0, calibration::shown_digits);
  if (!json) throw ArchiveError(shown + ": its calibration is not in the archive");
  try {
    return EarlierCalibration{Calibration::from_json(*json, shown), before->entry.id};
  } catch (const Failure& failure) {
    throw ArchiveError(std::string("what the archive has cannot be read: ") + failure.what());
  }
}

void Archiving::keep_report(const std::string& id, const std::string& html, Console& console) {
  if (!archive_) return;
  if (!archive_->attach_report(id, html, calibration::make_provenance({}).created_utc)) {
    console.say("the archive keeps its existing report of " +
                id.substr(0, calibration::shown_digits));
  }
}

}  // namespace tribolog::cli
