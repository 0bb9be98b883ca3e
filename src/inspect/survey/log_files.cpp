#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>
#include <string_view>

#include "base/closest_match.h"
#include "base/error.h"
#include "base/input_file.h"
#include "ingest/log/log_format.h"
#include "inspect/survey/log_survey.h"

namespace tribolog::inspect::survey {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largest_metadata_bytes = 1 << 24;
/// Of those that are not read the refusal says what to run.
/// ".active" is a bag of ROS 1 that was not closed.
constexpr std::array known_endings{
    ".active",  ".arrow", ".bag",  ".csv",  ".dat", ".db3", ".feather", ".h5",  ".hdf5",
    ".json",    ".log",   ".mat",  ".mcap", ".mdf", ".mf4", ".npy",     ".npz", ".jsonl",
    ".parquet", ".rrd",   ".tdms", ".tsv",  ".txt", ".ulg", ".lvm"};

/// What rosbag2's metadata.yaml lists under relative_file_paths, a line each: "    - bag_0.mcap".
std::vector<std::string> listed_files(const fs::path& metadata) {
  std::istringstream lines(read_file(metadata.string(), largest_metadata_bytes));
  std::vector<std::string> files;
  bool is_list = false;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string::npos) continue;
    const std::string_view text = std::string_view(line).substr(first);
    if (text.starts_with("relative_file_paths:")) {
      is_list = true;
    } else if (is_list && text.starts_with("- ")) {
      const std::size_t begin = text.find_first_not_of(" \"'", 1);
      const std::size_t end = text.find_last_not_of(" \t\r\"'");
      if (begin != std::string_view::npos && begin <= end) {
        files.emplace_back(text.substr(begin, end + 1 - begin));
      }
    } else {
      is_list = false;
    }
  }
  return files;
}

/// A Zarr store is a folder of chunks, which its metadata alone make arrays of.
void refuse_zarr(const fs::path& folder) {
  std::error_code error;
  for (const char* name : {".zgroup", ".zarray", "zarr.json"}) {
    if (!fs::exists(folder / name, error)) continue;
    throw InputError({folder.string(), 0, 0}, {"is a Zarr store, which is not read", "", "",
                                               std::string(ingest::log::by_zarr)});
  }
}

/// Of a data set of LeRobot, data/chunk-000/*.parquet and so on; none of any other folder.
std::vector<std::string> files_of_lerobot(const fs::path& folder) {
  std::vector<std::string> files;
  std::error_code error;
  if (!fs::exists(folder / "meta" / "info.json", error)) return files;
  for (const fs::directory_entry& chunk : fs::directory_iterator(folder / "data", error)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(chunk.path(), error)) {
      if (entry.path().extension() == ".parquet") files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  if (!files.empty()) return files;
  throw InputError({folder.string(), 0, 0}, {"is a data set of LeRobot without data/*/*.parquet",
                                             "", "", "download its folder data too"});
}

}  // namespace

std::vector<std::string> log_files_in(const std::string& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return {path};
  const fs::path folder(path);
  refuse_zarr(folder);
  std::vector<std::string> files = files_of_lerobot(folder);
  if (!files.empty()) return files;
  const fs::path metadata = folder / "metadata.yaml";
  if (fs::exists(metadata, error)) {
    for (const std::string& name : listed_files(metadata))
      files.push_back((folder / name).string());
    if (!files.empty()) return files;
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string ending = entry.path().extension().string();
    const bool is_log =
        std::find(known_endings.begin(), known_endings.end(), ending) != known_endings.end();
    // What this program writes beside logs is none.
    if (is_log && entry.path().string().ends_with(".calibration.json")) continue;
    if (is_log && entry.is_regular_file(error)) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) {
    throw InputError({path, 0, 0},
                     {"is a directory without logs", "",
                      "a rosbag2 folder, or files whose names end in .csv, .mcap, .mat ...",
                      "name the logs themselves"});
  }
  return files;
}

}  // namespace tribolog::inspect::survey
