#include "method/checks/torque_ceiling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "statistics/sampled_signal.h"

namespace tribolog::method::checks {
namespace {

constexpr std::size_t blocks_per_run = 20;
constexpr std::size_t fewest_per_block = 5;
constexpr std::size_t fewest_on_ceiling = 3;
constexpr double same = 4;        // standard errors
constexpr double different = 10;  // the same
constexpr double far_apart = 5;   // times the spread of those on the ceiling
constexpr double same_speed = 0.01;
constexpr double least_share = 0.15;   // of the speeds: among many a few lie together by chance
constexpr double least_overlap = 0.5;  // of the angles of the two directions

/// The torque of one plateau at its largest and at its smallest.
struct Extent {
  double speed_rad_s{};  ///< Signed.
  double largest_Nm{-std::numeric_limits<double>::infinity()};
  double smallest_Nm{std::numeric_limits<double>::infinity()};
  double error_Nm{};  ///< Of a block's mean, from the white noise.
  double low_rad{}, high_rad{};
};

bool share_their_angles(const Extent& a, const Extent& b) {
  const double common = std::min(a.high_rad, b.high_rad) - std::max(a.low_rad, b.low_rad);
  return common > least_overlap * std::max(a.high_rad - a.low_rad, b.high_rad - b.low_rad);
}

Extent extent_of(const joint::Recording& r, const motion::Plateau& plateau) {
  const std::size_t block = std::max(fewest_per_block, plateau.size() / blocks_per_run);
  const auto begin = r.torque_Nm.begin() + static_cast<std::ptrdiff_t>(plateau.first);
  const std::vector<double> torque(begin, begin + static_cast<std::ptrdiff_t>(plateau.size()));
  Extent out;
  out.speed_rad_s = plateau.speed_rad_s;
  out.low_rad = std::min(r.q_rad[plateau.first], r.q_rad[plateau.last - 1]);
  out.high_rad = std::max(r.q_rad[plateau.first], r.q_rad[plateau.last - 1]);
  out.error_Nm = statistics::white_sd_beside_jumps(statistics::third_differences(torque)) /
                 std::sqrt(static_cast<double>(block));
  for (std::size_t from = 0; from + block <= torque.size(); from += block) {
    double mean = 0;
    for (std::size_t i = from; i < from + block; ++i) mean += torque[i];
    mean /= static_cast<double>(block);
    out.largest_Nm = std::max(out.largest_Nm, mean);
    out.smallest_Nm = std::min(out.smallest_Nm, mean);
  }
  return out;
}

/// Largest torque at a speed, and that of the other direction.
struct AtSpeed {
  double torque_Nm{};
  double other_Nm{};
  double error_Nm{};
};

/// @param sign of the torque that may be limited; the largest torque is taken in this sense.
std::vector<AtSpeed> pairs_of(const std::vector<Extent>& extents, double sign) {
  const auto largest = [&](const Extent& e) { return sign > 0 ? e.largest_Nm : -e.smallest_Nm; };
  std::vector<AtSpeed> pairs;
  std::vector<bool> taken(extents.size());
  for (std::size_t i = 0; i < extents.size(); ++i) {
    if (taken[i]) continue;
    for (std::size_t k = i + 1; k < extents.size(); ++k) {
      const double apart = std::abs(extents[i].speed_rad_s + extents[k].speed_rad_s);
      if (taken[k] || apart > same_speed * std::abs(extents[i].speed_rad_s) ||
          !share_their_angles(extents[i], extents[k])) {
        continue;
      }
      taken[k] = true;
      const bool is_first = largest(extents[i]) > largest(extents[k]);
      const Extent& a = is_first ? extents[i] : extents[k];
      const Extent& b = is_first ? extents[k] : extents[i];
      pairs.push_back({largest(a), largest(b), std::max(a.error_Nm, b.error_Nm)});
      break;
    }
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const AtSpeed& a, const AtSpeed& b) { return a.torque_Nm > b.torque_Nm; });
  return pairs;
}

}  // namespace

TorqueCeiling torque_ceiling(const std::vector<CheckedRecording>& recordings) {
  std::vector<Extent> extents;
  for (const CheckedRecording& r : recordings) {
    if (r.recording->role != joint::Role::constant_speed || r.recording->torque_Nm.empty())
      continue;
    for (const motion::Plateau& plateau : r.motion.plateaus) {
      if (plateau.size() >= 4 * fewest_per_block)
        extents.push_back(extent_of(*r.recording, plateau));
    }
  }
  for (const double sign : {1.0, -1.0}) {
    const std::vector<AtSpeed> pairs = pairs_of(extents, sign);
    if (pairs.size() < fewest_on_ceiling || !(pairs.front().torque_Nm > 0)) continue;
    std::size_t count = 0;
    double lowest = INFINITY;
    double highest = -INFINITY;
    double largest_error = 0;
    for (const AtSpeed& at : pairs) {
      const double error = std::hypot(at.error_Nm, pairs.front().error_Nm);
      if (pairs.front().torque_Nm - at.torque_Nm > same * error) break;
      lowest = std::min(lowest, at.other_Nm);
      highest = std::max(highest, at.other_Nm);
      largest_error = std::max(largest_error, at.error_Nm);
      ++count;
    }
    const double needed = least_share * static_cast<double>(pairs.size());
    if (count < fewest_on_ceiling || static_cast<double>(count) < needed) continue;
    const double spread = pairs.front().torque_Nm - pairs[count - 1].torque_Nm;
    if (highest - lowest > std::max(different * largest_error, far_apart * spread)) {
      return {count, sign * pairs.front().torque_Nm};
    }
  }
  return {};
}

}  // namespace tribolog::method::checks
