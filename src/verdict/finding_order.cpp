#include "verdict/finding_order.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

#include "calibration/calibration.h"

namespace tribolog::verdict {

namespace {

/// Whether the statement has one of the codes, or one inside it has.
bool says(const Statement& statement, const std::vector<Code>& codes) {
  if (std::find(codes.begin(), codes.end(), statement.code()) != codes.end()) return true;
  return std::any_of(statement.values().begin(), statement.values().end(), [&](const auto& v) {
    const auto* inside = std::get_if<std::vector<Statement>>(&v.value);
    return inside != nullptr && std::any_of(inside->begin(), inside->end(),
                                            [&](const Statement& one) { return says(one, codes); });
  });
}

/// Lags that the loops' fit cannot take off as what they are.
const std::vector<Code> unnamed_lags{"cause.lag", "cause.lag_of_angle",
                                     "cause.lag_filter_of_angle"};

/// Root mean square of what a torque changes by within a time [s].
double change_within(const method::hysteresis::LoopTrace& loop, double time_s) {
  double squares = 0;
  std::size_t count = 0;
  std::size_t later = 0;
  for (std::size_t i = 0; i < loop.model_torque_Nm.size(); ++i) {
    while (later < loop.t_s.size() && loop.t_s[later] < loop.t_s[i] + time_s) ++later;
    if (later >= loop.model_torque_Nm.size()) break;
    const double change = loop.model_torque_Nm[later] - loop.model_torque_Nm[i];
    if (!std::isfinite(change)) continue;
    squares += change * change;
    ++count;
  }
  return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0;
}

/// Whether a lag moves the torque of the loop that the model describes worst by as much as the
/// model leaves there.
bool lag_bends_loops(const calibration::Calibration& c) {
  const auto* worst = c.lugre ? c.lugre->worst_described() : nullptr;
  if (worst == nullptr || !c.torque_lag.lag_s) return false;
  const auto& loops = c.curves.loops;
  const auto loop = std::find_if(loops.begin(), loops.end(), [&](const auto& one) {
    return one.recording == worst->recording;
  });
  return loop != loops.end() &&
         change_within(*loop, std::abs(c.torque_lag.lag_s->value)) > worst->systematic_Nm;
}

/// Whether what one finding tells is a consequence of what the other does: estimates that disagree
/// as an offset makes them, loops that are not symmetric as friction by direction makes them, loops
/// that are beside a peak that a moving joint has shifted or that no gravity makes.
bool follows_from(const Statement& finding, const Statement& cause,
                  const calibration::Calibration& c) {
  const std::vector<Code> by_direction{"cause.asymmetry", "cause.asymmetry_of_runs"};
  if (says(finding, {"cross_check.offset_or_direction"})) {
    return says(cause, {"cause.offset", "cause.offset_or_dead_zone", "cause.offset_taken_off",
                        "cause.offset_taken_off_or_dead_zone"}) ||
           says(cause, by_direction);
  }
  if (finding.is("cause.other_contact") && says(cause, by_direction)) {
    const double asymmetry_Nm =
        std::abs(c.session.direction.asymmetry.value) * c.session.mean_friction_Nm;
    const auto* worst = c.lugre ? c.lugre->worst_described() : nullptr;
    return worst != nullptr && c.session.direction.asymmetry_found &&
           asymmetry_Nm > worst->systematic_Nm;
  }
  if (says(finding, {"cause.other_contact", "cause.damping_falls"}) && says(cause, unnamed_lags)) {
    return lag_bends_loops(c);
  }
  return says(finding, {"check.oscillation_at_peak"}) &&
         says(cause, {"cause.other_joint", "cause.no_gravity", "cause.no_gravity_or_removed"});
}

/// How many of the numbers that decide rest their doubt on a finding: it is the first reason, or
/// follows from the first.
std::ptrdiff_t numbers_resting_on(const Statement& finding, const calibration::Calibration& c,
                                  const std::vector<calibration::QuantityVerdict>& quantities) {
  return std::count_if(
      quantities.begin(), quantities.end(), [&](const calibration::QuantityVerdict& q) {
        if (!q.decides || q.verdict == calibration::Verdict::usable || q.reasons.empty())
          return false;
        if (q.reasons.front() == finding) return true;
        return q.reasons.size() > 1 && q.reasons[1] == finding &&
               follows_from(finding, q.reasons.front(), c);
      });
}

/// Each finding stands behind the first that it follows from.
void put_causes_first(const calibration::Calibration& c, std::vector<Statement>& findings) {
  for (auto at = findings.begin(); at != findings.end(); ++at) {
    const auto cause = std::find_if(at + 1, findings.end(), [&](const Statement& other) {
      return follows_from(*at, other, c);
    });
    if (cause != findings.end()) std::rotate(at, cause, cause + 1);
  }
}

}  // namespace

void give_causes_as_reasons(const calibration::Calibration& c,
                            const std::vector<calibration::RuleOutcome>& rules,
                            std::vector<calibration::QuantityVerdict>& quantities) {
  for (calibration::QuantityVerdict& q : quantities) {
    for (std::size_t k = 0; k < q.reasons.size(); ++k) {
      const auto cause = std::find_if(rules.begin(), rules.end(), [&](const auto& rule) {
        return !rule.finding.empty() && follows_from(q.reasons[k], rule.finding, c);
      });
      if (cause == rules.end()) continue;
      if (std::find(q.reasons.begin(), q.reasons.end(), cause->finding) != q.reasons.end())
        continue;
      q.reasons.insert(q.reasons.begin() + static_cast<std::ptrdiff_t>(k), cause->finding);
      ++k;
    }
  }
}

void order_findings(const calibration::Calibration& c,
                    const std::vector<calibration::QuantityVerdict>& quantities, std::size_t checks,
                    std::vector<Statement>& findings) {
  const auto behind_checks = findings.begin() + static_cast<std::ptrdiff_t>(checks);
  std::stable_sort(behind_checks, findings.end(), [&](const Statement& a, const Statement& b) {
    return numbers_resting_on(a, c, quantities) > numbers_resting_on(b, c, quantities);
  });
  put_causes_first(c, findings);
}

}  // namespace tribolog::verdict
