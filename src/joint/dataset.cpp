#include "joint/dataset.h"

#include <algorithm>

namespace tribolog::joint {

bool resamples_are_allowed(std::uint64_t resamples) {
  return resamples == 0 || (resamples >= fewest_resamples && resamples <= most_resamples);
}

Statement allowed_resamples() {
  return {"resamples.allowed", {{"fewest", fewest_resamples}, {"most", most_resamples}}};
}

std::vector<const Recording*> Dataset::with_role(Role role) const {
  std::vector<const Recording*> found;
  for (const Recording& recording : recordings) {
    if (recording.role == role) found.push_back(&recording);
  }
  return found;
}

std::vector<SharedConversion> shared_conversions(const std::vector<InputFile>& inputs) {
  std::vector<SharedConversion> all;
  std::vector<std::string> logs;
  const auto add_once = [](std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const InputFile& input : inputs) {
    if (input.conversions.empty()) continue;
    add_once(logs, input.name);
    for (const ColumnConversion& conversion : input.conversions) {
      auto known = std::find_if(all.begin(), all.end(), [&](const SharedConversion& s) {
        return s.conversion == conversion;
      });
      if (known == all.end()) known = all.insert(all.end(), {conversion, {}, false});
      add_once(known->files, input.name);
    }
  }
  for (SharedConversion& shared : all) shared.is_of_all = shared.files.size() == logs.size();
  std::stable_sort(all.begin(), all.end(),
                   [](const SharedConversion& a, const SharedConversion& b) {
                     return a.conversion.signal < b.conversion.signal;
                   });
  return all;
}

}  // namespace tribolog::joint
