#include "method/viscous/sliding_law.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "method/viscous/law_scan.h"
#include "method/viscous/speed_laws.h"
#include "method/viscous/speed_means.h"
#include "statistics/distributions.h"

namespace tribolog::method::viscous {
namespace {

constexpr std::size_t fewest_speeds_of_law = 3;
constexpr double line_excluded = 0.01;   // chance at which the straight line is
constexpr double shape_excluded = 0.01;  // and d = 2, or a viscous term linear in speed
constexpr double shape_in_doubt = 0.05;  // at which one that is no straight line stays a rival
constexpr double bend_excluded = 0.001;  // and that there is a bend in place of a dip
constexpr double least_scale = 0.5;      // of the errors as stated

/// Range of a parameter over the laws that are not excluded.
struct Hull {
  double low{std::numeric_limits<double>::infinity()};
  double high{-std::numeric_limits<double>::infinity()};
  void add(const Hull& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
  void add(double value, double reach = 0) {
    low = std::min(low, value - reach);
    high = std::max(high, value + reach);
  }
  [[nodiscard]] bool any() const { return low <= high; }
  [[nodiscard]] statistics::Estimate about(double value) const {
    return {value, std::min(low, value), std::max(high, value), {"interval.sliding_law_profile"}};
  }
};

std::vector<double> exponents(int per_octave = 8) {
  std::vector<double> out;
  for (int k = -per_octave; k <= 2 * per_octave; ++k) {
    out.push_back(std::exp2(static_cast<double>(k) / per_octave));
  }
  return out;
}

std::vector<double> powers(int step = 1) {
  std::vector<double> out;
  for (int k = 4; k <= 48; k += step) out.push_back(k / 20.0);
  return out;
}

double chance_of_gain(double simple, double rich, double parameters, double freedom) {
  return statistics::f_upper_tail(((simple - rich) / parameters) / (rich / freedom), parameters,
                                  freedom);
}

struct Hulls {
  Hull coulomb, slope, speed, exponent;
};

/// @param limit chi2 up to which a law is not excluded.
void add_points(const std::vector<LawPoint>& points, double limit, Hulls& hulls) {
  for (const LawPoint& p : points) {
    if (!(p.chi2 <= limit)) continue;
    const double reach = std::sqrt(limit - p.chi2);
    hulls.coulomb.add(p.coulomb_Nm, reach * p.coulomb_error);
    hulls.slope.add(p.slope, reach * p.slope_error);
    if (!p.has_excess) continue;
    hulls.speed.add(p.speed_rad_s);
    hulls.exponent.add(p.exponent);
  }
}

/// Successively finer scans about the speeds ws that are not excluded, including that of `law`.
Hulls hulls_of(const SpeedLaws& laws, LawGrid grid, const LawPoint& law, double limit) {
  constexpr int rounds = 6;
  Hulls hulls;
  for (int k = 0; k < rounds; ++k) {
    const std::vector<LawPoint> points = laws.scan(grid);
    const LawPoint* best = best_of(points);
    if (best == nullptr) break;
    hulls = {};
    add_points({law}, limit, hulls);
    add_points(points, limit, hulls);
    // Between coarse speeds there may be better ones.
    Hull near;
    const double reached = std::max(limit, best->chi2 + (limit - law.chi2));
    for (const LawPoint& p : points) {
      if (p.chi2 <= reached) near.add(p.speed_rad_s);
    }
    const double step = std::pow(grid.fastest_speed / grid.slowest_speed,
                                 1.0 / static_cast<double>(speeds_tried - 1));
    const double low = std::max(grid.slowest_speed, near.low / step);
    const double high = std::min(grid.fastest_speed, near.high * step);
    constexpr double close = 0.6;
    if (std::log(high / low) > close * std::log(grid.fastest_speed / grid.slowest_speed)) break;
    grid.slowest_speed = low;
    grid.fastest_speed = high;
  }
  return hulls;
}

}  // namespace

void SlidingLaw::doubt(const Statement& why) {
  findings.insert(findings.begin(), why);
  for (SlidingQuantity* q : {&coulomb_Nm, &stribeck_speed_rad_s, &viscous_Nms_rad}) {
    if (q->estimate) q->why_not = why;
  }
}

double SlidingLaw::friction_Nm(double speed_rad_s) const {
  const double share = speed_rad_s / fastest_rad_s;
  double friction = level_Nm + rise_Nm * std::pow(share, viscous_exponent);
  if (has_dip) {
    friction += excess_Nm * std::exp(-std::pow(speed_rad_s / dip_rad_s, stribeck_exponent));
  }
  return friction;
}

namespace {

/// Whether the runs show the dip from both sides.
struct DipCover {
  std::size_t below{};   ///< Speeds at which more than 1/e of the excess is left.
  std::size_t beyond{};  ///< Speeds at which next to nothing of it is left.
};

DipCover cover_of(const std::vector<SpeedMean>& means, double dip_rad_s) {
  constexpr double gone = 2;  // times ws: exp(-4)
  DipCover out;
  for (const SpeedMean& m : means) {
    if (m.speed_rad_s <= dip_rad_s) ++out.below;
    if (m.speed_rad_s >= gone * dip_rad_s) ++out.beyond;
  }
  return out;
}

/// The laws that describe the speeds, and the one that is taken.
struct Choice {
  LawPoint law;
  bool has_dip{};
  double freedom{};
  double limit{};  ///< chi2 up to which a law is not excluded.
  /// A viscous term of another power than the law's describes the speeds better, if not surely.
  bool may_curve{};
  bool leaves_power{};  ///< The line's power was taken as it is, not because others are excluded.
};

void take_limit(Choice& choice) {
  // What the runs' own scatter and their rounding let expect is not talked down by a lucky fit.
  const double scale = std::max(least_scale, choice.law.chi2 / choice.freedom);
  choice.limit = choice.law.chi2 + scale * std::pow(statistics::student_t_975(choice.freedom), 2);
}

/// The simplest that is not excluded: line, d = 2, any d; then p = 1, any p.
Choice choose(SpeedLaws& laws, double direction_scatter) {
  const auto find_scatter = [&] {
    laws.find_scatter();
    laws.set_scatter2(std::max(laws.scatter2(), direction_scatter));
  };
  find_scatter();
  Choice out;
  out.law = laws.line();
  out.freedom = laws.freedom(line_parameters);
  const double freedom = laws.freedom(dip_parameters);
  if (laws.can_dip()) {
    const std::optional<LawPoint> gauss = laws.best_law(laws.whole_grid());
    out.has_dip = gauss && chance_of_gain(out.law.chi2, gauss->chi2, 2, freedom) < line_excluded;
    if (out.has_dip) {
      out.law = *gauss;
      out.freedom = freedom;
    }
  }
  const double left = out.freedom - 1;
  if (left < 2) {
    take_limit(out);
    return out;
  }
  // Another exponent, of the excess or of the viscous term, where the simple one is excluded.
  struct Rival {
    LawPoint law;
    double chance{1};
  };
  const auto rival = [&](const std::vector<double>& exponents_tried,
                         const std::vector<double>& powers_tried) {
    std::optional<LawPoint> best;
    if (out.has_dip) {
      LawGrid grid = laws.whole_grid();
      grid.exponents = exponents_tried;
      grid.powers = powers_tried;
      best = laws.best_law(grid);
    } else {
      const std::vector<LawPoint> lines = laws.possible_lines(powers_tried);
      if (const LawPoint* one = best_of(lines)) best = *one;
    }
    return best ? Rival{*best, chance_of_gain(out.law.chi2, best->chi2, 1, left)} : Rival{};
  };
  const Rival sharper = out.has_dip ? rival(exponents(), {1.0}) : Rival{};
  const Rival curved = rival({2.0}, powers());
  const Rival& better = sharper.chance < curved.chance ? sharper : curved;
  if (better.chance < shape_excluded) {
    out.law = better.law;
    out.freedom = left;
    laws.set_shape(out.law.exponent, out.law.power);
    find_scatter();
    out.law = out.has_dip ? laws.best() : laws.line(out.law.power);
  }
  out.leaves_power = out.law.power == 1;
  out.may_curve = out.leaves_power && curved.chance < shape_in_doubt;
  take_limit(out);
  return out;
}

/// Shapes about a curved law, ever closer until some besides it are not excluded: on a coarse grid
/// there may be none.
void add_shapes_nearby(const SpeedLaws& laws, const Choice& choice, Hulls& hulls) {
  double exponent_step = 1.0 / 4;  // octaves
  double power_step = 0.05;
  constexpr int rounds = 5;
  for (int k = 0; k < rounds; ++k) {
    LawGrid grid = laws.whole_grid();
    grid.exponents.clear();
    grid.powers.clear();
    for (int j = -2; j <= 2; ++j) {
      if (choice.law.has_excess || j == 0) {
        grid.exponents.push_back(choice.law.exponent * std::exp2(j * exponent_step));
      }
      grid.powers.push_back(std::max(0.05, choice.law.power + j * power_step));
    }
    Hulls near = hulls;
    Hull power;
    if (choice.law.has_excess) {
      constexpr double reach = 3;
      grid.slowest_speed = std::max(grid.slowest_speed, choice.law.speed_rad_s / reach);
      grid.fastest_speed = std::min(grid.fastest_speed, choice.law.speed_rad_s * reach);
      const std::vector<LawPoint> points = laws.scan(grid);
      add_points(points, choice.limit, near);
      for (const LawPoint& point : points) {
        if (point.chi2 <= choice.limit) power.add(point.power);
      }
    } else {
      const std::vector<LawPoint> lines = laws.possible_lines(grid.powers);
      add_points(lines, choice.limit, near);
      for (const LawPoint& line : lines) {
        if (line.chi2 <= choice.limit) power.add(line.power);
      }
    }
    hulls = near;
    if (power.any() && power.high > power.low) return;
    exponent_step /= 3;
    power_step /= 3;
  }
}

/// A rival law of a curve that is not a straight line: linear plus quadratic in speed. Adds its
/// values that are not excluded, if it describes the speeds about as well.
void add_quadratic_rival(const SpeedLaws& laws, const Choice& choice, Hulls& hulls) {
  std::vector<SpeedMean> means = laws.means();
  for (SpeedMean& m : means) m.load = std::pow(m.speed_rad_s / laws.fastest(), 2);
  SpeedLaws quadratic(std::move(means), true);
  quadratic.set_scatter2(laws.scatter2());
  LawPoint law = quadratic.line();
  if (choice.has_dip && quadratic.can_dip()) {
    const std::optional<LawPoint> dip = quadratic.best_law(quadratic.whole_grid());
    if (dip && dip->chi2 < law.chi2) law = *dip;
  }
  if (!(law.chi2 <= choice.limit)) return;
  const double limit = law.chi2 + (choice.limit - choice.law.chi2);
  if (law.has_excess) {
    LawGrid grid = quadratic.whole_grid();
    grid.exponents = exponents(2);
    const Hulls of_rival = hulls_of(quadratic, grid, law, limit);
    hulls.coulomb.add(of_rival.coulomb.low);
    hulls.coulomb.add(of_rival.coulomb.high);
    if (of_rival.speed.any()) {
      hulls.speed.add(of_rival.speed.low);
      hulls.speed.add(of_rival.speed.high);
    }
    return;
  }
  hulls.coulomb.add(law.coulomb_Nm, std::sqrt(limit - law.chi2) * law.coulomb_error);
}

/// Laws with a viscous term of another power, which the speeds do not exclude. Their slopes
/// only where the speeds speak for one: else the slope meant is that of the straight line.
void add_other_powers(const SpeedLaws& laws, const Choice& choice, LawGrid grid, Hulls& hulls) {
  grid.exponents = exponents(2);
  grid.powers = powers(2);
  Hulls others;
  if (laws.can_dip() && grid.slowest_speed < grid.fastest_speed) {
    others = hulls_of(laws, grid, choice.law, choice.limit);
  }
  add_points(laws.possible_lines(grid.powers), choice.limit, others);
  hulls.coulomb.add(others.coulomb);
  hulls.speed.add(others.speed);
  if (choice.may_curve) hulls.slope.add(others.slope);
}

Hulls hulls_about(const SpeedLaws& laws, const Choice& choice, bool with_rival) {
  LawGrid grid = laws.whole_grid();
  grid.exponents = exponents();
  const bool is_curved = choice.law.power != 1;
  if (is_curved) {
    // Exponents and powers against each other: each on a coarser grid.
    grid.exponents = exponents(2);
    grid.powers = powers(2);
  }
  // Where no dip shows, friction that falls over the whole range just as a straight line would
  // have it is no rival: that takes an accident.
  constexpr double farthest_hidden = 1.0 / 3;
  if (!choice.has_dip) grid.fastest_speed = farthest_hidden * laws.fastest();
  Hulls hulls;
  if (laws.can_dip() && grid.slowest_speed < grid.fastest_speed)
    hulls = hulls_of(laws, grid, choice.law, choice.limit);
  const bool is_of_any_power = choice.leaves_power && (choice.has_dip || choice.may_curve);
  if (is_of_any_power) add_other_powers(laws, choice, grid, hulls);
  add_points(laws.possible_lines(grid.powers), choice.limit, hulls);
  add_points({choice.law}, choice.limit, hulls);
  if (is_curved) {
    add_shapes_nearby(laws, choice, hulls);
    if (with_rival) add_quadratic_rival(laws, choice, hulls);
  }
  return hulls;
}

/// The power of a viscous term that describes the speeds about as well without a dip: what bends
/// the curve is then not known to be one.
std::optional<double> bend_instead_of_dip(const SpeedLaws& laws, const Choice& choice) {
  if (!choice.has_dip) return std::nullopt;
  std::optional<LawPoint> best;
  for (const LawPoint& bent : laws.possible_lines(powers())) {
    const bool is_excluded =
        chance_of_gain(bent.chi2, choice.law.chi2, 2, choice.freedom) < bend_excluded;
    if (bent.coulomb_Nm < 0 || is_excluded) continue;
    if (!best || bent.chi2 < best->chi2) best = bent;
  }
  if (!best) return std::nullopt;
  return best->power;
}

/// Speeds below and beyond the dip that show the law on both sides.
constexpr std::size_t enough_of_dip = 3;

void add_findings(const SpeedLaws& laws, SlidingLaw& law) {
  if (!law.left_out.empty()) {
    double farthest = 0;
    double its_speed = 0;
    for (const StrayFriction& s : law.left_out) {
      if (std::abs(s.off_Nm) <= std::abs(farthest)) continue;
      farthest = s.off_Nm;
      its_speed = s.speed_rad_s;
    }
    law.findings.push_back({"cause.outliers_of_speeds",
                            {{"speeds", law.left_out.size()},
                             {"all", law.left_out.size() + law.speeds},
                             {"speed_rad_s", its_speed},
                             {"off_Nm", farthest}}});
  }
  if (!law.has_dip) {
    law.findings.push_back({"cause.stribeck_not_shown", {{"slowest_rad_s", laws.slowest()}}});
    return;
  }
  const DipCover cover = cover_of(laws.means(), law.dip_rad_s);
  if (cover.below < enough_of_dip || cover.beyond < enough_of_dip) {
    law.findings.push_back({"cause.stribeck_at_the_edge",
                            {{"stribeck_rad_s", law.dip_rad_s},
                             {"below", cover.below},
                             {"beyond", cover.beyond},
                             {"needed", enough_of_dip}}});
  }
}

double residual_of(const SlidingLaw& law, const std::vector<SpeedMean>& means, double load_Nm) {
  double squares = 0;
  for (const SpeedMean& m : means) {
    squares += std::pow(m.friction_Nm - law.friction_Nm(m.speed_rad_s) - load_Nm * m.load, 2);
  }
  return std::sqrt(squares / static_cast<double>(means.size()));
}

}  // namespace

SlidingLaw fit_sliding_law(const std::vector<CurveSample>& samples, const CurveModel& terms) {
  SlidingLaw out;
  if (group_count(samples) < fewest_speeds_of_law) return out;
  std::vector<FrictionAtSpeed> speeds = speeds_of(samples, terms);
  out.left_out = without_strays(speeds, terms.load);
  SpeedLaws laws(means_of(speeds), terms.load);
  const bool can_fit = laws.largest() > 0 && laws.freedom(line_parameters) >= 1;
  if (!can_fit || !std::isfinite(laws.line().chi2)) return out;
  laws.find_scatter();
  const double direction_scatter = direction_scatter2(speeds, laws.scatter2(), laws.best_freedom());
  const Choice choice = choose(laws, direction_scatter);
  const Hulls hulls = hulls_about(laws, choice, !terms.load);

  out.fitted = true;
  out.speeds = speeds.size();
  out.has_dip = choice.has_dip;
  out.scatter_Nm = std::sqrt(laws.scatter2());
  out.level_Nm = choice.law.coulomb_Nm;
  out.excess_Nm = choice.law.excess_Nm;
  out.dip_rad_s = choice.law.speed_rad_s;
  out.fastest_rad_s = laws.fastest();
  out.rise_Nm = choice.law.slope * laws.fastest() / choice.law.power;
  out.stribeck_exponent = choice.law.exponent;
  out.viscous_exponent = choice.law.power;
  if (hulls.exponent.any()) {
    out.lowest_exponent = hulls.exponent.low;
    out.highest_exponent = hulls.exponent.high;
  }
  out.freedom = choice.freedom;
  out.residual_Nm = residual_of(out, laws.means(), choice.law.load_Nm);
  out.coulomb_Nm.estimate = hulls.coulomb.about(choice.law.coulomb_Nm);
  out.viscous_Nms_rad.estimate = hulls.slope.about(choice.law.slope);
  add_findings(laws, out);
  out.direction_scatter_Nm = std::sqrt(direction_scatter);
  if (out.has_dip) {
    out.stribeck_speed_rad_s.estimate = hulls.speed.about(choice.law.speed_rad_s);
  } else {
    out.stribeck_speed_rad_s.why_not = out.findings.back();
  }
  if (const std::optional<double> power = bend_instead_of_dip(laws, choice)) {
    out.stribeck_speed_rad_s.why_not = {"cause.viscous_bend_or_dip", {{"exponent", *power}}};
    out.findings.push_back(out.stribeck_speed_rad_s.why_not);
  }
  // A speed within the dip that was left out may be the one that tells of it.
  const DipCover cover = cover_of(laws.means(), out.dip_rad_s);
  const bool left_out_in_dip =
      std::any_of(out.left_out.begin(), out.left_out.end(),
                  [&](const StrayFriction& s) { return s.speed_rad_s < out.dip_rad_s; });
  if (out.has_dip && left_out_in_dip && cover.below < enough_of_dip) {
    out.stribeck_speed_rad_s.why_not = {"cause.stray_within_dip", {{"below", cover.below}}};
    out.findings.push_back(out.stribeck_speed_rad_s.why_not);
  }
  if (out.viscous_exponent != 1) {
    out.viscous_Nms_rad.why_not = {"curve_model.viscous_not_linear",
                                   {{"exponent", out.viscous_exponent}}};
    out.findings.push_back(out.viscous_Nms_rad.why_not);
  }
  // A line through few speeds may lie within the dip, and none could tell.
  constexpr std::size_t speeds_without_a_dip = 8;
  if (!out.has_dip && out.speeds < speeds_without_a_dip) {
    out.doubt({"cause.too_few_speeds_for_a_dip",
               {{"speeds", out.speeds}, {"needed", speeds_without_a_dip}}});
  }
  // One that falls as slowly as any that is tried reaches to the fastest speeds: what of friction
  // is the dip's, and what Coulomb's and viscous, hangs on the law's form alone.
  if (out.has_dip && out.stribeck_exponent <= exponents().front()) {
    out.doubt({"cause.dip_without_end", {{"exponent", out.stribeck_exponent}}});
  }
  // The mean of the directions is friction only where both tell of the same.
  constexpr double matters = 0.005;
  if (out.direction_scatter_Nm > matters * std::abs(out.level_Nm)) {
    const Statement disagree{"cause.outliers_between_directions",
                             {{"scatter_Nm", out.direction_scatter_Nm},
                              {"percent", 100 * out.direction_scatter_Nm / out.level_Nm}}};
    out.doubt(disagree);
  }
  return out;
}

}  // namespace tribolog::method::viscous
