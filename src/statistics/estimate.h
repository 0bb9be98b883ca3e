#pragma once
// A number with its uncertainty, and how a stage reports its outcome.

#include <string>

#include "base/statement.h"

namespace tribolog::statistics {

/// An estimate with a 95 % interval. `low <= estimate <= high`.
struct Estimate {
  double value{};
  double low{};
  double high{};
  Statement method;  ///< How the interval was obtained.

  [[nodiscard]] double half_width() const { return (high - low) / 2; }
};

/// An estimate whose interval is symmetric.
Estimate symmetric_estimate(double value, double half_width, Statement method = {});

/// The same quantity in another unit: value and interval times a factor of either sign.
Estimate scaled(const Estimate& estimate, double factor);

enum class StageState {
  done,              ///< Gave all it can.
  partial,           ///< Something is missing; `reason` says what and why.
  not_identifiable,  ///< Data are there but do not show it; `reason` has the number.
  skipped,           ///< No recording for it; `reason` says which would help.
};

std::string to_string(StageState state);

struct StageReport {
  std::string name;  ///< Stable: "cog_rough", "hysteresis", ...
  StageState state{StageState::skipped};
  Statement reason;  ///< Empty only if done.
};

}  // namespace tribolog::statistics
