#include "exports/results/simulator_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include <boost/math/tools/minima.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/requirements.h"
#include "calibration/archived_calibration.h"
#include "calibration/friction_speeds.h"
#include "calibration/read_calibration.h"

namespace tribolog::exports::results {

namespace {

constexpr std::string_view hint = "; --doubtful-too exports it all the same";

/// For a remark beside numbers that were exported after all.
std::string without_hint(const std::string& why) { return why.substr(0, why.find(hint)); }

std::string in_words(calibration::Verdict verdict) {
  std::string words = calibration::to_string(verdict);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

}  // namespace

std::string objection(const ArchivedJoint& joint, joint::Quantity quantity, bool doubtful_too,
                      bool is_number) {
  const std::string name = to_string(quantity);
  for (const calibration::Quantity& q : joint.quantities) {
    if (q.name != name) continue;
    const std::string words = printable(q.words);
    if (is_number && !q.estimate) return words + " was not identified";
    const std::string shown =
        is_number ? fmt::format(" of {:.4g} {} (95 %: {:.4g} to {:.4g})", q.estimate->value,
                                printable(q.unit), q.estimate->low, q.estimate->high)
                  : "";
    if (is_number && q.estimate->value < 0) return words + shown + " is below zero";
    if (q.verdict == calibration::Verdict::usable || doubtful_too) return "";
    return words + shown + " is " + in_words(q.verdict) + std::string(hint);
  }
  return "the calibration has no " + printable(name);
}

const calibration::Quantity* if_usable(const ArchivedJoint& joint, joint::Quantity quantity,
                                       bool doubtful_too, std::string& why_not) {
  why_not = objection(joint, quantity, doubtful_too);
  return why_not.empty() ? joint.found(quantity) : nullptr;
}

void refuse_export(const ArchivedJoint& joint, const std::string& why) {
  throw UsageError(joint.entry.id.substr(0, calibration::shown_digits) + ": not exported: " + why);
}

void refuse_amperes(const ArchivedJoint& joint) {
  if (!joint.is_in_amperes()) return;
  refuse_export(joint,
                "the torques are in amperes, since the torque constant was not stated; expected "
                "N·m; identify the log again with --torque-constant NM_PER_A (in a manifest: "
                "torque_constant_Nm_A)");
}

namespace {

std::string range_text(double low_rad_s, double high_rad_s) {
  return fmt::format("{:.4g} to {:.4g} rad/s", low_rad_s, high_rad_s);
}

bool is_within(double speed_rad_s, const SimulatorOptions& options) {
  constexpr double rounding = 1e-6;  // a range's ends may be typed from a table
  return !options.range_rad_s || (speed_rad_s >= options.range_rad_s->low_rad_s * (1 - rounding) &&
                                  speed_rad_s <= options.range_rad_s->high_rad_s * (1 + rounding));
}

}  // namespace

std::vector<SpeedFriction> usable_friction(const ArchivedJoint& joint,
                                           const SimulatorOptions& options, std::string& why_not) {
  why_not.clear();
  const std::vector<calibration::FrictionAtSpeed> all =
      calibration::read_curves(joint.calibration).friction_at_speed;
  std::vector<SpeedFriction> usable;
  const calibration::FrictionAtSpeed* best_refused = nullptr;
  for (const calibration::FrictionAtSpeed& one : all) {
    const calibration::FrictionAtSpeed f = calibration::at_joint(one, joint.entry.facts.gear_ratio);
    if (!is_within(f.speed_rad_s, options)) continue;
    if (f.torque_Nm.value > 0 &&
        (f.verdict == calibration::Verdict::usable || options.doubtful_too)) {
      usable.push_back({f.speed_rad_s, f.torque_Nm.value, f.torque_Nm.low, f.torque_Nm.high});
    } else if (best_refused == nullptr || one.verdict < best_refused->verdict) {
      best_refused = &one;
    }
  }
  if (!usable.empty()) return usable;
  if (all.empty()) {
    why_not = "the calibration holds no friction at speeds";
  } else if (best_refused != nullptr) {
    why_not = "friction at the measured speeds is " + in_words(best_refused->verdict);
    if (!options.doubtful_too) why_not += hint;
  } else {
    const double n = joint.entry.facts.gear_ratio;
    why_not = fmt::format("no friction was measured within --range; measured were {} at the joint",
                          range_text(calibration::at_joint(all.front(), n).speed_rad_s,
                                     calibration::at_joint(all.back(), n).speed_rad_s));
  }
  return usable;
}

std::vector<SpeedFriction> needed_friction(const ArchivedJoint& joint,
                                           const SimulatorOptions& options) {
  refuse_amperes(joint);
  std::string why_not;
  const std::vector<SpeedFriction> friction = usable_friction(joint, options, why_not);
  if (friction.empty()) refuse_export(joint, why_not);
  return friction;
}

std::vector<SpeedFriction> a_few(const std::vector<SpeedFriction>& friction) {
  constexpr std::size_t most = 32;
  std::vector<double> speeds;
  for (const SpeedFriction& f : friction) speeds.push_back(f.speed_rad_s);
  std::vector<SpeedFriction> few;
  for (const std::size_t k : calibration::evenly_in_log(speeds, most)) few.push_back(friction[k]);
  return few;
}

std::string joined(const std::vector<SpeedFriction>& friction, double SpeedFriction::* member,
                   std::string (*text_of)(double)) {
  std::vector<std::string> numbers;
  for (const SpeedFriction& f : friction) numbers.push_back(text_of(f.*member));
  return fmt::format("{}", fmt::join(numbers, ", "));
}

namespace {

/// How far a law is off at most, and where.
struct LargestError {
  double error_Nm{-1};
  SpeedFriction at;
};

LargestError largest_error(const FrictionLine& line, const std::vector<SpeedFriction>& friction) {
  LargestError largest;
  for (const SpeedFriction& f : friction) {
    const double error_Nm = std::abs(line.torque_Nm(f.speed_rad_s) - f.torque_Nm);
    if (error_Nm > largest.error_Nm) largest = {error_Nm, f};
  }
  return largest;
}

/// The best line of this slope, dry friction not below zero.
FrictionLine of_slope(double viscous_Nms_rad, const std::vector<SpeedFriction>& friction) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const SpeedFriction& f : friction) {
    const double rest_Nm = f.torque_Nm - viscous_Nms_rad * f.speed_rad_s;
    low = std::min(low, rest_Nm);
    high = std::max(high, rest_Nm);
  }
  return {std::max(0.0, (low + high) / 2), viscous_Nms_rad};
}

std::string error_text(const LargestError& largest) {
  return fmt::format("{:.3g} N·m ({:.2g} %), at {:.4g} rad/s", largest.error_Nm,
                     100 * largest.error_Nm / largest.at.torque_Nm, largest.at.speed_rad_s);
}

}  // namespace

