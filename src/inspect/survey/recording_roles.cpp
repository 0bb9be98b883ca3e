#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "inspect/survey/manifest_proposal.h"
#include "joint/degrees.h"

namespace tribolog::inspect::survey {
namespace {

constexpr double other_speed = 1.1;      // ratio from which on speeds differ
constexpr double shortest_stroke_s = 3;  // of a sweep
constexpr double fastest_sweep_rad_s = 0.5;
constexpr double narrowest_sweep_rad = 0.1;
constexpr double wider_than_runs = 1.25;
constexpr double half_as_wide = 0.5;   // of two speeds the slower one sweeps
constexpr double precise_share = 0.1;  // of the rough sweep's range
constexpr double slowest_by_far = 2.5;
constexpr double like_shortest_run = 0.3;
constexpr double whole_share = 0.015;  // of the recording: what a window would cut off

struct Candidate {
  JointInLog of;
  const motion::MotionSegment* segment;
};

double stroke_s(const motion::MotionSegment& s) {
  return s.duration_s() / static_cast<double>(s.strokes);
}

bool same_speed(double a, double b) { return std::max(a, b) <= other_speed * std::min(a, b); }

class RoleChooser {
 public:
  RoleChooser(const std::vector<LogSurvey>& logs, const std::vector<JointInLog>& joint,
              bool has_no_gravity)
      : logs_(logs), joint_(joint), has_no_gravity_(has_no_gravity) {}

  RoleProposal choose() {
    for (const JointInLog& of : joint_) {
      for (const motion::MotionSegment& s : joint_of(logs_, of).segments) {
        if (s.kind == motion::MotionKind::constant_speed) steady_.push_back({of, &s});
        if (s.kind == motion::MotionKind::slow_sweep)
          sweep_rad_ = std::max(sweep_rad_, s.travel_rad());
      }
    }
    for (const Candidate& c : steady_) {
      if (is_rough_sweep(*c.segment)) sweep_rad_ = std::max(sweep_rad_, c.segment->travel_rad());
    }
    for (const JointInLog& of : joint_) propose_for(of);
    if (proposal_.recordings.empty() && !joint_.empty()) {
      proposal_.is_makeshift = true;
      proposal_.without_role.clear();
      for (const JointInLog& of : joint_) {
        proposal_.recordings.push_back({of, joint::Role::rough_sweep, {}, {}, ""});
      }
    }
    return std::move(proposal_);
  }

 private:
  [[nodiscard]] bool is_rough_sweep(const motion::MotionSegment& s) const {
    if (stroke_s(s) < shortest_stroke_s || s.speed_rad_s > fastest_sweep_rad_s) return false;
    if (s.travel_rad() < narrowest_sweep_rad) return false;
    double widest = 0;
    double widest_slow = 0;
    std::vector<double> speeds;
    for (const Candidate& c : steady_) {
      const double speed = c.segment->speed_rad_s;
      if (same_speed(speed, s.speed_rad_s)) continue;
      widest = std::max(widest, c.segment->travel_rad());
      if (speed <= fastest_sweep_rad_s) {
        widest_slow = std::max(widest_slow, c.segment->travel_rad());
      }
      const auto is_known = [&](double other) { return same_speed(speed, other); };
      if (std::none_of(speeds.begin(), speeds.end(), is_known)) speeds.push_back(speed);
    }
    if (s.travel_rad() >= std::max(widest, wider_than_runs * widest_slow)) return true;
    return speeds.size() == 1 && s.speed_rad_s < speeds.front() &&
           s.travel_rad() >= half_as_wide * widest;
  }

  /// Beside runs and a slow sweep, what speeds up and slows down for most of its way is the fastest
  /// run, and no second sweep.
  [[nodiscard]] bool is_fast_run(const motion::MotionSegment& s) const {
    constexpr std::size_t fewest_runs = 4;
    constexpr double faster = 4;
    if (steady_.size() < fewest_runs) return false;
    return std::any_of(steady_.begin(), steady_.end(), [&](const Candidate& c) {
      return is_rough_sweep(*c.segment) && s.speed_rad_s > faster * c.segment->speed_rad_s;
    });
  }

