#include "report/document/log_picture.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "joint/degrees.h"
#include "wording/labels.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {
namespace {

using calibration::LogTrace;
using wording::tr;

constexpr double strip_first_px = 64;
constexpr double strip_last_px = 996;
constexpr double strip_top_px = 24;
constexpr double strip_bottom_px = 124;
constexpr double gap_share = 0.004;  // of the width, between recordings

/// "constant speed": what a part of the log was taken for.
std::string role_in_words(joint::Role role) {
  return role == joint::Role::friction_points ? "" : wording::words_for("role", to_string(role));
}

/// No longer than fits beside the strip: a shaft may turn a thousand times.
std::string angle_on_axis(double q_rad, double largest_rad) {
  constexpr double many_turns_deg = 1e5;
  constexpr double whole_degrees_deg = 100;
  const double largest_deg = largest_rad * joint::degrees_per_rad;
  const double deg = q_rad * joint::degrees_per_rad;
  if (largest_deg >= many_turns_deg) {
    return tr("{turns} rev",
              {{"turns", wording::with_minus_sign(fmt::format("{:.0f}", deg / 360))}});
  }
  const char* const format = largest_deg >= whole_degrees_deg ? "{:.0f}" : "{:.3g}";
  return wording::with_minus_sign(fmt::format(fmt::runtime(format), deg)) + "°";
}

double duration_s(const LogTrace& trace) { return trace.t_s.back() - trace.t_s.front(); }

/// Where each recording stands across the picture.
class RecordingPlaces {
 public:
  explicit RecordingPlaces(const std::vector<const LogTrace*>& traces) {
    double all_s = 0;
    for (const LogTrace* const one : traces) all_s += duration_s(*one);
    const double gaps = gap_share * static_cast<double>(traces.size() - 1);
    const double gap_px = (strip_last_px - strip_first_px) * std::min(gaps, 0.3) /
                          std::max<double>(1, static_cast<double>(traces.size() - 1));
    const double width_px = (strip_last_px - strip_first_px) * (1 - std::min(gaps, 0.3));
    px_per_s_ = all_s > 0 ? width_px / all_s : 0;
    double at = strip_first_px;
    for (const LogTrace* const one : traces) {
      starts_.push_back(at);
      at += px_per_s_ * duration_s(*one) + gap_px;
    }
  }
  [[nodiscard]] double at(std::size_t trace, double since_start_s) const {
    return starts_[trace] + px_per_s_ * since_start_s;
  }

 private:
  double px_per_s_{};
  std::vector<double> starts_;
};

}  // namespace

std::optional<LogPicture> log_picture(const calibration::Calibration& c) {
  std::vector<const LogTrace*> traces;
  double low = INFINITY;
  double high = -INFINITY;
  for (const LogTrace& one : c.curves.log) {
    if (one.t_s.size() < 2) continue;
    traces.push_back(&one);
    const auto [least, most] = std::minmax_element(one.q_rad.begin(), one.q_rad.end());
    low = std::min(low, *least);
    high = std::max(high, *most);
  }
  if (traces.empty() || !(high > low)) return std::nullopt;
  const RecordingPlaces places(traces);
  const auto y_of = [&](double q_rad) {
    return strip_bottom_px - (q_rad - low) / (high - low) * (strip_bottom_px - strip_top_px);
  };
  LogPicture picture;
  const double largest_rad = std::max(std::abs(low), std::abs(high));
  for (const double q_rad : {low, high}) {
    picture.y_ticks.push_back({y_of(q_rad), angle_on_axis(q_rad, largest_rad)});
  }
  for (std::size_t k = 0; k < traces.size(); ++k) {
    const LogTrace& one = *traces[k];
    std::string path;
    for (std::size_t i = 0; i < one.t_s.size(); ++i) {
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L",
                          places.at(k, one.t_s[i] - one.t_s.front()), y_of(one.q_rad[i]));
    }
    const double from = places.at(k, 0);
    const double to = places.at(k, duration_s(one));
    const bool goes_on = k > 0 && traces[k - 1]->role == one.role;
    if (goes_on) {
      LogPicture::Phase& phase = picture.phases.back();
      phase.to = to;
      ++phase.recordings;
      phase.path += path;
    } else {
      picture.phases.push_back(
          {role_in_words(one.role), joint::to_string(one.role), from, to, 1, std::move(path)});
    }
  }
  double all_s = 0;
  for (const LogTrace* const one : traces) all_s += duration_s(*one);
  picture.caption =
      wording::tr_count(static_cast<std::int64_t>(traces.size()), "{count} recording",
                        "{count} recordings", {{"count", fmt::format("{}", traces.size())}}) +
      tr(", {seconds} s in all: the joint's angle, and what each part was taken for.",
         {{"seconds", fmt::format("{:.4g}", all_s)}});
  return picture;
}

}  // namespace tribolog::report::document
