#pragma once
// A small dataset on disk, and the program to run on it.

#include <string>

#include "support/run_program.h"

namespace tribolog::test {

inline const std::string program = std::string("'") + TRIBOLOG_PROGRAM + "' ";

/// The manifest of a log `log.csv` with columns t, q, tau, as a text to break on purpose.
inline std::string small_manifest() {
  return R"(schema = "tribolog-dataset-1"
[robot]
name = "test robot"
[joint]
name = "J1"
gear_ratio = 100
[effort]
kind = "motor_torque"
side = "motor"
[columns]
time = { name = "t", unit = "s" }
angle = { name = "q", unit = "rad" }
effort = { name = "tau", unit = "Nm" }
[[recording]]
role = "rough_sweep"
file = "log.csv"
)";
}

/// A sweep there and back over a gravity peak at 0.2 rad.
std::string small_log();

/// A text with one piece replaced; the piece must be there.
std::string replaced(std::string text, const std::string& from, const std::string& to);

/// A scratch directory with the manifest `dataset.toml` and the log `log.csv`.
class SmallDataset {
 public:
  explicit SmallDataset(const std::string& manifest = small_manifest(),
                        const std::string& log = small_log());
  [[nodiscard]] std::string file(const std::string& name) const { return scratch_.file(name); }
  [[nodiscard]] const ScratchDirectory& scratch() const { return scratch_; }
  /// Runs `tribolog COMMAND dataset.toml -o OUTPUT`, with the paths inside the scratch directory.
  [[nodiscard]] ProgramRun run(const std::string& command, const std::string& output) const;

 private:
  ScratchDirectory scratch_;
};

}  // namespace tribolog::test