  [[nodiscard]] bool is_precise_sweep(const motion::MotionSegment& s) const {
    if (s.travel_rad() > std::min(precise_share * sweep_rad_, narrowest_sweep_rad)) return false;
    if (stroke_s(s) < shortest_stroke_s) return false;
    return std::all_of(steady_.begin(), steady_.end(), [&](const Candidate& c) {
      const double speed = c.segment->speed_rad_s;
      return same_speed(speed, s.speed_rad_s) || speed >= slowest_by_far * s.speed_rad_s;
    });
  }

  [[nodiscard]] std::optional<joint::Role> role_of(const motion::MotionSegment& s) const {
    switch (s.kind) {
      case motion::MotionKind::constant_speed:
        if (is_rough_sweep(s)) return joint::Role::rough_sweep;
        return is_precise_sweep(s) ? joint::Role::precise_sweep : joint::Role::constant_speed;
      case motion::MotionKind::slow_sweep:
        if (is_fast_run(s)) return joint::Role::constant_speed;
        return s.travel_rad() <= std::min(precise_share * sweep_rad_, narrowest_sweep_rad)
                   ? joint::Role::precise_sweep
                   : joint::Role::rough_sweep;
      case motion::MotionKind::oscillation:
        return joint::Role::oscillation;
      case motion::MotionKind::break_away_ramp:
        return joint::Role::break_away;
      case motion::MotionKind::rest:
      case motion::MotionKind::varying:
        break;
    }
    return std::nullopt;
  }

  /// No recording of so few samples is read.
  [[nodiscard]] bool is_too_short(const JointInLog& of, const motion::MotionSegment& s) const {
    constexpr double fewest_samples = 25;
    const auto& clock = table_of(logs_, of).clock;
    return clock && s.duration_s() < fewest_samples * clock->interval_s;
  }

  void propose_for(const JointInLog& of) {
    const std::vector<motion::MotionSegment>& segments = joint_of(logs_, of).segments;
    const std::size_t before = proposal_.recordings.size();
    for (const motion::MotionSegment& s : segments) {
      const auto role = role_of(s);
      if (role && !is_too_short(of, s)) add(of, s, *role);
    }
    if (proposal_.recordings.size() > before) return;
    // Beside runs at constant speed, one that never came to its speed.
    const auto only = std::find_if(
        segments.begin(), segments.end(),
        [](const motion::MotionSegment& s) { return s.kind == motion::MotionKind::varying; });
    const bool is_stroke = only != segments.end() && only->strokes == 1 && only->direction != 0;
    if (is_stroke && is_like_runs(*only)) {
      add(of, *only, joint::Role::constant_speed);
    } else if (const auto strokes = strokes_there_and_back(segments)) {
      add(of, *strokes, joint::Role::rough_sweep);
    } else {
      proposal_.without_role.push_back(of);
    }
  }

  /// Strokes of any course over the same way in both directions, in one: without gravity they show
  /// inertia and friction, as a sweep does.
  [[nodiscard]] std::optional<motion::MotionSegment> strokes_there_and_back(
      const std::vector<motion::MotionSegment>& segments) const {
    constexpr double least_common = 0.5;  // of the shorter one
    if (!has_no_gravity_) return std::nullopt;
    std::vector<const motion::MotionSegment*> strokes;
    for (const motion::MotionSegment& s : segments) {
      if (s.kind == motion::MotionKind::varying && s.direction != 0) strokes.push_back(&s);
    }
    const auto meet = [](const motion::MotionSegment* a, const motion::MotionSegment* b) {
      const double common =
          std::min(a->highest_rad, b->highest_rad) - std::max(a->lowest_rad, b->lowest_rad);
      return a->direction != b->direction &&
             common >= least_common * std::min(a->travel_rad(), b->travel_rad());
    };
    const bool turns_back = std::any_of(strokes.begin(), strokes.end(), [&](const auto* a) {
      return std::any_of(strokes.begin(), strokes.end(), [&](const auto* b) { return meet(a, b); });
    });
    if (!turns_back) return std::nullopt;
    motion::MotionSegment all = *strokes.front();
    all.kind = motion::MotionKind::slow_sweep;
    all.direction = 0;
    all.last = strokes.back()->last;
    all.to_s = strokes.back()->to_s;
    all.strokes = strokes.size();
    for (const motion::MotionSegment* s : strokes) {
      all.lowest_rad = std::min(all.lowest_rad, s->lowest_rad);
      all.highest_rad = std::max(all.highest_rad, s->highest_rad);
      all.speed_rad_s = std::max(all.speed_rad_s, s->speed_rad_s);
    }
    return all;
  }

