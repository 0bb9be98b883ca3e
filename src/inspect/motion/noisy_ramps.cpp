// Ramps of an effort whose noise hides its turns: straight lines through its means, while the joint
// stands.

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "inspect/motion/strokes_and_ramps.h"
#include "statistics/sampled_signal.h"

namespace tribolog::inspect::motion {
namespace {

constexpr std::size_t blocks = 24;         // of a rest, each with a mean
constexpr std::size_t fewest_blocks = 16;  // that lie on the line: the rest may begin and end level
constexpr std::size_t fewest_in_block = 5;  // samples
constexpr double least_s = 2;               // faster ones are starts of a motion
constexpr double noisy = 0.01;              // of the effort's range: less hides no ramp
constexpr double least_rise = 0.1;          // of it
constexpr double means_share = 0.06;        // of the rise: as far from the line as a mean may be
constexpr double in_doubt = 3;              // standard errors of a mean
constexpr double far_off = 4;               // standard deviations of a sample
constexpr double clear_rise = 8;            // of them
constexpr double rest_rad = 2e-3;           // an elastic contact yields
constexpr std::size_t most_beyond = 3;      // blocks up to the end of the rest that leave the line
constexpr double longest_slide = 0.1;       // of the ramp's time
constexpr double still_on = 0.7;            // of the torque at which the joint gave way

struct Rest {
  std::size_t first{};
  std::size_t last{};
};

/// Stretches in which the angle stays within `most_rad`, one behind the other.
std::vector<Rest> rests(const std::vector<double>& q_rad, Rest in, double most_rad) {
  std::vector<Rest> found;
  for (std::size_t first = in.first; first <= in.last;) {
    double low = q_rad[first];
    double high = low;
    std::size_t next = first + 1;
    for (; next <= in.last; ++next) {
      low = std::min(low, q_rad[next]);
      high = std::max(high, q_rad[next]);
      if (high - low > most_rad) break;
    }
    found.push_back({first, next - 1});
    first = next;
  }
  return found;
}

struct MeanEffort {
  double t_s{};
  double effort{};
};

/// Where in a rest its means lie on a line.
struct LineOfMeans {
  std::size_t first{};  ///< Blocks, both included.
  std::size_t last{};
  double rate{};
  MeanEffort middle;

