#include <cmath>

#include <fmt/format.h>

#include "verdict/quantity_rooms.h"

namespace tribolog {

const char* const record_a_sweep =
    "slow sweep over the joint's range, across the gravity peak, in both directions";
const char* const record_an_oscillation =
    "ten cycles of a micro-oscillation about the gravity peak, at eight positions spread over one "
    "turn of the motor, resolved into at least fifty encoder steps";
const char* const record_runs =
    "ten to twenty constant speeds, from the slowest smooth one to the fastest allowed, in both "
    "directions over the same angles";

QuantityVerdict by_estimate(const std::string& key, const std::string& words,
                            const std::string& unit, const std::optional<Estimate>& estimate,
                            const std::string& why_absent, const std::string& experiment) {
  constexpr double widest_usable = 0.3;
  QuantityVerdict q;
  q.key = key;
  q.words = words;
  q.unit = unit;
  if (!estimate || !std::isfinite(estimate->value)) {
    lower(q, Verdict::not_identifiable, why_absent, experiment);
    return q;
  }
  q.estimate = estimate;
  const double share = estimate->half_width() / std::abs(estimate->value);
  if (!(estimate->low > 0)) {
    lower(q, Verdict::not_identifiable,
          fmt::format("the data do not show it: its 95 % interval reaches {}",
                      estimate->low < 0 ? "below zero" : "zero"),
          experiment);
  } else if (!(share <= widest_usable)) {
    lower(q, Verdict::doubtful, fmt::format("known to ± {:.0f} % only", 100 * share), experiment);
  }
  return q;
}

}  // namespace tribolog
