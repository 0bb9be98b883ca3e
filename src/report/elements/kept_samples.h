#pragma once
// Fewer samples for the same curves: which of a recording's samples a drawing needs.

#include <cstddef>
#include <vector>

namespace tribolog::report::elements {

/// Indices of at most `most` samples, ascending, the same for all signals so that an instant stays
/// an instant. First and last sample, the smallest and the largest of each signal, and `needed`
/// always stay (even if they are more than `most`); of the others go, one by one, those that a
/// straight line over time between their neighbours replaces best, in the worst of the signals as
/// a share of its span. What is not finite counts as no change.
/// @param t ascending.
/// @param signals each as long as t.
std::vector<std::size_t> kept_samples(const std::vector<double>& t,
                                      const std::vector<const std::vector<double>*>& signals,
                                      const std::vector<std::size_t>& needed, std::size_t most);

/// The samples at these indices.
std::vector<double> picked(const std::vector<double>& signal, const std::vector<std::size_t>& at);

/// Indices of the samples of the last cycles, every so many of them, so that they are at most about
/// `most`; of all samples where the frequency is 0 (not known).
/// @param t ascending, not empty.
std::vector<std::size_t> last_cycles(const std::vector<double>& t, double frequency_Hz,
                                     double cycles, std::size_t most);

}  // namespace tribolog::report::elements