FrictionLine nearest_line(const std::vector<SpeedFriction>& friction) {
  double steepest = 0;
  for (const SpeedFriction& f : friction) {
    steepest = std::max(steepest, f.torque_Nm / f.speed_rad_s);
  }
  if (friction.size() < 2) return of_slope(0, friction);
  // The largest error of the best line of a slope is convex in the slope.
  constexpr int bits = 40;
  const auto error_Nm = [&](double slope) {
    return largest_error(of_slope(slope, friction), friction).error_Nm;
  };
  std::uintmax_t most_steps = 500;
  const auto [slope, error] =
      boost::math::tools::brent_find_minima(error_Nm, 0.0, steepest, bits, most_steps);
  return of_slope(error_Nm(0) <= error ? 0.0 : slope, friction);
}

DryAndViscous dry_and_viscous(const ArchivedJoint& joint, const SimulatorOptions& options,
                              const std::string& dry, const std::string& viscous) {
  refuse_amperes(joint);
  const double n = joint.entry.facts.gear_ratio;
  std::string no_coulomb;
  std::string no_viscous;
  const auto* const coulomb =
      if_usable(joint, joint::Quantity::coulomb_torque, options.doubtful_too, no_coulomb);
  const auto* const coefficient =
      if_usable(joint, joint::Quantity::viscous_coefficient, options.doubtful_too, no_viscous);
  const bool has_limits = coulomb != nullptr && coefficient != nullptr && !options.range_rad_s;
  std::string no_speeds;
  const std::vector<SpeedFriction> friction = usable_friction(joint, options, no_speeds);
  DryAndViscous out;
  if (has_limits) {
    static_cast<FrictionLine&>(out) = {calibration::at_joint(*coulomb, n).value,
                                       calibration::at_joint(*coefficient, n).value};
    out.comments = {viscous + ": " + estimate_line(*coefficient, n, joint::Side::joint),
                    dry + ": " + estimate_line(*coulomb, n, joint::Side::joint)};
  } else if (friction.empty()) {
    const std::string no_limits = no_coulomb.empty() ? no_viscous : no_coulomb;
    refuse_export(
        joint, no_limits.empty() || options.range_rad_s ? no_speeds : no_limits + "; " + no_speeds);
  } else {
    static_cast<FrictionLine&>(out) = nearest_line(friction);
    out.is_approximation = true;
    out.comments = {fmt::format(
        "{} and {} are an APPROXIMATION: of all such lines the one nearest to the friction "
        "identified at {} {}.",
        viscous, dry, friction.size(), friction.size() == 1 ? "speed" : "speeds")};
    if (!no_coulomb.empty() || !no_viscous.empty()) {
      out.comments.push_back("As limits of the friction the two are not known: " +
                             without_hint(no_coulomb.empty() ? no_viscous : no_coulomb) + ".");
    }
  }
  if (!friction.empty()) {
    out.comments.push_back(
        fmt::format("measured at the joint from {}; the largest error there is {}{}",
                    range_text(friction.front().speed_rad_s, friction.back().speed_rad_s),
                    error_text(largest_error(out, friction)),
                    options.range_rad_s ? "" : "; --range chooses other speeds"));
  }
  const RestTorque rest = rest_torque(joint, options, friction);
  out.static_Nm = std::max(out.dry_Nm, rest.torque_Nm);
  out.static_words = rest.words;
  return out;
}

