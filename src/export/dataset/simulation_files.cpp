#include "export/dataset/simulation_files.h"

#include <filesystem>
#include <stdexcept>

#include "base/atomic_file.h"
#include "export/dataset/dataset_toml.h"
#include "export/dataset/recording_csv.h"
#include "export/dataset/truth_json.h"

namespace tribolog {

void write_simulation(const Scenario& scenario, const std::vector<Recording>& recordings,
                      const std::string& directory, const std::vector<std::string>& inputs) {
  const std::filesystem::path folder(directory);
  for (const Recording& recording : recordings) {
    if (recording.name.empty() || recording.name.find('/') != std::string::npos) {
      throw std::invalid_argument("'" + recording.name + "' is not a plain file name");
    }
  }
  AtomicFiles files;
  files.make_directory(directory);
  const auto add = [&](const std::string& name, const std::string& content) {
    const std::string path = (folder / name).string();
    check_output_can_be_written(path, inputs);
    files.add(path, content);
  };
  for (const Recording& recording : recordings) {
    add(recording.name, recording_csv(recording, scenario.log));
  }
  if (!scenario.robot_description.empty()) {
    add(description_beside(scenario), scenario.robot_description_text);
  }
  add("truth.json", truth_json(scenario));
  add("dataset.toml", dataset_toml(scenario, recordings));
  files.commit();
}

}  // namespace tribolog
