// Friction at a few speeds, and the ranges in which it is usable, for page one.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "calibration/friction_speeds.h"
#include "report/document/view_parts.h"
#include "report/elements/result_words.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {
namespace {

using calibration::FrictionAtSpeed;
using calibration::Verdict;
using wording::tr;

std::string shown_speed(double speed_rad_s) {
  constexpr int digits = 3;
  return wording::significant(speed_rad_s, digits);
}

/// In the scale of all rows. Of a lopsided interval the wider side counts: a row has little room.
std::string shown_torque(const FrictionAtSpeed& f, const wording::Scale& scale) {
  const statistics::Estimate& e = f.torque_Nm;
  return wording::round_by_interval(
             statistics::symmetric_estimate(e.value, std::max(e.high - e.value, e.value - e.low)),
             scale)
      .plus_minus();
}

std::string speed_range(const calibration::SpeedRange& range) {
  return tr("{lowest} to {highest}",
            {{"lowest", shown_speed(range.low_rad_s)},
             {"highest", wording::with_unit(shown_speed(range.high_rad_s), "rad/s")}});
}

/// By its verdict, then by its interval.
bool is_better(const FrictionAtSpeed& a, const FrictionAtSpeed& b) {
  const auto width = [](const FrictionAtSpeed& f) {
    return (f.torque_Nm.high - f.torque_Nm.low) / std::abs(f.torque_Nm.value);
  };
  return std::pair(a.verdict, width(a)) < std::pair(b.verdict, width(b));
}

/// @param all not empty.
std::string ranges_or_reason(const std::vector<FrictionAtSpeed>& all, bool has_gear) {
  const FrictionAtSpeed& worst = *std::max_element(all.begin(), all.end(), is_better);
  const auto reason = [&] {
    return tr("At {speed}: {reason}.",
              {{"speed", wording::with_unit(shown_speed(worst.speed_rad_s), "rad/s")},
               {"reason", wording::words(worst.reason)}});
  };
  constexpr std::size_t most_ranges = 2;
  std::vector<std::string> ranges;
  for (const auto& range : calibration::usable_ranges(all, most_ranges)) {
    ranges.push_back(speed_range(range));
  }
  if (ranges.empty()) {
    return tr("Not good for feed-forward or simulation at any of these speeds.") + " " + reason();
  }
  const std::string listed = fmt::format("{}", fmt::join(ranges, ", "));
  const std::string good =
      has_gear ? tr("Good for feed-forward and simulation at motor speeds of {ranges}.",
                    {{"ranges", listed}})
               : tr("Good for feed-forward and simulation at joint speeds of {ranges}.",
                    {{"ranges", listed}});
  return worst.verdict == Verdict::usable ? good : good + " " + reason();
}

/// Where both directions differ beyond their intervals, and by most of their mean; empty: nowhere.
std::string difference_of_directions(const std::vector<FrictionAtSpeed>& all,
                                     const wording::Scale& scale) {
  const FrictionAtSpeed* most = nullptr;
  const auto share = [](const FrictionAtSpeed& f) {
    return std::abs(f.forward_Nm->value - f.backward_Nm->value) / f.torque_Nm.value;
  };
  for (const FrictionAtSpeed& f : all) {
    if (!f.forward_Nm || !f.backward_Nm || f.verdict == Verdict::not_identifiable) continue;
    const bool differs =
        f.forward_Nm->low > f.backward_Nm->high || f.backward_Nm->low > f.forward_Nm->high;
    if (differs && (most == nullptr || share(f) > share(*most))) most = &f;
  }
  constexpr double worth_a_word = 0.01;
  if (most == nullptr || share(*most) < worth_a_word) return "";
  const auto shown = [&](const statistics::Estimate& e) {
    return wording::with_unit(wording::round_by_interval(e, scale).estimate, scale.unit);
  };
  return tr("At {speed} friction is {forward} while the angle rises and {backward} while it falls.",
            {{"speed", wording::with_unit(shown_speed(most->speed_rad_s), "rad/s")},
             {"forward", shown(*most->forward_Nm)},
             {"backward", shown(*most->backward_Nm)}});
}

/// A speed that the manifest states and no recording reaches.
FrictionRow unmeasured(double speed_at_joint_rad_s, double gear_ratio) {
  FrictionRow row;
  row.speed = shown_speed(speed_at_joint_rad_s * std::abs(gear_ratio));
  if (gear_ratio != 1.0) row.speed_at_joint = shown_speed(speed_at_joint_rad_s);
  row.verdict_word = tr("not measured");
  return row;
}

}  // namespace

FrictionSpeeds friction_speeds(const calibration::Calibration& c) {
  const std::vector<FrictionAtSpeed>& all = c.judgement.friction_at_speed;
  const double gear_ratio = c.manifest.drive.gear_ratio();
  FrictionSpeeds made;
  if (all.empty()) return made;
  double largest_Nm = 0;
  for (const FrictionAtSpeed& f : all) largest_Nm = std::max(largest_Nm, f.torque_Nm.value);
  const wording::Scale scale = wording::torque_scale(largest_Nm);
  const wording::Scale joint_scale = wording::torque_scale(largest_Nm * std::abs(gear_ratio));
  made.unit = scale.unit;
  made.unit_at_joint = joint_scale.unit;
  const double slowest = all.front().speed_rad_s / std::abs(gear_ratio);
  const double fastest = all.back().speed_rad_s / std::abs(gear_ratio);
  for (const double speed : c.manifest.friction_at_rad_s) {
    if (speed < slowest) made.rows.push_back(unmeasured(speed, gear_ratio));
  }
  for (const FrictionAtSpeed& f : calibration::of_a_table(all)) {
    FrictionRow row;
    row.speed = shown_speed(f.speed_rad_s);
    row.outcome = elements::outcome_of(f.verdict);
    row.verdict_word = elements::verdict_in_words(f.verdict);
    const bool is_shown = f.verdict != Verdict::not_identifiable;
    if (is_shown) row.torque = shown_torque(f, scale);
    if (gear_ratio != 1.0) {
      const FrictionAtSpeed there = calibration::at_joint(f, gear_ratio);
      row.speed_at_joint = shown_speed(there.speed_rad_s);
      if (is_shown) row.torque_at_joint = shown_torque(there, joint_scale);
    }
    made.rows.push_back(std::move(row));
  }
  for (const double speed : c.manifest.friction_at_rad_s) {
    if (speed > fastest) made.rows.push_back(unmeasured(speed, gear_ratio));
  }
  made.good_for = ranges_or_reason(all, gear_ratio != 1.0);
  if (const std::string differs = difference_of_directions(all, scale); !differs.empty()) {
    made.good_for += " " + differs;
  }
  const joint::StatedUncertainty& stated = c.manifest.uncertainty;
  if (stated.torque_constant_percent || stated.gear_ratio_percent) {
    made.good_for += " " + tr("Without the uncertainty that the manifest states of torque constant "
                              "and gear ratio: it scales all of them alike.");
  }
  return made;
}

}  // namespace tribolog::report::document
