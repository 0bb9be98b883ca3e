#include "ingest/manifest/known_load_tables.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "ingest/log/units.h"
#include "ingest/manifest/key_guard.h"
#include "joint/degrees.h"

namespace tribolog {
namespace {

constexpr Role all_roles[] = {Role::rough_sweep, Role::precise_sweep, Role::oscillation,
                              Role::constant_speed, Role::break_away};

std::vector<Role> read_roles(const TomlTable& table) {
  std::vector<Role> roles;
  if (!table.has("roles")) return roles;
  std::vector<std::string> known;
  for (const Role role : all_roles) known.push_back(to_string(role));
  for (const std::string& name : table.texts("roles")) {
    const auto at = std::find(known.begin(), known.end(), name);
    if (at == known.end()) {
      table.refuse("roles", {"no such role", in_quotes(name), "one of " + list_of_names(known),
                             did_you_mean(name, known)});
    }
    roles.push_back(all_roles[at - known.begin()]);
  }
  if (roles.empty()) {
    table.refuse("roles", {"is empty", "", "one or more roles", "leave it out for all of them"});
  }
  return roles;
}

KnownLoad read_known_load(const TomlTable& table) {
  const std::string hint = "the columns of the log whose sum the load follows";
  KnownLoad load;
  load.amplitude_Nm = table.number("amplitude_Nm");
  if (load.amplitude_Nm == 0) table.refuse("amplitude_Nm", {"not usable", "0", "not 0", ""});
  load.angles = table.texts("angles", hint);
  if (load.angles.empty()) table.refuse("angles", {"is empty", "", "one or more columns", hint});
  for (std::size_t i = 0; i < load.angles.size(); ++i) {
    const auto& name = load.angles[i];
    const auto begin = load.angles.begin();
    const bool is_twice = std::find(begin, begin + static_cast<std::ptrdiff_t>(i), name) !=
                          begin + static_cast<std::ptrdiff_t>(i);
    if (name.empty() || is_twice) {
      table.refuse("angles", {name.empty() ? "holds an empty name" : "names a column twice",
                              in_quotes(name), "columns of the log, each once", ""});
    }
  }
  load.radian_per_unit =
      si_factor(Quantity::angle, table.text_or("unit", "rad"), table.where("unit"));
  load.phase_rad = table.number_or("phase_deg", 0.0) * rad_per_degree;
  load.roles = read_roles(table);
  load.note = table.text_or("note", "");
  load.stated_at = fmt::format("{}:{}", table.where().file, table.where().line);
  table.refuse_unknown_keys();
  return load;
}

}  // namespace

std::vector<KnownLoad> read_known_loads(const TomlTable& top) {
  std::vector<KnownLoad> loads;
  for (const TomlTable& table : top.one_or_more_tables("known_load")) {
    loads.push_back(read_known_load(table));
  }
  return loads;
}

std::optional<StatedGravity> read_known_gravity(const TomlTable& top) {
  const auto table = top.find_table("known_gravity");
  if (!table) return std::nullopt;
  const double amplitude_Nm = table->number("amplitude_Nm", Sign::positive);
  const double q_peak_rad =
      table->number("q_peak_deg", Sign::any, "the joint angle at which gravity torque is largest") *
      rad_per_degree;
  table->refuse_unknown_keys();
  return guarded(*table, "amplitude_Nm", [&] { return StatedGravity(amplitude_Nm, q_peak_rad); });
}

}  // namespace tribolog
