#pragma once
// What came of the known-truth check (truth_check.h).

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tribolog {

/// One number that was put in, over the runs.
struct ReturnedQuantity {
  std::string name;  ///< Of the reading, readings.h.
  std::string unit;
  double put_in{};
  double came_back{};   ///< Mean over the runs in which it was found; NaN: in none.
  double scatter{};     ///< Standard deviation of the runs; NaN with fewer than two.
  double half_width{};  ///< Mean half width of the stated intervals.
  std::size_t found{};
  std::size_t inside{};  ///< Runs whose stated interval holds what was put in.
  /// (came back - put in) / half width of each run in which it was found; within -1 and 1: inside.
  std::vector<double> in_half_widths;
  /// Found in most runs, and inside the interval in most of them or off by less than what matters.
  bool comes_back{};
};

/// A quantity that does not come back, in words.
struct TruthFinding {
  std::string name;  ///< Of the ReturnedQuantity.
  std::string words;
};

struct TruthCheckResult {
  std::size_t runs{};  ///< 0: the check was not made.
  std::uint64_t seed{};
  double white_Nm{};        ///< Found in the torque: median over the recordings, motor side.
  double torque_step_Nm{};  ///< 0: continuous.
  double ripple_Nm{};       ///< Standard deviation; 0: none.
  std::vector<ReturnedQuantity> quantities;
  std::vector<std::string> left_out;   ///< What could not be simulated, and why.
  std::vector<TruthFinding> findings;  ///< What does not come back.

  [[nodiscard]] const ReturnedQuantity* find(const std::string& name) const;
};

}  // namespace tribolog