  [[nodiscard]] double at(double t_s) const { return middle.effort + rate * (t_s - middle.t_s); }
};

std::optional<LineOfMeans> line_through(const std::array<MeanEffort, blocks>& means,
                                        std::size_t first, std::size_t last,
                                        double standard_error) {
  const auto n = static_cast<double>(last - first + 1);
  MeanEffort middle;
  for (std::size_t k = first; k <= last; ++k) {
    middle.t_s += means.at(k).t_s / n;
    middle.effort += means.at(k).effort / n;
  }
  double squares = 0;
  double products = 0;
  for (std::size_t k = first; k <= last; ++k) {
    const double t_s = means.at(k).t_s - middle.t_s;
    squares += t_s * t_s;
    products += t_s * (means.at(k).effort - middle.effort);
  }
  const LineOfMeans line{first, last, products / squares, middle};
  const double rise = std::abs(line.rate) * (means.at(last).t_s - means.at(first).t_s);
  if (rise < clear_rise * standard_error) return std::nullopt;
  const double tolerance = std::max(means_share * rise, in_doubt * standard_error);
  for (std::size_t k = first; k <= last; ++k) {
    if (std::abs(means.at(k).effort - line.at(means.at(k).t_s)) > tolerance) return std::nullopt;
  }
  return line;
}

/// The longest line, which may leave a level out before it and behind it.
std::optional<LineOfMeans> longest_line(const std::array<MeanEffort, blocks>& means,
                                        double standard_error) {
  for (std::size_t count = blocks; count >= fewest_blocks; --count) {
    for (std::size_t first = 0; first + count <= blocks; ++first) {
      const auto line = line_through(means, first, first + count - 1, standard_error);
      if (line) return line;
    }
  }
  return std::nullopt;
}

std::array<MeanEffort, blocks> means_of(const AngleTrace& trace, const Rest& rest,
                                        std::size_t in_block) {
  std::array<MeanEffort, blocks> means{};
  for (std::size_t k = 0; k < blocks * in_block; ++k) {
    MeanEffort& mean = means.at(k / in_block);
    mean.t_s += trace.t_s[rest.first + k] / static_cast<double>(in_block);
    mean.effort += trace.effort[rest.first + k] / static_cast<double>(in_block);
  }
  return means;
}

/// Last sample up to `last` at which the joint still slides under the effort that moved it.
/// @param beside samples behind each over which the effort is averaged.
std::size_t slides_until(const AngleTrace& trace, std::size_t from, std::size_t last,
                         double longest_s, double gave_way, std::size_t beside) {
  const double until_s = trace.t_s[from] + longest_s;
  std::size_t i = from;
  for (; i + 1 + beside <= last && trace.t_s[i + 1] < until_s; ++i) {
    const auto at = trace.effort.begin() + static_cast<std::ptrdiff_t>(i + 1);
    const double sum = std::accumulate(at, at + static_cast<std::ptrdiff_t>(beside + 1), 0.0);
    if (sum / static_cast<double>(beside + 1) / gave_way < still_on) break;
  }
  return i;
}

/// The ramp of one rest.
/// @param last sample up to which the joint may slide behind it.
std::optional<TorqueRamp> ramp_of(const AngleTrace& trace, const Rest& rest, std::size_t last,
                                  double noise, double least_change) {
  const std::size_t in_block = (rest.last - rest.first + 1) / blocks;
  const double rest_s = trace.t_s[rest.last] - trace.t_s[rest.first];
  if (in_block < fewest_in_block || rest_s < least_s) return std::nullopt;
  const auto means = means_of(trace, rest, in_block);
  const auto line = longest_line(means, noise / std::sqrt(static_cast<double>(in_block)));
  if (!line) return std::nullopt;
  const double duration_s = means.at(line->last).t_s - means.at(line->first).t_s;
  if (std::abs(line->rate) * duration_s < least_change) return std::nullopt;
  const auto begin_of = [&](std::size_t block) { return rest.first + block * in_block; };
  TorqueRamp ramp{begin_of(line->first), begin_of(line->last + 1) - 1, line->rate, false};
  // The torque of what came before may still die away where the rest begins.
  for (std::size_t i = ramp.first; i < begin_of(line->first + 1); ++i) {
    const double off = trace.effort[i] - line->at(trace.t_s[i]);
    if (std::abs(off) > far_off * noise) ramp.first = i + 1;
  }
  const double gave_way = means.at(line->last).effort;
  const bool lasts =
      std::all_of(means.begin() + static_cast<std::ptrdiff_t>(line->last), means.end(),
                  [&](const MeanEffort& mean) { return mean.effort / gave_way >= still_on; });
  if (!lasts || line->last + most_beyond < blocks) return ramp;
  ramp.last =
      slides_until(trace, rest.last, last, longest_slide * duration_s, gave_way, in_block / 4);
  ramp.joint_slid = ramp.last > rest.last;
  return ramp;
}

}  // namespace

NoisyRampFinder::NoisyRampFinder(const AngleTrace& trace, double floor_rad)
    : trace_(trace), rest_rad_(std::max(rest_rad, floor_rad)) {
  if (trace.effort.empty()) return;
  const auto [low, high] = std::minmax_element(trace.effort.begin(), trace.effort.end());
  range_ = *high - *low;
  noise_ = statistics::white_sd_beside_jumps(statistics::third_differences(trace.effort));
}

std::vector<TorqueRamp> NoisyRampFinder::between(std::size_t first, std::size_t last) const {
  std::vector<TorqueRamp> found;
  if (!(noise_ > noisy * range_)) return found;
  for (const Rest& rest : rests(trace_.q_rad, {first, last}, rest_rad_)) {
    const auto ramp = ramp_of(trace_, rest, last, noise_, least_rise * range_);
    if (ramp) found.push_back(*ramp);
  }
  return found;
}

}  // namespace tribolog::inspect::motion
