#include "tribolog/dataset.h"

#include <filesystem>
#include <mutex>
#include <utility>

#include "api/contents.h"
#include "api/guard.h"
#include "ingest/dataset/dataset_file.h"
#include "wording/language.h"
#include "wording/torques_in.h"

namespace tribolog {

Dataset::Dataset(std::shared_ptr<const Contents> contents) : contents_(std::move(contents)) {}

Dataset Dataset::read(const std::string& manifest) { return read(manifest, {}); }

Dataset Dataset::read(const std::string& manifest, const std::string& joint) {
  return api::guarded([&] {
    // HDF5 takes one thread at a time, and a process forked while another thread reads would keep
    // what that one has locked.
    static std::mutex reading;
    const std::lock_guard lock(reading);
    return Dataset(std::make_shared<const Contents>(
        Contents{manifest, ingest::dataset::read_dataset(manifest, joint)}));
  });
}

std::vector<std::string> Dataset::joints_in(const std::string& manifest) {
  return api::guarded([&] { return ingest::dataset::joints_of_robot(manifest); });
}

Joint Dataset::joint() const {
  return api::guarded([&] { return api::joint_of(contents_->dataset.manifest); });
}

std::vector<Message> Dataset::notes(const std::string& language) const {
  return api::guarded([&] {
    const wording::WordsIn words(api::language_of(language));
    const wording::TorquesIn unit(contents_->dataset.manifest.torque_unit());
    std::vector<Message> notes;
    for (const Statement& note : contents_->dataset.notes) {
      notes.push_back(api::message_of(api::said(note)));
    }
    return notes;
  });
}

std::vector<std::string> Dataset::files() const {
  return api::guarded([&] {
    const joint::Dataset& dataset = contents_->dataset;
    const std::filesystem::path directory =
        std::filesystem::path(contents_->manifest).parent_path();
    std::vector<std::string> files{contents_->manifest};
    if (dataset.robot) files.push_back((directory / dataset.manifest.robot_description).string());
    for (const joint::Recording& recording : dataset.recordings) {
      files.push_back((directory / recording.name).string());
    }
    return files;
  });
}

}  // namespace tribolog
