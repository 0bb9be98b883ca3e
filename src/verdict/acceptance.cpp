#include "verdict/acceptance.h"

#include <algorithm>
#include <cmath>

namespace tribolog::verdict {
namespace {

using calibration::LimitRule;

calibration::LimitState against_bound(const statistics::Estimate& e, double bound, bool is_upper) {
  const bool low_keeps = is_upper ? e.low <= bound : e.low >= bound;
  const bool high_keeps = is_upper ? e.high <= bound : e.high >= bound;
  if (low_keeps && high_keeps) return calibration::LimitState::inside;
  return low_keeps || high_keeps ? calibration::LimitState::crosses
                                 : calibration::LimitState::outside;
}

/// @param unit of the estimate; the limit's is "%" for some.
Statement statement_of(const calibration::LimitOutcome& o, joint::Quantity quantity,
                       const std::string& unit) {
  const std::string name = to_string(quantity);
  const Statement limited(Code::of((o.at_joint ? "quantity_at_joint." : "quantity.") + name));
  const Statement limit(Code::of("limit." + to_string(o.rule)),
                        {{"limit", o.limit}, {"unit", o.unit}});
  if (o.state == calibration::LimitState::unknown) {
    return {"limit.no_estimate",
            {{"quantity", Statement(Code::of("quantity." + name))}, {"limit", limit}}};
  }
  const statistics::Estimate& e = *o.estimate;
  const Code code = o.state == calibration::LimitState::inside    ? Code{"limit.kept"}
                    : o.state == calibration::LimitState::outside ? Code{"limit.broken"}
                                                                  : Code{"limit.not_shown"};
  return {code,
          {{"quantity", limited},
           {"value", e.value},
           {"unit", unit},
           {"low", e.low},
           {"high", e.high},
           {"limit", limit}}};
}

/// The outcomes of one `[[limit]]`, one for each number in it.
class LimitJudge {
 public:
  LimitJudge(const joint::AcceptanceLimit& limit, const joint::LimitedQuantity& key,
             double gear_ratio, calibration::QuantityVerdict& quantity)
      : limit_(limit), key_(key), quantity_(quantity) {
    if (quantity.estimate) {
      const statistics::Estimate stated =
          quantity.budget
              ? calibration::expanded_at(*quantity.budget, *quantity.estimate, key.gear_power)
              : *quantity.estimate;
      estimate_ = statistics::scaled(stated, key.factor * std::pow(gear_ratio, key.gear_power));
    }
  }

  void judge() {
    if (limit_.min) bound(LimitRule::min, *limit_.min, false);
    if (limit_.max) bound(LimitRule::max, *limit_.max, true);
    if (limit_.half_width) width(LimitRule::half_width, *limit_.half_width, key_.unit, 1);
    if (limit_.half_width_percent) {
      const double value = estimate_ ? std::abs(estimate_->value) : 1.0;
      width(LimitRule::half_width_percent, *limit_.half_width_percent, "%", 100 / value);
    }
  }

 private:
  void bound(LimitRule rule, double limit, bool is_upper) {
    calibration::LimitState state = calibration::LimitState::unknown;
    if (estimate_) state = against_bound(*estimate_, limit, is_upper);
    add(rule, limit, key_.unit, state);
  }

  void width(LimitRule rule, double limit, const std::string& unit, double factor) {
    calibration::LimitState state = calibration::LimitState::unknown;
    if (estimate_) {
      state = estimate_->half_width() * factor <= limit ? calibration::LimitState::inside
                                                        : calibration::LimitState::outside;
    }
    add(rule, limit, unit, state);
  }

  void add(LimitRule rule, double limit, const std::string& unit, calibration::LimitState state) {
    calibration::LimitOutcome o{key_.key, key_.at_joint, rule, limit, unit, estimate_, state, {}};
    o.outcome = statement_of(o, key_.quantity, key_.unit);
    if (state != calibration::LimitState::inside) {
      calibration::lower(quantity_, calibration::Verdict::doubtful, o.outcome,
                         state == calibration::LimitState::outside &&
                                 (rule == LimitRule::min || rule == LimitRule::max)
                             ? Statement{"record.second_measurement"}
                             : Statement{"record.more_of_the_same"});
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
      if (quantity.quantity != key->quantity) continue;
      quantity.decides = true;
      LimitJudge(limit, *key, gear_ratio, quantity).judge();
    }
  }
}

}  // namespace tribolog::verdict
