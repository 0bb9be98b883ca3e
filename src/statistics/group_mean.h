#pragma once
// The mean of groups that differ by more than their members scatter: random effects.
//
//   y = mean + effect of the group + noise
//
// Whether groups differ: analysis of variance. The variance between them by moments (DerSimonian
// and Laird 1986), the interval of their mean with Student's quantile (Hartung and Knapp 2001),
// never below the one that the two variances give. Right for effects that are normal; of few groups
// the interval is wide.

#include <optional>
#include <vector>

namespace tribolog::statistics {

struct GroupMean {
  double mean{};
  double half_width{};   ///< 95 %
  double between_sd{};   ///< Standard deviation of the groups' effects, > 0.
  double largest_off{};  ///< Of a group's own mean from the mean.
};

/// @param groups none empty. @return nothing where they do not differ, or where none has two
/// members, so that no scatter within them is known.
std::optional<GroupMean> mean_of_groups_that_differ(const std::vector<std::vector<double>>& groups);

}  // namespace tribolog::statistics
