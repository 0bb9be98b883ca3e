#include "method/session/stroke_pairs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "method/motion/plateaus.h"

namespace tribolog::method::session {
namespace {

// Speeds whose relative difference is smaller count as one.
constexpr double same_speed = 0.03;
constexpr double least_overlap = 0.5;  // of the shorter way
constexpr double plateau_share_of_constant_speed = 0.5;
constexpr double most_cells = 48;
constexpr double fewest_cells = 4;
constexpr double fewest_samples_in_cell = 5;

struct Stroke {
  std::size_t recording, first, last;
  double speed;  // joint, signed
  double low, high;
  bool of_sweep;
  bool is_paired{false};
};

bool takes_part(joint::Role role) {
  return role == joint::Role::rough_sweep || role == joint::Role::precise_sweep ||
         role == joint::Role::constant_speed;
}

std::vector<Stroke> strokes_of(const std::vector<joint::Recording>& recordings,
                               const SessionTimes& times) {
  std::vector<Stroke> strokes;
  for (std::size_t k = 0; k < recordings.size(); ++k) {
    const joint::Recording& r = recordings[k];
    if (!takes_part(r.role) || r.torque_Nm.empty()) continue;
    const motion::MotionSegments motion = motion::find_plateaus(r);
    const bool of_sweep = r.role != joint::Role::constant_speed;
    if (of_sweep && motion.plateau_share() < plateau_share_of_constant_speed) continue;
    for (const motion::Plateau& p : motion.plateaus) {
      const auto from = r.q_rad.begin() + static_cast<std::ptrdiff_t>(p.first);
      const auto to = r.q_rad.begin() + static_cast<std::ptrdiff_t>(p.last);
      const auto [low, high] = std::minmax_element(from, to);
      strokes.push_back({k, p.first, p.last, p.speed_rad_s, *low, *high, of_sweep});
    }
  }
  std::stable_sort(strokes.begin(), strokes.end(), [&](const Stroke& a, const Stroke& b) {
    return times.begin_s[a.recording] < times.begin_s[b.recording];
  });
  return strokes;
}

bool may_pair(const Stroke& a, const Stroke& b) {
  if (b.is_paired || a.of_sweep != b.of_sweep) return false;
  if (std::abs(-b.speed / a.speed - 1) > same_speed) return false;
  const double common = std::min(a.high, b.high) - std::max(a.low, b.low);
  return common > least_overlap * std::min(a.high - a.low, b.high - b.low);
}

/// The next stroke in the opposite direction: of the same recording where there is one.
Stroke* partner_of(std::size_t i, std::vector<Stroke>& strokes) {
  Stroke* other = nullptr;
  for (std::size_t k = i + 1; k < strokes.size(); ++k) {
    if (!may_pair(strokes[i], strokes[k])) continue;
    if (strokes[k].recording == strokes[i].recording) return &strokes[k];
    if (other == nullptr) other = &strokes[k];
  }
  return other;
}

struct Sum {
  double q{}, torque{}, share{}, n{};
};

/// Sums over the cells of one stroke.
std::vector<Sum> sums_of(const Stroke& s, const joint::Recording& r, const SessionTimes& times,
                         double low, double high, std::size_t cells, double gear_ratio,
                         const gravity::Ripple& ripple) {
  std::vector<Sum> sums(cells);
  for (std::size_t i = s.first; i < s.last; ++i) {
    const double place = (r.q_rad[i] - low) / (high - low);
    if (!(place >= 0 && place < 1)) continue;
    Sum& sum = sums[static_cast<std::size_t>(place * static_cast<double>(cells))];
    sum.q += r.q_rad[i];
    sum.torque += r.torque_Nm[i];
    if (!ripple.lines.empty()) sum.torque -= ripple.torque_Nm(gear_ratio * r.q_rad[i]);
    sum.share += times.share(s.recording, r, r.t_s[i]);
    sum.n += 1;
  }
  return sums;
}

class Builder {
 public:
  Builder(const std::vector<joint::Recording>& recordings, const SessionTimes& times,
          double gear_ratio, const gravity::Ripple& ripple)
      : recordings_(recordings), times_(times), n_(gear_ratio), ripple_(ripple) {}

