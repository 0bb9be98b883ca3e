#include "ingest/manifest/limit_tables.h"

#include <string>

#include <fmt/format.h>

namespace tribolog {

std::vector<AcceptanceLimit> read_limits(const TomlTable& manifest) {
  std::vector<std::string> keys;
  for (const LimitedQuantity& quantity : limited_quantities()) keys.push_back(quantity.key);
  std::vector<AcceptanceLimit> limits;
  for (const TomlTable& table : manifest.tables("limit")) {
    AcceptanceLimit limit;
    limit.quantity = keys[table.choice("quantity", keys)];
    limit.min = table.find_number("min");
    limit.max = table.find_number("max");
    limit.half_width = table.find_number("half_width", Sign::positive);
    limit.half_width_percent = table.find_number("half_width_percent", Sign::positive);
    table.refuse_unknown_keys();
    if (!limit.min && !limit.max && !limit.half_width && !limit.half_width_percent) {
      table.refuse("quantity", {"the limit states no number", "",
                                "one or more of max, min, half_width, half_width_percent", ""});
    }
    if (limit.min && limit.max && *limit.min > *limit.max) {
      table.refuse("min", {"nothing is allowed between min and max",
                           fmt::format("{}..{}", *limit.min, *limit.max), "min <= max", ""});
    }
    limits.push_back(std::move(limit));
  }
  return limits;
}

}  // namespace tribolog
