#include "method/checks/direction_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "statistics/distributions.h"

namespace tribolog::method::checks {
namespace {

constexpr std::size_t angle_bins = 24;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Reach {
  double low{infinity};
  double high{-infinity};
  double travel{};
  void add(double q) {
    low = std::min(low, q);
    high = std::max(high, q);
  }
};

struct Bin {
  double sum{};
  std::size_t count{};
};

}  // namespace

DirectionDifference direction_difference(const std::vector<const CheckedRecording*>& recordings,
                                         bool with_torque) {
  DirectionDifference out;
  std::array<Reach, 2> reach;
  for (const CheckedRecording* r : recordings) {
    for (const motion::Stroke& stroke : r->ways()) {
      Reach& way = reach[stroke.direction > 0 ? 0 : 1];
      way.add(r->recording->q_rad[stroke.first]);
      way.add(r->recording->q_rad[stroke.last]);
      way.travel += stroke.travel_rad;
    }
  }
  out.rising_travel_rad = reach[0].travel;
  out.falling_travel_rad = reach[1].travel;
  if (!(reach[0].travel > 0) || !(reach[1].travel > 0)) return out;
  const double low = std::max(reach[0].low, reach[1].low);
  const double high = std::min(reach[0].high, reach[1].high);
  const double narrower = std::min(reach[0].high - reach[0].low, reach[1].high - reach[1].low);
  out.common_share = std::max(0.0, high - low) / narrower;
  if (!with_torque || !(high > low)) return out;

  std::array<std::array<Bin, angle_bins>, 2> torque{};
  for (const CheckedRecording* r : recordings) {
    for (const motion::Stroke& stroke : r->ways()) {
      for (std::size_t i = stroke.first; i < stroke.last; ++i) {
        const double place = (r->recording->q_rad[i] - low) / (high - low);
        if (!(place >= 0 && place < 1)) continue;
        Bin& bin =
            torque[stroke.direction > 0 ? 0 : 1][static_cast<std::size_t>(place * angle_bins)];
        bin.sum += r->recording->torque_Nm[i];
        ++bin.count;
      }
    }
  }
  std::vector<double> halves;
  for (std::size_t k = 0; k < angle_bins; ++k) {
    const Bin& up = torque[0][k];
    const Bin& down = torque[1][k];
    if (up.count == 0 || down.count == 0) continue;
    halves.push_back(
        (up.sum / static_cast<double>(up.count) - down.sum / static_cast<double>(down.count)) / 2);
  }
  out.common_bins = halves.size();
  if (halves.empty()) return out;
  const auto n = static_cast<double>(halves.size());
  for (const double half : halves) out.friction_Nm += half / n;
  double squares = 0;
  for (const double half : halves) squares += std::pow(half - out.friction_Nm, 2);
  out.half_width_Nm =
      n > 1 ? statistics::student_t_975(n - 1) * std::sqrt(squares / (n - 1) / n) : infinity;
  return out;
}

}  // namespace tribolog::method::checks
