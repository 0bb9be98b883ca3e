#include "ingest/dataset/known_load_rows.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "ingest/log/units.h"

namespace tribolog {
namespace {

const LogColumn& column_named(const LogTable& table, const std::string& name) {
  return *std::find_if(table.columns.begin(), table.columns.end(), [&](const LogColumn& c) {
    return c.header.name == name || c.header.full == name;
  });
}

}  // namespace

void add_load_columns(const std::vector<KnownLoad>& loads, Role role,
                      std::vector<WantedColumn>& wanted) {
  for (const KnownLoad& load : loads) {
    if (!load.loads(role)) continue;
    for (const std::string& name : load.angles) {
      const bool is_wanted =
          std::any_of(wanted.begin(), wanted.end(),
                      [&](const WantedColumn& column) { return column.name == name; });
      if (is_wanted) continue;
      wanted.push_back({name, fmt::format("the [[known_load]] of {} follows it; 'roles' there "
                                          "limits it to recordings that have the column",
                                          printable(load.stated_at))});
    }
  }
}

void refuse_unusable_load_columns(const std::vector<KnownLoad>& loads, Role role,
                                  const LogTable& table) {
  for (const KnownLoad& load : loads) {
    if (!load.loads(role)) continue;
    for (const std::string& name : load.angles) {
      const ColumnHeader& header = column_named(table, name).header;
      const auto factor = find_si_factor(Quantity::angle, header.unit);
      if (!factor || *factor == load.radian_per_unit) continue;
      throw InputError(
          {table.file, 1, 0},
          {"unit of the column contradicts the [[known_load]] of " + printable(load.stated_at),
           in_quotes(header.full), "the unit that is stated there", ""});
    }
  }
}

void subtract_known_loads(const LogTable& table, const std::vector<std::size_t>& rows,
                          double gear_ratio, std::vector<KnownLoad>& loads, Recording& recording) {
  for (KnownLoad& load : loads) {
    if (!load.loads(recording.role)) continue;
    std::vector<const std::vector<double>*> angles;
    for (const std::string& name : load.angles) {
      angles.push_back(&column_named(table, name).values);
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      double sum_rad = 0;
      for (const auto* angle : angles) sum_rad += (*angle)[rows[i]] * load.radian_per_unit;
      const double torque_Nm = load.torque_Nm(sum_rad);
      recording.torque_Nm[i] -= torque_Nm / gear_ratio;
      load.largest_Nm = std::max(load.largest_Nm, std::abs(torque_Nm));
    }
    load.samples += rows.size();
  }
}

}  // namespace tribolog
