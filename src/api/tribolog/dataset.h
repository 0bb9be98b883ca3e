#pragma once
// A dataset: a manifest's facts about one joint, and the recordings that it names.

#include <memory>
#include <string>
#include <vector>

#include "tribolog/export.h"
#include "tribolog/values.h"

namespace tribolog::api {
struct Inside;
}

namespace tribolog {

/// What was read, whatever the logs' format: it never changes. Copies share it and cost nothing;
/// any number of threads may use it at once.
class TRIBOLOG_EXPORT Dataset {
 public:
  /// Reads a manifest (TOML) and every log that it names, relative to its folder. Calls from
  /// several threads take turns. A format that is read by a library prone to crash (MATLAB, HDF5)
  /// is read in a process forked for it.
  /// @throw Failure input_refused: the manifest or a log cannot be used, at file, line and column.
  static Dataset read(const std::string& manifest);

  [[nodiscard]] Joint joint() const;
  /// What the reader noticed, and the user should know. @throw Failure usage: no such language.
  [[nodiscard]] std::vector<Message> notes(const std::string& language = "en") const;
  /// Paths of all files that were read, the manifest first: what no output may replace.
  [[nodiscard]] std::vector<std::string> files() const;

 private:
  struct Contents;
  friend struct api::Inside;
  TRIBOLOG_HIDDEN explicit Dataset(std::shared_ptr<const Contents> contents);
  std::shared_ptr<const Contents> contents_;
};

}  // namespace tribolog
