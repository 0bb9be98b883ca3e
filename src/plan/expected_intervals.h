#pragma once
// What interval to expect of each quantity: the plan simulated with the joint that is assumed, at
// the noise that is assumed, and identified by the whole chain, several times.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plan/experiment_plan.h"
#include "truth/readings.h"

namespace tribolog::plan {

struct ExpectedInterval {
  truth::ReadingName name{};  ///< Words: "expected".
  truth::ReadingKind quantity{truth::ReadingKind::gravity};
  double truth{};  ///< Of the assumed joint.
  std::size_t runs{};
  std::size_t found{};   ///< Runs in which it was identified.
  std::size_t inside{};  ///< Of these, those whose interval holds the truth.
  double half_width{};   ///< Median of the stated 95 % intervals; NaN if never found.
  double scatter{};      ///< Standard deviation of what came back; NaN with fewer than two.
};

struct ExpectedIntervals {
  std::size_t runs{};
  std::uint64_t seed{};
  std::vector<ExpectedInterval> quantities;  ///< What the plan's recordings can show.
  [[nodiscard]] const ExpectedInterval* find(truth::ReadingName name) const;
};

struct ExpectationOptions {
  std::size_t runs{20};  ///< 0: none are simulated.
  std::uint64_t seed{1};
  std::size_t threads{0};  ///< 0: as many as the machine has cores. Changes no number.
};

/// @return without quantities where the plan holds no recording.
ExpectedIntervals expect_intervals(const ExperimentPlan& plan,
                                   const ExpectationOptions& options = {});

}  // namespace tribolog::plan
