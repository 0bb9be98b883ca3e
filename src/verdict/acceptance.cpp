#include "verdict/acceptance.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace tribolog {
namespace {

LimitState against_bound(const Estimate& e, double bound, bool is_upper) {
  const bool low_keeps = is_upper ? e.low <= bound : e.low >= bound;
  const bool high_keeps = is_upper ? e.high <= bound : e.high >= bound;
  if (low_keeps && high_keeps) return LimitState::inside;
  return low_keeps || high_keeps ? LimitState::crosses : LimitState::outside;
}

/// @param unit of the estimate; the limit's is "%" for some.
std::string words_of(const LimitOutcome& o, const std::string& quantity, const std::string& unit,
                     const std::string& rule) {
  const std::string bound = fmt::format("the limit of {} {:.6g} {}", rule, o.limit, o.unit);
  if (o.state == LimitState::unknown) {
    return fmt::format("{}: there is no estimate to hold against {}", quantity, bound);
  }
  const Estimate& e = *o.estimate;
  const std::string value =
      fmt::format("{}{} {:.5g} {} (95 %: {:.5g} to {:.5g})", quantity,
                  o.key.find("_joint") == std::string::npos ? "" : " at the joint", e.value, unit,
                  e.low, e.high);
  switch (o.state) {
    case LimitState::inside:
      return value + " keeps " + bound;
    case LimitState::outside:
      return value + " breaks " + bound;
    default:
      return value + ": the interval crosses " + bound + ": not shown";
  }
}

/// The outcomes of one `[[limit]]`, one for each number in it.
class LimitJudge {
 public:
  LimitJudge(const AcceptanceLimit& limit, const LimitedQuantity& key, double gear_ratio,
             QuantityVerdict& quantity)
      : limit_(limit), key_(key), quantity_(quantity) {
    if (quantity.estimate) {
      estimate_ = scaled(*quantity.estimate, key.factor * std::pow(gear_ratio, key.gear_power));
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
    LimitState state = LimitState::unknown;
    if (estimate_) state = against_bound(*estimate_, limit, is_upper);
    add(rule, limit, key_.unit, words, state);
  }

  void width(const std::string& rule, double limit, const std::string& unit, double factor) {
    LimitState state = LimitState::unknown;
    if (estimate_) {
      state = estimate_->half_width() * factor <= limit ? LimitState::inside : LimitState::outside;
    }
    add(rule, limit, unit, "an interval of at most ±", state);
  }

  void add(const std::string& rule, double limit, const std::string& unit, const std::string& words,
           LimitState state) {
    LimitOutcome o{key_.key, rule, limit, unit, estimate_, state, ""};
    o.words = words_of(o, quantity_.words, key_.unit, words);
    if (state != LimitState::inside) {
      lower(quantity_, Verdict::doubtful, o.words,
            state == LimitState::outside && (rule == "min" || rule == "max")
                ? "nothing to record: the joint, or the limit, is not as it should be; a second "
                  "measurement would confirm it"
                : "more of the same: the interval has to become narrower");
    }
    quantity_.limits.push_back(std::move(o));
  }

  const AcceptanceLimit& limit_;
  const LimitedQuantity& key_;
  QuantityVerdict& quantity_;
  std::optional<Estimate> estimate_;
};

}  // namespace

void apply_limits(const std::vector<AcceptanceLimit>& limits, double gear_ratio,
                  std::vector<QuantityVerdict>& quantities) {
  for (const AcceptanceLimit& limit : limits) {
    const LimitedQuantity* key = find_limited_quantity(limit.quantity);
    if (key == nullptr) continue;
    for (QuantityVerdict& quantity : quantities) {
      if (quantity.key != key->quantity) continue;
      quantity.decides = true;
      LimitJudge(limit, *key, gear_ratio, quantity).judge();
    }
  }
}

}  // namespace tribolog