  /// Most logs hold runs, and it travels about as far as the shortest of them.
  [[nodiscard]] bool is_like_runs(const motion::MotionSegment& s) const {
    if (2 * steady_.size() < joint_.size() || steady_.empty()) return false;
    const auto shortest = std::min_element(
        steady_.begin(), steady_.end(), [](const Candidate& a, const Candidate& b) {
          return a.segment->travel_rad() < b.segment->travel_rad();
        });
    return s.travel_rad() >= like_shortest_run * shortest->segment->travel_rad();
  }

  void add(const JointInLog& of, const motion::MotionSegment& s, joint::Role role) {
    const JointSurvey& joint = joint_of(logs_, of);
    const double start_s = joint.segments.front().from_s;
    const double end_s = joint.segments.back().to_s;
    ProposedRecording recording{of, role, {}, {}, describe(s)};
    const double negligible_s = whole_share * s.duration_s();
    if (s.from_s - start_s > negligible_s) recording.from_s = s.from_s;
    if (end_s - s.to_s > negligible_s) recording.to_s = s.to_s;
    proposal_.recordings.push_back(std::move(recording));
  }

  const std::vector<LogSurvey>& logs_;
  const std::vector<JointInLog>& joint_;
  bool has_no_gravity_;
  std::vector<Candidate> steady_;
  double sweep_rad_{};
  RoleProposal proposal_;
};

/// So many decimals that the travel shows three digits.
std::string degrees(double rad, double travel_rad) {
  const double travel_deg = joint::degrees_per_rad * travel_rad;
  const double digits = travel_deg > 0 ? std::ceil(2 - std::log10(travel_deg)) : 2;
  const int decimals = static_cast<int>(std::clamp(digits, 0.0, 6.0));
  const double shown = joint::degrees_per_rad * rad;
  const double half_a_digit = 0.5 * std::pow(10.0, -decimals);
  return fmt::format("{:.{}f}°", std::abs(shown) < half_a_digit ? 0.0 : shown, decimals);
}

}  // namespace

RoleProposal propose_roles(const std::vector<LogSurvey>& logs, const std::vector<JointInLog>& joint,
                           bool has_no_gravity) {
  return RoleChooser(logs, joint, has_no_gravity).choose();
}

namespace {

std::string describe_motion(const motion::MotionSegment& s) {
  const double travel = s.travel_rad();
  const std::string range = degrees(s.lowest_rad, travel) + " to " + degrees(s.highest_rad, travel);
  const double middle = (s.lowest_rad + s.highest_rad) / 2;
  const std::string speed = fmt::format("{:.3g} deg/s", joint::degrees_per_rad * s.speed_rad_s);
  switch (s.kind) {
    case motion::MotionKind::rest:
      return fmt::format("at {:.4g}°", joint::degrees_per_rad * middle);
    case motion::MotionKind::constant_speed:
      return s.direction != 0 ? fmt::format("{}{}, {}", s.direction < 0 ? "-" : "+", speed, range)
                              : fmt::format("±{}, {} strokes, {}", speed, s.strokes, range);
    case motion::MotionKind::slow_sweep:
    case motion::MotionKind::oscillation: {
      const std::string often =
          s.frequency_Hz > 0 ? fmt::format("{:.3g} Hz, {:.3g} cycles, ", s.frequency_Hz, s.cycles())
                             : fmt::format("{} strokes, ", s.strokes);
      if (s.kind == motion::MotionKind::slow_sweep) return often + range + ", up to " + speed;
      return fmt::format("{}±{} about {:.4g}°", often, degrees(travel / 2, travel),
                         joint::degrees_per_rad * middle);
    }
    case motion::MotionKind::break_away_ramp:
      return fmt::format("effort {} by {:.3g} a second, the joint moves {:.2g}°{}",
                         s.effort_rate < 0 ? "falls" : "rises", std::abs(s.effort_rate),
                         joint::degrees_per_rad * travel,
                         s.joint_slid ? ", mostly at the end" : "");
    case motion::MotionKind::varying:
      return range;
  }
  return range;
}

}  // namespace

std::string describe(const motion::MotionSegment& s) {
  return describe_motion(s) + (s.phase.empty() ? "" : ", in " + in_quotes(s.phase));
}

}  // namespace tribolog::inspect::survey
