#include "verdict/acceptance.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace tribolog::verdict {
namespace {

calibration::LimitState against_bound(const statistics::Estimate& e, double bound, bool is_upper) {
  const bool low_keeps = is_upper ? e.low <= bound : e.low >= bound;
  const bool high_keeps = is_upper ? e.high <= bound : e.high >= bound;
  if (low_keeps && high_keeps) return calibration::LimitState::inside;
  return low_keeps || high_keeps ? calibration::LimitState::crosses
                                 : calibration::LimitState::outside;
}

/// @param unit of the estimate; the limit's is "%" for some.
std::string words_of(const calibration::LimitOutcome& o, const std::string& quantity,
                     const std::string& unit, const std::string& rule) {
  const std::string bound = fmt::format("the limit of {} {:.6g} {}", rule, o.limit, o.unit);
  if (o.state == calibration::LimitState::unknown) {
    return fmt::format("{}: there is no estimate to hold against {}", quantity, bound);
  }
  const statistics::Estimate& e = *o.estimate;
  const std::string value =
      fmt::format("{}{} {:.5g} {} (95 %: {:.5g} to {:.5g})", quantity,
                  o.key.find("_joint") == std::string::npos ? "" : " at the joint", e.value, unit,
                  e.low, e.high);
  switch (o.state) {
    case calibration::LimitState::inside:
      return value + " keeps " + bound;
    case calibration::LimitState::outside:
      return value + " breaks " + bound;
    default:
      return value + ": the interval crosses " + bound + ": not shown";
  }
}

/// The outcomes of one `[[limit]]`, one for each number in it.
class LimitJudge {
 public:
  LimitJudge(const joint::AcceptanceLimit& limit, const joint::LimitedQuantity& key,
             double gear_ratio, calibration::QuantityVerdict& quantity)
      : limit_(limit), key_(key), quantity_(quantity) {
    if (quantity.estimate) {
      estimate_ =
          statistics::scaled(*quantity.estimate, key.factor * std::pow(gear_ratio, key.gear_power));
    }
  }

  void judge() {
    if (limit_.min) bound("min", *limit_.min, "at least", false);
    if (limit_.max) bound("max", *limit_.max, "at most", true);
    if (limit_.half_width) width("half_width", *limit_.half_width, key_.unit, 1);
    if (limit_.half_width_percent) {
      const double value = estimate_ ? std::abs(estimate_->value) : 1.0;
      width("half_width_percent", *limit_.half_width_percent, "%", 100 / value);
    }
  }

 private:
  void bound(const std::string& rule, double limit, const std::string& words, bool is_upper) {
    calibration::LimitState state = calibration::LimitState::unknown;
    if (estimate_) state = against_bound(*estimate_, limit, is_upper);
    add(rule, limit, key_.unit, words, state);
  }

  void width(const std::string& rule, double limit, const std::string& unit, double factor) {
    calibration::LimitState state = calibration::LimitState::unknown;
    if (estimate_) {
      state = estimate_->half_width() * factor <= limit ? calibration::LimitState::inside
                                                        : calibration::LimitState::outside;
    }
    add(rule, limit, unit, "an interval of at most ±", state);
  }

  void add(const std::string& rule, double limit, const std::string& unit, const std::string& words,
           calibration::LimitState state) {
    calibration::LimitOutcome o{key_.key, rule, limit, unit, estimate_, state, ""};
    o.words = words_of(o, quantity_.words, key_.unit, words);
    if (state != calibration::LimitState::inside) {
      calibration::lower(
          quantity_, calibration::Verdict::doubtful, o.words,
          state == calibration::LimitState::outside && (rule == "min" || rule == "max")
              ? "nothing to record: the joint, or the limit, is not as it should be; a second "
                "measurement would confirm it"
              : "more of the same: the interval has to become narrower");
    }
    quantity_.limits.push_back(std::move(o));
  }

  const joint::AcceptanceLimit& limit_;
  const joint::LimitedQuantity& key_;
  calibration::QuantityVerdict& quantity_;
  std::optional<statistics::Estimate> estimate_;
};

}  // namespace

void apply_limits(const std::vector<joint::AcceptanceLimit>& limits, double gear_ratio,
                  std::vector<calibration::QuantityVerdict>& quantities) {
  for (const joint::AcceptanceLimit& limit : limits) {
    const joint::LimitedQuantity* key = joint::find_limited_quantity(limit.quantity);
    if (key == nullptr) continue;
    for (calibration::QuantityVerdict& quantity : quantities) {
      if (quantity.key != key->quantity) continue;
      quantity.decides = true;
      LimitJudge(limit, *key, gear_ratio, quantity).judge();
    }
  }
}

}  // namespace tribolog::verdict