RestTorque rest_torque(const ArchivedJoint& joint, const SimulatorOptions& options,
                       const std::vector<SpeedFriction>& friction) {
  std::string why_not;
  if (const auto* const break_away =
          if_usable(joint, joint::Quantity::break_away_torque, options.doubtful_too, why_not)) {
    return {calibration::at_joint(*break_away, joint.entry.facts.gear_ratio).value,
            "the break-away torque"};
  }
  return {friction.empty() ? 0 : friction.front().torque_Nm,
          "friction at the slowest measured speed, for the break-away torque is not usable: " +
              without_hint(why_not)};
}

double SteadyLuGre::torque_Nm(double speed_rad_s) const {
  const double share = speed_rad_s / stribeck_rad_s;
  return coulomb_Nm + (static_Nm - coulomb_Nm) * std::exp(-share * share) +
         viscous_Nms_rad * speed_rad_s;
}

namespace {

/// Least squares of the errors in percent, with that Stribeck velocity.
SteadyLuGre of_stribeck(double stribeck_rad_s, double static_Nm,
                        const std::vector<SpeedFriction>& friction) {
  double cc = 0, cv = 0, vv = 0, cr = 0, vr = 0;
  for (const SpeedFriction& f : friction) {
    const double share = f.speed_rad_s / stribeck_rad_s;
    const double dip = std::exp(-share * share);
    const double c = (1 - dip) / f.torque_Nm;
    const double v = f.speed_rad_s / f.torque_Nm;
    const double rest = 1 - static_Nm * dip / f.torque_Nm;
    cc += c * c, cv += c * v, vv += v * v, cr += c * rest, vr += v * rest;
  }
  const double determinant = cc * vv - cv * cv;
  double coulomb = cc > 0 ? cr / cc : static_Nm;
  double viscous = 0;
  if (determinant > 1e-12 * cc * vv) {
    const double both_coulomb = (cr * vv - vr * cv) / determinant;
    const double both_viscous = (vr * cc - cr * cv) / determinant;
    if (both_viscous > 0) coulomb = both_coulomb, viscous = both_viscous;
  }
  if (coulomb < 0 || coulomb > static_Nm) {
    coulomb = std::clamp(coulomb, 0.0, static_Nm);
    viscous = vv > 0 ? std::max(0.0, (vr - coulomb * cv) / vv) : 0;
  }
  return {coulomb, static_Nm, stribeck_rad_s, viscous};
}

}  // namespace

