#include "export/simulation_files.h"

#include <filesystem>
#include <stdexcept>

#include "export/dataset_toml.h"
#include "export/recording_csv.h"
#include "export/truth_json.h"
#include "files/atomic_file.h"

namespace tribolog {

void write_simulation(const Scenario& scenario, const std::vector<Recording>& recordings,
                      const std::string& directory) {
  const std::filesystem::path folder(directory);
  for (const Recording& recording : recordings) {
    if (recording.name.empty() || recording.name.find('/') != std::string::npos) {
      throw std::invalid_argument("'" + recording.name + "' is not a plain file name");
    }
  }
  create_directory(directory);
  const std::string manifest = (folder / "dataset.toml").string();
  check_output_can_be_written(manifest);
  AtomicFiles files;
  for (const Recording& recording : recordings) {
    files.add((folder / recording.name).string(), recording_csv(recording, scenario.log));
  }
  if (!scenario.robot_description.empty()) {
    files.add((folder / description_beside(scenario)).string(), scenario.robot_description_text);
  }
  files.add((folder / "truth.json").string(), truth_json(scenario));
  files.add(manifest, dataset_toml(scenario, recordings));
  files.commit();
}

}  // namespace tribolog
