#include "ingest/log/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "base/closest_match.h"
#include "base/enum_text.h"
#include "joint/degrees.h"

namespace tribolog::ingest::log {
namespace {

using std::numbers::pi;

struct Unit {
  std::string_view name;  ///< In small letters, without blanks and signs of multiplication.
  double si_factor;
  std::string_view shown{};  ///< As it is listed in messages; empty: another spelling of one.
  bool takes_prefix{};       ///< "ms", "kiloampere".
};

constexpr double kilogram_force_m = 9.80665;
constexpr double pound_force_ft = 1.3558179483314004;

constexpr std::array times = {Unit{"s", 1, "s", true},
                              Unit{"sec", 1, "", true},
                              Unit{"secs", 1, "", true},
                              Unit{"second", 1, "", true},
                              Unit{"seconds", 1, "", true},
                              Unit{"sek", 1, "", true},
                              Unit{"sekunden", 1, "", true},
                              Unit{"ms", 1e-3, "ms"},
                              Unit{"us", 1e-6, "us"},
                              Unit{"ns", 1e-9, "ns"},
                              Unit{"min", 60},
                              Unit{"mins", 60},
                              Unit{"minute", 60},
                              Unit{"minutes", 60},
                              Unit{"minuten", 60},
                              Unit{"h", 3600},
                              Unit{"hour", 3600},
                              Unit{"hours", 3600},
                              Unit{"d", 86400},
                              Unit{"day", 86400},
                              Unit{"days", 86400},
                              Unit{"100ns", 1e-7} /* as Windows counts */};
constexpr std::array angles = {Unit{"rad", 1, "rad", true},
                               Unit{"rads", 1, "", true},
                               Unit{"radian", 1, "", true},
                               Unit{"radians", 1, "", true},
                               Unit{"mrad", 1e-3, "mrad"},
                               Unit{"deg", joint::rad_per_degree, "deg", true},
                               Unit{"degs", joint::rad_per_degree},
                               Unit{"degree", joint::rad_per_degree, "", true},
                               Unit{"degrees", joint::rad_per_degree, "", true},
                               Unit{"°", joint::rad_per_degree},
                               Unit{"º", joint::rad_per_degree} /* the ordinal sign */,
                               Unit{"grad", joint::rad_per_degree} /* German; gon is another */,
                               Unit{"stopnie", joint::rad_per_degree} /* Polish */,
                               Unit{"turn", 2 * pi, "turn", true},
                               Unit{"turns", 2 * pi},
                               Unit{"rev", 2 * pi},
                               Unit{"revs", 2 * pi},
                               Unit{"revolution", 2 * pi},
                               Unit{"revolutions", 2 * pi},
                               Unit{"rotations", 2 * pi},
                               Unit{"u", 2 * pi} /* Umdrehungen */,
                               Unit{"tr", 2 * pi} /* tours */,
                               Unit{"obr", 2 * pi} /* obroty */};
/// Beside these any angle over a time.
constexpr std::array angular_speeds = {Unit{"rad/s", 1, "rad/s"},
                                       Unit{"mrad/s", 1e-3, "mrad/s"},
                                       Unit{"deg/s", joint::rad_per_degree, "deg/s"},
                                       Unit{"dps", joint::rad_per_degree},
                                       Unit{"rpm", 2 * pi / 60, "rpm", true},
                                       Unit{"rps", 2 * pi},
                                       Unit{"turn/s", 2 * pi, "turn/s"},
                                       Unit{"hz", 2 * pi} /* turns a second */,
                                       Unit{"1/s", 1},
                                       Unit{"1/min", 2 * pi / 60}};
constexpr std::array torques = {Unit{"nm", 1, "Nm", true},
                                Unit{"newtonmeter", 1, "", true},
                                Unit{"newtonmeters", 1, "", true},
                                Unit{"newtonmetre", 1, "", true},
                                Unit{"newtonmetres", 1, "", true},
                                Unit{"mnm", 1e-3, "mNm"},
                                Unit{"knm", 1e3, "kNm"},
                                Unit{"ncm", 1e-2},
                                Unit{"nmm", 1e-3},
                                Unit{"kgm", kilogram_force_m},
                                Unit{"kgfm", kilogram_force_m},
                                Unit{"kgcm", kilogram_force_m / 100},
                                Unit{"kgfcm", kilogram_force_m / 100},
                                Unit{"gcm", kilogram_force_m / 1e5},
                                Unit{"gfcm", kilogram_force_m / 1e5},
                                Unit{"lbft", pound_force_ft},
                                Unit{"lbfft", pound_force_ft},
                                Unit{"ftlb", pound_force_ft},
                                Unit{"ftlbf", pound_force_ft},
                                Unit{"lbin", pound_force_ft / 12},
                                Unit{"lbfin", pound_force_ft / 12},
                                Unit{"inlb", pound_force_ft / 12},
                                Unit{"inlbf", pound_force_ft / 12},
                                Unit{"ozin", pound_force_ft / 192},
                                Unit{"ozfin", pound_force_ft / 192},
                                Unit{"inoz", pound_force_ft / 192}};
constexpr std::array currents = {Unit{"a", 1, "A", true},     Unit{"ma", 1e-3, "mA"},
                                 Unit{"amp", 1, "", true},    Unit{"amps", 1, "", true},
                                 Unit{"ampere", 1, "", true}, Unit{"amperes", 1, "", true},
                                 Unit{"arms", 1, "", true},   Unit{"aeff", 1, "", true},
                                 Unit{"apk", 1, "", true},    Unit{"apeak", 1, "", true}};
constexpr std::array temperatures = {
    Unit{"degc", 1, "degC"}, Unit{"°c", 1},      Unit{"ºc", 1},      Unit{"c", 1},
    Unit{"celsius", 1},      Unit{"degreec", 1}, Unit{"degreesc", 1}};

std::span<const Unit> units_of(Quantity quantity) {
  constexpr std::array<std::span<const Unit>, EnumTexts<Quantity>::size> all{
      times, angles, angular_speeds, torques, currents, temperatures};
  return all.at(static_cast<std::size_t>(quantity));
}

/// In front of a unit: as words in any case, as a letter where its case leaves no other prefix.
struct Prefix {
  std::string_view name;
  double factor;
};
constexpr std::array prefixes = {Prefix{"milli", 1e-3},
                                 Prefix{"micro", 1e-6},
                                 Prefix{"nano", 1e-9},
                                 Prefix{"kilo", 1e3},
                                 Prefix{"k", 1e3},
                                 Prefix{"m", 1e-3},
                                 Prefix{"u", 1e-6},
                                 Prefix{"µ", 1e-6} /* micro sign */,
                                 Prefix{"μ", 1e-6} /* Greek mu */,
                                 Prefix{"n", 1e-9}};

/// Without blanks and what stands for a multiplication: '*', '.', '_', '·', '⋅' and the hyphen,
/// but for that of an exponent. "rad s^-1" becomes "rad/s".
std::string bare(std::string_view unit) {
  std::string result;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const std::string_view rest = unit.substr(i);
    constexpr std::array<std::string_view, 2> dots = {"·", "⋅"};
    const auto dot = std::find_if(dots.begin(), dots.end(),
                                  [&](std::string_view sign) { return rest.starts_with(sign); });
    if (dot != dots.end()) {
      i += dot->size() - 1;
    } else if (std::string_view(" \t*._^").find(rest[0]) == std::string_view::npos &&
               !(rest[0] == '-' && !rest.starts_with("-1"))) {
      result += rest[0];
    }
  }
  for (const std::string_view time : {"s", "sec", "min"}) {
    const std::string inverse = std::string(time) + "-1";
    if (!result.ends_with(inverse)) continue;
    result.resize(result.size() - inverse.size());
    return (result.empty() ? "1/" : result + "/") + std::string(time);
  }
  return result;
}

std::string in_small_letters(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

/// Of the units as they are listed: "MNm" is not "mNm".
bool has_other_prefix(const Unit& unit, std::string_view name) {
  const bool has_prefix = unit.name.starts_with("m") && unit.si_factor < 1;
  return has_prefix && name.starts_with("M");
}

/// "MNm" is no "mNm"; and "NA" or "n.a." is "not available", no nanoampere.
bool is_no_prefix(std::string_view prefix, std::string_view name) {
  if (prefix == "m") return name.front() == 'M';
  return prefix == "n" && (name.front() == 'N' || name == "na");
}

std::optional<double> factor_by_table(Quantity quantity, std::string_view name) {
  const std::string small = in_small_letters(std::string(name));
  for (const Unit& known : units_of(quantity)) {
    if (known.name == small && !has_other_prefix(known, name)) return known.si_factor;
  }
  for (const Prefix& prefix : prefixes) {
    if (!small.starts_with(prefix.name) || is_no_prefix(prefix.name, name)) continue;
    const std::string_view rest = std::string_view(small).substr(prefix.name.size());
    for (const Unit& known : units_of(quantity)) {
      if (known.takes_prefix && known.name == rest) return prefix.factor * known.si_factor;
    }
  }
  return std::nullopt;
}

/// @param name as bare() gives it.
std::optional<double> factor_of_one(Quantity quantity, std::string_view name) {
  if (const auto factor = factor_by_table(quantity, name)) return factor;
  if (quantity != Quantity::angular_speed) return std::nullopt;
  for (const std::string_view sign : {"/", "per"}) {
    const std::size_t at = name.find(sign);
    if (at == std::string_view::npos) continue;
    const auto angle = factor_by_table(Quantity::angle, name.substr(0, at));
    const auto time = factor_by_table(Quantity::time, name.substr(at + sign.size()));
    if (angle && time) return *angle / *time;
  }
  return std::nullopt;
}

/// "% of 1.27 Nm": the factor in front, and the rest of the unit.
std::optional<std::pair<double, std::string_view>> share_of(std::string_view unit) {
  constexpr std::array shares = {Prefix{"%", 1e-2},         Prefix{"percent", 1e-2},
                                 Prefix{"‰", 1e-3},         Prefix{"permille", 1e-3},
                                 Prefix{"per mille", 1e-3}, Prefix{"promille", 1e-3}};
  constexpr std::string_view of = " of ";
  const std::size_t at = unit.find(of);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string name = in_small_letters(std::string(unit.substr(0, at)));
  for (const Prefix& share : shares) {
    if (name == share.name) return std::pair(share.factor, unit.substr(at + of.size()));
  }
  return std::nullopt;
}

/// Of readings that are times already.
constexpr EnumTexts<ColumnReading> units_of_time("", "", "iso8601", "hh:mm:ss", "yyyy-mm-dd", "");

}  // namespace

std::string quantity_word(Quantity quantity) {
  return quantity == Quantity::angular_speed ? "speed" : own_name(quantity);
}

std::string to_string(Quantity quantity) {
  constexpr EnumTexts<Quantity> texts("a time", "an angle", "an angular speed", "a torque",
                                      "a current", "a temperature");
  return std::string(texts.of(quantity));
}

std::string_view unit_of_time(ColumnReading reading) { return units_of_time.of(reading); }

std::optional<ColumnReading> reading_of_time(std::string_view unit) {
  return unit.empty() ? std::nullopt : units_of_time.find(unit);
}

std::string_view example_of_multiple(Quantity quantity) {
  constexpr EnumTexts<Quantity> examples("60 s", "0.018 deg", "0.1 rpm", "0.0013 Nm", "0.002 A",
                                         "0.1 degC");
  return examples.of(quantity);
}

namespace {

std::optional<double> factor_of_multiple(Quantity quantity, std::string_view unit) {
  if (const auto factor = factor_of_one(quantity, bare(unit))) return factor;
  double multiple = 0;
  const char* const end = unit.data() + unit.size();
  const auto read = std::from_chars(unit.data(), end, multiple);
  constexpr double least = 1e-12;  // of an encoder's counts, say; far from where products vanish
  if (read.ec != std::errc() || !(multiple >= least && multiple <= 1 / least)) return std::nullopt;
  const auto factor = factor_of_one(quantity, bare({read.ptr, end}));
  return factor ? std::optional(multiple * *factor) : std::nullopt;
}

}  // namespace

std::optional<double> find_si_factor(Quantity quantity, std::string_view unit) {
  const auto share = share_of(unit);
  if (!share) return factor_of_multiple(quantity, unit);
  const auto whole = factor_of_multiple(quantity, share->second);
  return whole ? std::optional(share->first * *whole) : std::nullopt;
}

double si_factor(Quantity quantity, std::string_view unit, const Location& where) {
  if (const auto factor = find_si_factor(quantity, unit)) return *factor;
  std::string hint = did_you_mean(bare(unit), listed_units(quantity));
  if (hint.empty()) {
    hint =
        "a multiple of one will do, such as \"" + std::string(example_of_multiple(quantity)) + "\"";
  }
  throw InputError(where, {"unknown unit of " + to_string(quantity), in_quotes(unit),
                           "one of " + known_units(quantity), hint});
}

bool is_known_unit(std::string_view unit) {
  constexpr std::array all = {Quantity::time,   Quantity::angle,   Quantity::angular_speed,
                              Quantity::torque, Quantity::current, Quantity::temperature};
  const std::string name = bare(unit);
  // "a" and "S" may be any names.
  const bool is_letter = name.size() == 1 && (name[0] == 'a' || name[0] == 'S' || name[0] == 'c' ||
                                              name[0] == 'H' || name[0] == 'u' || name[0] == 'U');
  return !is_letter && std::any_of(all.begin(), all.end(), [&](Quantity quantity) {
    return factor_of_one(quantity, name).has_value();
  });
}

std::vector<std::string> listed_units(Quantity quantity) {
  std::vector<std::string> names;
  for (const Unit& unit : units_of(quantity)) {
    if (!unit.shown.empty()) names.emplace_back(unit.shown);
  }
  return names;
}

std::string known_units(Quantity quantity) {
  std::string list;
  for (const std::string& name : listed_units(quantity)) {
    if (!list.empty()) list += ", ";
    list += name;
  }
  return list;
}

}  // namespace tribolog::ingest::log