  void add(const Stroke& a, const Stroke& b, double widest) {
    const double low = std::max(a.low, b.low);
    const double high = std::min(a.high, b.high);
    const auto cells = static_cast<std::size_t>(
        std::clamp(std::round(most_cells * (high - low) / widest), fewest_cells, most_cells));
    const Stroke& rising = a.speed > 0 ? a : b;
    const Stroke& falling = a.speed > 0 ? b : a;
    const std::vector<Sum> up = sums(rising, low, high, cells);
    const std::vector<Sum> down = sums(falling, low, high, cells);
    StrokePair pair;
    pair.recording = recordings_[a.recording].name;
    pair.of_sweep = a.of_sweep;
    pair.speed_rad_s = n_ * (std::abs(a.speed) + std::abs(b.speed)) / 2;
    pair.lowest_rad = low;
    pair.highest_rad = high;
    double count = 0;
    for (std::size_t c = 0; c < cells; ++c) {
      if (up[c].n < fewest_samples_in_cell || down[c].n < fewest_samples_in_cell) continue;
      // Of sweeps, the cells of all pairs at the same angle; two to a block.
      const auto place =
          a.of_sweep
              ? static_cast<long>(std::floor(up[c].q / up[c].n / (widest / (most_cells / 2))))
              : 0;
      const std::size_t block =
          block_of(a.of_sweep ? -1 : static_cast<long>(out.pairs.size()), place);
      for (const auto& [sum, direction] : {std::pair{&down[c], -1.0}, std::pair{&up[c], 1.0}}) {
        out.cells.push_back({out.pairs.size(), block, direction, sum->q / sum->n,
                             sum->torque / sum->n, sum->share / sum->n, sum->n});
      }
      pair.friction_Nm += (up[c].torque / up[c].n - down[c].torque / down[c].n) / 2;
      count += 1;
    }
    if (count == 0) return;
    pair.friction_Nm /= count;
    const auto at = [&](const Stroke& s, std::size_t i) {
      const joint::Recording& r = recordings_[s.recording];
      return times_.share(s.recording, r, r.t_s[i]);
    };
    pair.session_share[0] = at(a, a.first);
    pair.session_share[1] = at(a, a.last - 1);
    pair.session_share[2] = at(b, b.first);
    pair.session_share[3] = at(b, b.last - 1);
    out.widest_rad = std::max(out.widest_rad, high - low);
    out.pairs.push_back(pair);
  }

  StrokePairs out;

 private:
  std::vector<Sum> sums(const Stroke& s, double low, double high, std::size_t cells) const {
    return sums_of(s, recordings_[s.recording], times_, low, high, cells, n_, ripple_);
  }
  std::size_t block_of(long pair, long place) {
    return blocks_.emplace(std::pair{pair, place}, blocks_.size()).first->second;
  }

  const std::vector<joint::Recording>& recordings_;
  const SessionTimes& times_;
  double n_;
  const gravity::Ripple& ripple_;
  std::map<std::pair<long, long>, std::size_t> blocks_;
};

}  // namespace

StrokePairs find_stroke_pairs(const std::vector<joint::Recording>& recordings,
                              const SessionTimes& times, double gear_ratio,
                              const gravity::Ripple& ripple) {
  std::vector<Stroke> strokes = strokes_of(recordings, times);
  std::vector<std::pair<std::size_t, const Stroke*>> found;
  double widest = 0;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (strokes[i].is_paired) continue;
    Stroke* partner = partner_of(i, strokes);
    if (partner == nullptr) continue;
    strokes[i].is_paired = partner->is_paired = true;
    found.emplace_back(i, partner);
    widest = std::max(
        widest, std::min(strokes[i].high, partner->high) - std::max(strokes[i].low, partner->low));
  }
  Builder builder(recordings, times, gear_ratio, ripple);
  if (!(widest > 0)) return builder.out;
  for (const auto& [i, partner] : found) builder.add(strokes[i], *partner, widest);
  return builder.out;
}

}  // namespace tribolog::method::session
