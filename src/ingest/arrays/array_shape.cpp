#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "ingest/arrays/array_tables.h"

namespace tribolog::ingest::arrays {

bool shape_array(const std::vector<std::uint64_t>& dimensions, NamedArray& array,
                 FileArrays& found) {
  std::vector<std::uint64_t> sides;
  std::string stated;
  std::uint64_t count = 1;
  for (const std::uint64_t side : dimensions) {
    stated += (stated.empty() ? "" : " x ") + std::to_string(side);
    if (side == 0) {
      found.leave_out(array.name, "it is empty");
      return false;
    }
    count = count > most_values / side ? most_values + 1 : count * side;
    if (side != 1) sides.push_back(side);
  }
  if (count > most_values - std::min(found.values, most_values)) {
    found.leave_out(array.name, stated + " numbers are more than 2^31 in one file");
    return false;
  }
  if (sides.size() > 2) {
    found.leave_out(array.name, "it has more than two dimensions: " + stated);
    return false;
  }
  if (sides.size() == 2 && std::min(sides[0], sides[1]) > most_matrix_columns) {
    found.leave_out(array.name, stated + " is no table of samples");
    return false;
  }
  found.values += count;
  array.rows = sides.empty() ? 1 : static_cast<std::size_t>(sides[0]);
  array.columns = sides.size() < 2 ? 1 : static_cast<std::size_t>(sides[1]);
  return true;
}

}  // namespace tribolog::ingest::arrays