SteadyLuGre nearest_lugre(const std::vector<SpeedFriction>& friction, double static_Nm) {
  constexpr int steps = 1500;
  const double slowest = 0.1 * friction.front().speed_rad_s;
  const double fastest = 3 * friction.back().speed_rad_s;
  SteadyLuGre best;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    const SteadyLuGre law =
        of_stribeck(slowest * std::pow(fastest / slowest, share), static_Nm, friction);
    double largest = 0;
    for (const SpeedFriction& f : friction) {
      largest = std::max(largest, std::abs(law.torque_Nm(f.speed_rad_s) / f.torque_Nm - 1));
    }
    if (largest < least) least = largest, best = law;
  }
  return best;
}

std::string largest_error_words(const SteadyLuGre& law,
                                const std::vector<SpeedFriction>& friction) {
  LargestError largest;
  for (const SpeedFriction& f : friction) {
    const double error_Nm = std::abs(law.torque_Nm(f.speed_rad_s) - f.torque_Nm);
    if (largest.error_Nm * f.torque_Nm < error_Nm * largest.at.torque_Nm || largest.error_Nm < 0) {
      largest = {error_Nm, f};
    }
  }
  return error_text(largest);
}

std::string speeds_in_words(const std::vector<SpeedFriction>& friction) {
  return range_text(friction.front().speed_rad_s, friction.back().speed_rad_s);
}

Armature armature_of(const ArchivedJoint& joint, const SimulatorOptions& options) {
  std::string why_not;
  const calibration::Quantity* const inertia =
      if_usable(joint, joint::Quantity::inertia, options.doubtful_too, why_not);
  if (inertia == nullptr) return {{}, "armature is left out: " + why_not};
  const double n = joint.entry.facts.gear_ratio;
  const std::string found = estimate_line(*inertia, n, joint::Side::joint);
  if (!options.arm_inertia_kgm2) {
    return {{},
            "armature is left out: what was identified is of rotor, gear and arm together, and the "
            "arm's inertia is in the bodies of a model; --arm-inertia takes it off. " +
                found};
  }
  const statistics::Estimate all = calibration::at_joint(*inertia, n);
  const double arm_kgm2 = *options.arm_inertia_kgm2;
  if (!(all.low > arm_kgm2)) {
    return {{},
            fmt::format("armature is left out: the data do not show it beside the arm's stated "
                        "{:.6g} kg·m². {}",
                        arm_kgm2, found)};
  }
  return {
      all.value - arm_kgm2,
      fmt::format("armature: {:.6g} kg·m² (95 %: {:.6g} to {:.6g}), less the arm's stated "
                  "{:.6g} kg·m². {}",
                  all.value - arm_kgm2, all.low - arm_kgm2, all.high - arm_kgm2, arm_kgm2, found)};
}

std::string with_point(double number) {
  const std::string text = shortest(number);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

}  // namespace tribolog::exports::results
