#include "method/hysteresis/loop_misfit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tribolog::method::hysteresis {
namespace {

constexpr std::size_t bins = 60;

struct Mean {
  double sum{};
  double squares{};
  double count{};
  void add(double x) {
    sum += x;
    squares += x * x;
    count += 1;
  }
  [[nodiscard]] double value() const { return sum / count; }
  /// Square of the mean, less the contribution of independent scatter.
  [[nodiscard]] double square_without_scatter() const {
    if (count < 2) return 0;
    const double scatter = (squares - count * value() * value()) / (count - 1);
    return value() * value() - scatter / count;
  }
};

}  // namespace

LoopMisfit loop_misfit(const joint::Recording& recording, const std::vector<double>& model_Nm,
                       const std::vector<double>& speed) {
  const auto [low, high] = std::minmax_element(recording.q_rad.begin(), recording.q_rad.end());
  const double width = (*high - *low) / static_cast<double>(bins);
  LoopMisfit out;
  if (!(width > 0)) return out;
  std::array<std::array<Mean, bins>, 2> means{};
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const double place = std::floor((recording.q_rad[i] - *low) / width);
    const auto bin = std::min(bins - 1, static_cast<std::size_t>(place));
    means[speed[i] > 0 ? 0 : 1][bin].add(recording.torque_Nm[i] - model_Nm[i]);
  }
  double squares = 0;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    if (means[0][bin].count == 0 || means[1][bin].count == 0) continue;
    out.q_rad.push_back(*low + (static_cast<double>(bin) + 0.5) * width);
    out.rising_Nm.push_back(means[0][bin].value());
    out.falling_Nm.push_back(means[1][bin].value());
    squares += means[0][bin].square_without_scatter() + means[1][bin].square_without_scatter();
  }
  const auto bins_used = static_cast<double>(out.q_rad.size());
  if (squares > 0) out.systematic_Nm = std::sqrt(squares / (2 * bins_used));
  return out;
}

double repeated_misfit_Nm(const joint::Recording& recording, const std::vector<double>& model_Nm,
                          const std::vector<double>& turns_s, std::size_t first) {
  constexpr double fewest_strokes = 3;
  std::array<std::array<Mean, bins>, 2> over_strokes{};
  std::size_t i = first;
  for (std::size_t k = 0; k + 1 < turns_s.size(); ++k) {
    const double from = recording.t_s.front() + turns_s[k];
    const double length = turns_s[k + 1] - turns_s[k];
    if (recording.t_s[std::min(first, recording.size() - 1)] > from || !(length > 0)) continue;
    std::array<Mean, bins> stroke{};  // its samples are not independent of each other
    while (i < recording.size() && recording.t_s[i] < from) ++i;
    for (; i < recording.size() && recording.t_s[i] < from + length; ++i) {
      const double share = (recording.t_s[i] - from) / length;
      const auto bin = std::min(bins - 1, static_cast<std::size_t>(share * bins));
      stroke[bin].add(recording.torque_Nm[i] - model_Nm[i]);
    }
    for (std::size_t bin = 0; bin < bins; ++bin) {
      if (stroke[bin].count > 0) over_strokes[k % 2][bin].add(stroke[bin].value());
    }
  }
  double squares = 0;
  double used = 0;
  for (const auto& direction : over_strokes) {
    for (const Mean& mean : direction) {
      if (mean.count < fewest_strokes) continue;
      squares += mean.square_without_scatter();
      used += 1;
    }
  }
  return squares > 0 ? std::sqrt(squares / used) : 0;
}

}  // namespace tribolog::method::hysteresis
