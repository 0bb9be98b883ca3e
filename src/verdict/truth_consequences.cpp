#include "verdict/truth_consequences.h"

#include <algorithm>
#include <map>

namespace tribolog {
namespace {

/// Keys of the quantities that a reading of the check stands for.
std::vector<std::string> quantities_of(const std::string& reading, const std::string& recommended) {
  static const std::map<std::string, std::string> keys{
      {"q_peak", "cog_angle"},
      {"bristle_stiffness", "bristle_stiffness"},
      {"static_torque", "break_away_torque"},
      {"coulomb", "coulomb_torque"},
      {"viscous", "viscous_coefficient"},
      {"stribeck_speed", "stribeck_speed"},
  };
  if (reading == recommended) return {"gravity_torque", "surrogate_mass"};
  const auto it = keys.find(reading);
  return it == keys.end() ? std::vector<std::string>{} : std::vector<std::string>{it->second};
}

}  // namespace

void apply_truth_check(const TruthCheckResult& check, const std::string& recommended,
                       std::vector<QuantityVerdict>& quantities) {
  for (const TruthFinding& finding : check.findings) {
    for (const std::string& key : quantities_of(finding.name, recommended)) {
      const auto it = std::find_if(quantities.begin(), quantities.end(),
                                   [&](const QuantityVerdict& q) { return q.key == key; });
      if (it == quantities.end()) continue;
      lower(*it, Verdict::doubtful, finding.words,
            "a motion that shows it better, or less noise: the known-truth check says how far off "
            "it comes back");
    }
  }
}

}  // namespace tribolog
