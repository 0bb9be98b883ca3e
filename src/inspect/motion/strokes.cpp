#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "inspect/motion/angle_trace.h"
#include "inspect/motion/strokes_and_ramps.h"

namespace tribolog::inspect::motion {
namespace {

constexpr std::size_t fewest_in_stroke = 5;
constexpr double wiggle_share = 0.05;  // of the range: smaller reversals are passed over
constexpr double band_share = 0.02;    // of a way's travel, within which it may rest
constexpr double wiggle_margin = 1.2;  // a band is wider than the wiggles within the way
constexpr double widest_band = 0.2;    // of the travel; wider ones cannot tell rest from motion
constexpr double edge_share = 1e-4;    // of the travel: beyond, it has left its stand
// At a reversal of steady acceleration the first band takes 1 / (sqrt 2 - 1) times the second.
constexpr double parabola = 2.414;
constexpr double parabola_further = 3.146;  // 1 / (sqrt 3 - sqrt 2), of the third band
// Beyond this multiple of what a reversal takes, it is a rest. A smooth start (a cubic) takes 1.6.
constexpr double rest_multiple = 2;
// A pause on the way takes this many times as long as the bands beside it: stopping and starting at
// once takes 2.7.
constexpr double pause_multiple = 5;
constexpr double stand_share = 0.1;    // of a band, within which it stands
constexpr double coarser = 3;          // from one tolerance tried to the next
constexpr double smaller_scale = 0.7;  // a rest is looked at again only at a smaller scale

/// A way cut into bands of equal travel.
struct Bands {
  std::vector<std::size_t>
      at;  ///< See TravelBetweenTurns::passages(); empty: too rough to be looked at closer.
  double finest{};  ///< Tolerances within which it stands, in rad.
  double widest{};
};

/// A stretch of time in which it may rest: from entering a band to leaving it.
struct Dwell {
  std::size_t entered{};
  std::size_t left{};
  std::size_t latest_end{};               ///< The stroke before does not reach beyond it.
  std::size_t earliest_begin{};           ///< Nor does the one behind begin before it.
  std::pair<double, double> tolerance{};  ///< Finest and widest within which it stands [rad].
  double stopping_s{};  ///< What stopping without a rest takes; 0: no stroke lies before.
  double starting_s{};  ///< And starting; 0: no stroke lies behind.
};

struct Turn {
  std::size_t at{};
  bool is_first{};  ///< Of its stretch.
  bool is_last{};
};

/// What turning takes in the first band, by the second and the third one: a pause may lie in
/// either.
double turning_s(double second_s, double third_s) {
  return std::min(parabola * second_s, parabola_further * third_s);
}

double spread(const std::vector<double>& q, std::size_t first, std::size_t last) {
  const auto [low, high] = std::minmax_element(q.begin() + static_cast<std::ptrdiff_t>(first),
                                               q.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  return *high - *low;
}

class StrokeFinder {
 public:
  StrokeFinder(const AngleTrace& trace, double noise_floor_rad)
      : trace_(trace), floor_(noise_floor_rad) {}

  std::vector<StrokeFamily> find() {
    if (trace_.size() > 1) stretches_.emplace_back(0, trace_.size() - 1);
    // Rests join the list while it is worked through.
    for (std::size_t k = 0; k < stretches_.size(); ++k) {
      const auto [first, last] = stretches_[k];
      look_at(first, last);
    }
    return std::move(families_);
  }

 private:
  void look_at(std::size_t first, std::size_t last) {
    if (last < first + fewest_in_stroke) return;
    const double range = spread(trace_.q_rad, first, last);
    if (!(range > floor_) || !(range > 0)) return;
    range_ = range;
    first_ = first;
    last_ = last;
    family_.clear();
    begun_.reset();
    const double threshold = std::max(wiggle_share * range, floor_);
    const std::vector<std::size_t> turns = turning_points(trace_.q_rad, first, last, threshold);
    Bands before;
    for (std::size_t k = 0; k + 1 < turns.size(); ++k) {
      const TravelBetweenTurns way(trace_, turns[k], turns[k + 1]);
      Bands bands = bands_of(way);
      at_turn({way.first(), k == 0, false}, before, bands);
      add_pauses(bands);
      before = std::move(bands);
    }
    if (!turns.empty()) at_turn({turns.back(), false, true}, before, {});
    if (!family_.empty()) families_.push_back(family_);
  }

  [[nodiscard]] Bands bands_of(const TravelBetweenTurns& way) const {
    const double travel = way.travel_rad();
    const double rough = std::max(floor_, wiggle_margin * way.largest_wiggle_rad());
    const double band = std::max(band_share * travel, rough);
    Bands bands;
    if (band > widest_band * travel) return bands;
    bands.at = way.passages(band);
    bands.finest = std::max(floor_, edge_share * travel);
    bands.widest = std::max(rough, stand_share * band);
    return bands;
  }

  [[nodiscard]] double seconds(std::size_t from, std::size_t to) const {
    return trace_.t_s[to] - trace_.t_s[from];
  }

  /// Never less than a sampling interval, which is as well as it can be known.
  [[nodiscard]] double pace_s(std::size_t from, std::size_t to) const {
    const double interval = seconds(from > 0 ? from - 1 : from, from > 0 ? from : from + 1);
    return std::max(seconds(from, to), interval);
  }

  /// A turning point: rest or reversal. The stretch may rest before its first and behind its last.
  /// @param before, behind the ways beside it, in bands.
  void at_turn(const Turn& turn, const Bands& before, const Bands& behind) {
    Dwell dwell{turn.is_first ? first_ : turn.at, turn.is_last ? last_ : turn.at, turn.at, turn.at};
    dwell.tolerance = {std::max(before.finest, behind.finest),
                       std::max(before.widest, behind.widest)};
    if (before.at.size() > 3) {
      // The last band is a part of one, so the one before it counts as dwelling too.
      const std::size_t n = before.at.size();
      dwell.entered = before.at[n - 2];
      dwell.stopping_s = turning_s(pace_s(before.at[n - 3], before.at[n - 2]),
                                   pace_s(before.at[n - 4], before.at[n - 3]));
    }
    if (behind.at.size() > 3) {
      dwell.left = behind.at[1];
      dwell.starting_s =
          turning_s(pace_s(behind.at[1], behind.at[2]), pace_s(behind.at[2], behind.at[3]));
    }
    const double reversal_s = dwell.stopping_s + dwell.starting_s;
    if (reversal_s > 0 && seconds(dwell.entered, dwell.left) > rest_multiple * reversal_s &&
        rest_at(dwell)) {
      return;
    }
    end_stroke(turn.at);
    begin_stroke(turn.at, !turn.is_first);
  }

  void add_pauses(const Bands& bands) {
    const std::vector<std::size_t>& at = bands.at;
    for (std::size_t k = 1; k + 2 < at.size(); ++k) {
      // The first band may be a rest, and the last one is a part of one.
      const double before = k > 1 ? pace_s(at[k - 1], at[k]) : 0;
      const double behind = k + 3 < at.size() ? pace_s(at[k + 1], at[k + 2]) : 0;
      const double beside = std::max(before, behind);
      if (beside == 0 || seconds(at[k], at[k + 1]) <= pause_multiple * beside) continue;
      Dwell dwell{at[k], at[k + 1], at[k + 1], at[k]};
      dwell.tolerance = {bands.finest, bands.widest};
      dwell.stopping_s = beside;
      dwell.starting_s = beside;
      (void)rest_at(dwell);
    }
  }

  /// Ends the stroke before, begins the one behind, and keeps the rest between for a closer look.
  /// @return false where it does not stand: nothing is done then.
  bool rest_at(const Dwell& dwell) {
    const bool is_first = dwell.stopping_s == 0;
    const bool is_last = dwell.starting_s == 0;
    std::size_t end = dwell.entered;
    std::size_t begin = dwell.left;
    if (!is_first) {
      const auto stand = stand_in(dwell, dwell.stopping_s, first_quiet);
      if (!stand) return false;
      end = std::min(*stand, dwell.latest_end);
    }
    if (!is_last) {
      const auto stand = stand_in(dwell, dwell.starting_s, last_quiet);
      if (!stand) return false;
      begin = std::max(*stand, dwell.earliest_begin);
    }
    if (begin <= end || seconds(end, begin) < dwell.stopping_s + dwell.starting_s) return false;
    end_stroke(end);
    begin_stroke(begin, false);
    if (spread(trace_.q_rad, end, begin) < smaller_scale * range_) {
      stretches_.emplace_back(end, begin);
    }
    return true;
  }

  /// With the finest tolerance at which it stands at all.
  template <typename Search>
  std::optional<std::size_t> stand_in(const Dwell& dwell, double window_s, Search search) const {
    const auto [finest, widest] = dwell.tolerance;
    for (double tolerance = finest;; tolerance = std::min(coarser * tolerance, widest)) {
      const auto found =
          search(trace_.t_s, trace_.q_rad, {dwell.entered, dwell.left, window_s, tolerance});
      if (found || tolerance >= widest) return found;
    }
  }

  void begin_stroke(std::size_t first, bool follows_on) {
    begun_ = first;
    follows_on_ = follows_on;
  }

  void end_stroke(std::size_t last) {
    if (!begun_ || last <= *begun_) return;
    family_.push_back({*begun_, last, trace_.q_rad[last] - trace_.q_rad[*begun_], follows_on_});
  }

  const AngleTrace& trace_;
  double floor_;
  std::vector<std::pair<std::size_t, std::size_t>> stretches_;
  std::vector<StrokeFamily> families_;

  // Of the stretch under way.
  double range_{};
  std::size_t first_{};
  std::size_t last_{};
  StrokeFamily family_;
  std::optional<std::size_t> begun_;
  bool follows_on_{false};
};

}  // namespace

std::vector<StrokeFamily> find_strokes(const AngleTrace& trace, double noise_floor_rad) {
  return StrokeFinder(trace, noise_floor_rad).find();
}

}  // namespace tribolog::inspect::motion
