#pragma once
// The conversions of all logs of a dataset, each told once.

#include <string>
#include <vector>

#include "joint/dataset.h"

namespace tribolog {

/// A conversion with the logs whose columns it was applied to.
struct SharedConversion {
  ColumnConversion conversion;
  std::vector<std::string> files;  ///< In the manifest's order, each once.
  bool is_of_all{};                ///< Every log that was read has it.
};

/// By signal, and where logs differ in the order in which they come.
std::vector<SharedConversion> shared_conversions(const std::vector<InputFile>& inputs);

}  // namespace tribolog
