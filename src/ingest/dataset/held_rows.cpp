#include "ingest/dataset/held_rows.h"

#include <algorithm>

namespace tribolog::ingest::dataset {

std::optional<HeldRows> find_held_rows(const std::vector<std::size_t>& rows,
                                       const std::vector<const std::vector<double>*>& signals) {
  constexpr std::size_t fewest_changes = 50;
  constexpr double together = 0.8;  // of the changes: those of all signals
  constexpr double regular = 0.8;   // of the distances: about the median
  if (signals.size() < 2) return std::nullopt;
  std::vector<std::size_t> changes;  // places in rows
  std::size_t of_all = 0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const auto changed = static_cast<std::size_t>(
        std::count_if(signals.begin(), signals.end(), [&](const std::vector<double>* signal) {
          return (*signal)[rows[k]] != (*signal)[rows[k - 1]];
        }));
    if (changed == 0) continue;
    changes.push_back(k);
    of_all += changed == signals.size() ? 1 : 0;
  }
  if (changes.size() < fewest_changes ||
      static_cast<double>(of_all) < together * static_cast<double>(changes.size())) {
    return std::nullopt;
  }
  std::vector<std::size_t> apart;
  for (std::size_t k = 1; k < changes.size(); ++k) apart.push_back(changes[k] - changes[k - 1]);
  std::vector<std::size_t> sorted = apart;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  const std::size_t usual = sorted[sorted.size() / 2];
  const auto near = std::count_if(apart.begin(), apart.end(), [&](std::size_t n) {
    return n + usual / 3 >= usual && n <= usual + usual / 3;
  });
  if (usual < 2 || static_cast<double>(near) < regular * static_cast<double>(apart.size())) {
    return std::nullopt;
  }
  // Where all stands still, a row for each sample too.
  HeldRows held{{rows.front()}, usual};
  std::size_t last = 0;
  auto next = changes.begin();
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const bool is_change = next != changes.end() && *next == k;
    if (is_change) ++next;
    const bool is_close_to_one = next != changes.end() && *next - k < usual;
    if (!is_change && (k - last < usual || is_close_to_one)) continue;
    held.kept.push_back(rows[k]);
    last = k;
  }
  return held;
}

}  // namespace tribolog::ingest::dataset
