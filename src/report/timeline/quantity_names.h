#pragma once
// Internal to the timeline: archived quantities in a sentence, friction at many speeds as one.

#include <string>
#include <vector>

namespace tribolog::report::timeline {

struct NamedQuantity {
  std::string name;  ///< As in the archive: "friction_at_10".
  std::string text;  ///< "friction at 10 rad/s", or with what is said of it behind.
};

/// Of these names those of friction at speeds, as long as they are many: "friction at 7 speeds from
/// 0.3 to 300 rad/s"; empty where they are fewer than three.
std::string friction_at_speeds(const std::vector<std::string>& names);

/// "gravity torque, inertia and friction at 7 speeds from 0.3 to 300 rad/s"
std::string listed_quantities(const std::vector<NamedQuantity>& quantities);

}  // namespace tribolog::report::timeline
