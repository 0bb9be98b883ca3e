#pragma once
// A dataset: the facts about one joint in a manifest, and the recordings that it names.

#include <memory>
#include <string>
#include <vector>

#include "tribolog/export.h"
#include "tribolog/values.h"

namespace tribolog::api {
struct Inside;
}

namespace tribolog {

/// What was read, independent of the logs' format. Immutable. Copies share the contents and cost
/// nothing; any number of threads may use it at once.
class TRIBOLOG_EXPORT Dataset {
 public:
  /// Reads a manifest (TOML) and every log that it names, relative to its folder. Calls from
  /// several threads are serialised. Formats whose libraries may crash (MATLAB, HDF5) are read in a
  /// forked process.
  /// @throw Failure input_refused: the manifest or a log cannot be used, at file, line and column.
  static Dataset read(const std::string& manifest);

  /// One joint of a whole robot's manifest, by its name.
  /// @throw Failure input_refused: as above, or it has no joint of that name.
  static Dataset read(const std::string& manifest, const std::string& joint);
  /// The joints of a whole robot's manifest, in their order; none: it is a single joint's.
  /// @throw Failure input_refused: the manifest cannot be used.
  static std::vector<std::string> joints_in(const std::string& manifest);

  [[nodiscard]] Joint joint() const;
  /// What the reader noticed and the user should know. @throw Failure usage: no such language.
  [[nodiscard]] std::vector<Message> notes(const std::string& language = "en") const;
  /// Paths of all files that were read, the manifest first: no output may replace them.
  [[nodiscard]] std::vector<std::string> files() const;

 private:
  struct Contents;
  friend struct api::Inside;
  TRIBOLOG_HIDDEN explicit Dataset(std::shared_ptr<const Contents> contents);
  std::shared_ptr<const Contents> contents_;
};

}  // namespace tribolog
