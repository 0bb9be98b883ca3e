#pragma once
// Where a long signal first gets somewhere, without looking at every sample on the way.

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace tribolog::statistics {

/// The largest values of a signal over stretches, over stretches of stretches, and so on.
class Summits {
 public:
  explicit Summits(std::vector<double> signal) {
    levels_.push_back(std::move(signal));
    while (levels_.back().size() > fan) {
      std::vector<double> largest;
      const std::vector<double>& below = levels_.back();
      for (std::size_t i = 0; i < below.size(); i += fan) {
        const auto first = below.begin() + static_cast<std::ptrdiff_t>(i);
        const auto size = static_cast<std::ptrdiff_t>(std::min(fan, below.size() - i));
        largest.push_back(*std::max_element(first, first + size));
      }
      levels_.push_back(std::move(largest));
    }
  }

  [[nodiscard]] const std::vector<double>& signal() const { return levels_.front(); }

  /// The first sample from `from` on of which `reached` holds, or the signal's size. Asks it of
  /// some 32 log16(size) values at most.
  /// @param reached whether a value is enough; holds of every larger value too.
  template <class Reached>
  [[nodiscard]] std::size_t first(std::size_t from, Reached reached) const {
    std::size_t level = 0;
    std::size_t i = from;
    while (i < levels_[level].size()) {
      if (reached(levels_[level][i])) {
        if (level == 0) return i;
        --level;
        i *= fan;
        continue;
      }
      ++i;
      while (i % fan == 0 && level + 1 < levels_.size()) {
        ++level;
        i /= fan;
      }
    }
    return signal().size();
  }

 private:
  static constexpr std::size_t fan = 16;
  std::vector<std::vector<double>> levels_;  // the signal first
};

}  // namespace tribolog::statistics
