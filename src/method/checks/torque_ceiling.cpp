#include "method/checks/torque_ceiling.h"

#include <algorithm>
#include <cmath>

#include "method/motion/plateaus.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::checks {
namespace {

constexpr std::size_t blocks_per_run = 20;
constexpr std::size_t fewest_per_block = 5;
constexpr std::size_t fewest_on_ceiling = 3;
constexpr double same = 4;             // standard errors
constexpr double different = 10;       // the same
constexpr double far_apart = 5;        // times the spread of those on the ceiling
constexpr double least_share = 0.15;   // of the speeds: among many a few lie together by chance
constexpr double least_overlap = 0.5;  // of the angles of the two directions
// Of a run that is cut off, as long as it stays at the ceiling; the top of a sine over a whole
// period, within a tenth of its amplitude, is a seventh.
constexpr double least_stay = 1.0 / 3;

/// The torque of one plateau, as means over blocks.
struct Extent {
  double speed_rad_s{};  ///< Signed.
  std::vector<double> blocks_Nm;
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
    out.blocks_Nm.push_back(mean / static_cast<double>(block));
  }
  return out;
}

/// Largest torque at a speed, and that of the other direction.
struct AtSpeed {
  double torque_Nm{};
  double other_Nm{};
  double error_Nm{};
  bool stays{};  ///< At its largest torque for long, not for a moment.
};

/// In the sense of the sign.
double largest_of(const Extent& e, double sign) {
  double largest = -INFINITY;
  for (const double torque : e.blocks_Nm) largest = std::max(largest, sign * torque);
  return largest;
}

bool stays_at_largest(const Extent& e, double sign) {
  const double lowest = largest_of(e, sign) - same * e.error_Nm;
  const auto there = std::count_if(e.blocks_Nm.begin(), e.blocks_Nm.end(),
                                   [&](double torque) { return sign * torque >= lowest; });
  return static_cast<double>(there) >= least_stay * static_cast<double>(e.blocks_Nm.size());
}

/// @param sign of the torque that may be limited; the largest torque is taken in this sense.
std::vector<AtSpeed> pairs_of(const std::vector<Extent>& extents, double sign) {
  const auto largest = [&](const Extent& e) { return largest_of(e, sign); };
  std::vector<AtSpeed> pairs;
  std::vector<bool> taken(extents.size());
  for (std::size_t i = 0; i < extents.size(); ++i) {
    if (taken[i]) continue;
    for (std::size_t k = i + 1; k < extents.size(); ++k) {
      const double apart = std::abs(extents[i].speed_rad_s + extents[k].speed_rad_s);
      if (taken[k] || apart > motion::same_speed * std::abs(extents[i].speed_rad_s) ||
          !share_their_angles(extents[i], extents[k])) {
        continue;
      }
      taken[k] = true;
      const bool is_first = largest(extents[i]) > largest(extents[k]);
      const Extent& a = is_first ? extents[i] : extents[k];
      const Extent& b = is_first ? extents[k] : extents[i];
      pairs.push_back(
          {largest(a), largest(b), std::max(a.error_Nm, b.error_Nm), stays_at_largest(a, sign)});
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
    std::size_t staying = 0;
    double lowest = INFINITY;
    double highest = -INFINITY;
    double largest_error = 0;
    for (const AtSpeed& at : pairs) {
      const double error = std::hypot(at.error_Nm, pairs.front().error_Nm);
      if (pairs.front().torque_Nm - at.torque_Nm > same * error) break;
      lowest = std::min(lowest, at.other_Nm);
      highest = std::max(highest, at.other_Nm);
      largest_error = std::max(largest_error, at.error_Nm);
      staying += at.stays ? 1 : 0;
      ++count;
    }
    const double needed = least_share * static_cast<double>(pairs.size());
    if (staying < fewest_on_ceiling || static_cast<double>(count) < needed) continue;
    const double spread = pairs.front().torque_Nm - pairs[count - 1].torque_Nm;
    if (highest - lowest > std::max(different * largest_error, far_apart * spread)) {
      return {count, sign * pairs.front().torque_Nm};
    }
  }
  return {};
}

}  // namespace tribolog::method::checks
