#pragma once
// Where a signal first stands still, or last stood still.

#include <cstddef>
#include <optional>
#include <vector>

namespace tribolog {

struct QuietSearch {
  std::size_t from{};  ///< First sample looked at.
  std::size_t to{};    ///< Last one, >= from.
  double window_s{};   ///< How long it has to stand, > 0.
  double tolerance{};  ///< Largest spread of the signal meanwhile.
};

/// First sample of the first window within which the signal stands; nothing: it never does.
std::optional<std::size_t> first_quiet(const std::vector<double>& t_s,
                                       const std::vector<double>& signal,
                                       const QuietSearch& search);

/// Last sample of the last such window.
std::optional<std::size_t> last_quiet(const std::vector<double>& t_s,
                                      const std::vector<double>& signal, const QuietSearch& search);

}  // namespace tribolog
