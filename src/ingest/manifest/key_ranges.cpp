#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "ingest/manifest/toml_table.h"
#include "wording/words.h"

namespace tribolog::ingest::manifest {

namespace {

struct NamedRange {
  std::string_view name;  ///< All of a key, or its end.
  KeyRange range;
};

// The longer end stands before one that it ends with: "_rad_s2" before "_s2".
const NamedRange ranges[] = {
    // Pure numbers.
    {"gear_ratio", {1e-3, 1e6, ""}},
    {"cycles", {1e-3, 1e5, ""}},
    {"periods_per_turn", {1e-3, 1e4, ""}},
    {"encoder_counts_per_turn", {1, 1e12, ""}},
    {"exponent", {1e-3, 100, ""}},
    {"power", {1e-3, 100, ""}},
    {"half_width_percent", {1e-6, 1e6, "%"}},
    {"_percent", {1e-6, 1e6, "%"}},
    {"degC", {0, 1e4, "°C"}},
    // A thousand turns to either side; below a billionth of a radian nothing is measured.
    {"_deg_s2", {1e-6, 1e9, "deg/s²"}},
    {"_rad_s2", {1e-8, 2e7, "rad/s²"}},
    {"_deg_s", {1e-6, 1e8, "deg/s"}},
    {"stribeck_decay_s_rad", {1e-9, 1e9, "s/rad"}},
    {"_s_rad", {1e-9, 1e9, "s/rad"}},
    {"_Nms_rad", {1e-12, 1e9, "N·m·s/rad"}},
    {"_Nm_rad", {1e-6, 1e12, "N·m/rad"}},
    {"_rad_s", {1e-8, 1e6, "rad/s"}},
    {"_deg", {1e-7, 3.6e5, "deg"}},
    {"_rad", {1e-9, 6.3e3, "rad"}},
    // From a watch's gear to a wind turbine's.
    {"_Nm_A", {1e-6, 1e6, "N·m/A"}},
    {"_Nm_s", {1e-6, 1e9, "N·m/s"}},
    {"_Nm", {1e-9, 1e7, "N·m"}},
    {"_kgm2", {1e-12, 1e9, "kg·m²"}},
    {"_kg", {1e-6, 1e6, "kg"}},
    {"_m_s2", {1e-3, 1e3, "m/s²"}},
    {"_m", {1e-6, 1e3, "m"}},
    {"_Hz", {1e-4, 1e6, "Hz"}},
    {"_s", {1e-9, 1e10, "s"}},
};

const KeyRange pure_number{1e-12, 1e12, ""};

/// Where something is, when it was, or how warm: any distance from 0 has a meaning.
const std::string_view places[] = {
    "from_",    "to_",  "centre_",  "lowest_", "highest_", "q_peak_", "phase_", "portrait_",
    "held_at_", "degC", "offset_m", "bends_m", "flange_m", "axis",    "min",    "max"};

bool is_place(std::string_view key) {
  return std::any_of(std::begin(places), std::end(places), [&](std::string_view place) {
    return place.ends_with('_') ? key.starts_with(place) : key == place;
  });
}

}  // namespace

void refuse_with_words(const TomlTable& table, const std::string& key,
                       const std::invalid_argument& error) {
  table.refuse(key, {wording::words(error), "", "", ""});
}

bool KeyRange::holds(double value) const {
  return value == 0 || (std::abs(value) >= smallest && std::abs(value) <= largest);
}

std::string KeyRange::in_words() const {
  const std::string up_to = fmt::format("{:g}{}{}", largest, unit.empty() ? "" : " ", unit);
  return smallest > 0 ? fmt::format("{:g} to {}", smallest, up_to) : "at most " + up_to;
}

KeyRange range_of_key(std::string_view key) {
  for (const NamedRange& one : ranges) {
    if (!key.ends_with(one.name)) continue;
    KeyRange range = one.range;
    if (is_place(key)) range.smallest = 0;
    return range;
  }
  return is_place(key) ? KeyRange{0, pure_number.largest, ""} : pure_number;
}

}  // namespace tribolog::ingest::manifest
