#include "method/model/cells.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

#include "base/parallel_for.h"
#include "statistics/order_statistics.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::model {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using std::numbers::pi;

constexpr std::size_t most_cells = 3000;
constexpr double kernel_s = 0.01;  // half of it, at high rates
constexpr double slowest_share = 0.03;
constexpr double steady_share = 0.05;  // of a sweep: slower ones are about to turn round
constexpr double slowest_share_of_run = 0.2;
constexpr double speed_ratio = 1.3;  // of neighbouring bins
constexpr Index fewest_repeated = 4;
constexpr double gap_intervals = 20;

/// A recording's samples at even distances, smoothed, without a gap in time.
struct Motion {
  int recording{};
  bool is_run{};
  double interval_s{};
  Index half{};  // h of the kernel
  ArrayXd time_s, q, torque, smooth_torque, cos, sin, speed, acceleration, jerk;
  struct Other {
    ArrayXd q, acceleration;  // empty: not logged
  };
  std::array<ArrayXd, 4> motor;  // as Cell::motor
  std::vector<Other> others;
};

/// (x[i+h] - x[i-h]) / (2 h dt); 0 at the ends, of which nothing is used.
ArrayXd slope(const ArrayXd& x, Index h, double dt) {
  ArrayXd d = ArrayXd::Zero(x.size());
  const Index inner = x.size() - 2 * h;
  d.segment(h, inner) = (x.tail(inner) - x.head(inner)) / (2 * static_cast<double>(h) * dt);
  return d;
}

/// Mean over the intervals of `slope`: samples at its ends count half.
ArrayXd mean_over(const ArrayXd& x, Index h) {
  ArrayXd m = x;
  const double about = x.mean();
  double sum = 0;
  for (Index k = 0; k <= 2 * h; ++k) sum += x[k] - about;
  for (Index i = h; i + h < x.size(); ++i) {
    m[i] = about + (sum - 0.5 * (x[i - h] + x[i + h] - 2 * about)) / (2 * static_cast<double>(h));
    if (i + h + 1 < x.size()) sum += x[i + h + 1] - x[i - h];
  }
  return m;
}

/// Cosine and sine, and those of twice the angle.
struct Turned {
  ArrayXd cos, sin;

  explicit Turned(const ArrayXd& angle) : cos(angle.size()), sin(angle.size()) {
    for (Index i = 0; i < angle.size(); ++i) {
      cos[i] = std::cos(angle[i]);
      sin[i] = std::sin(angle[i]);
    }
  }
  [[nodiscard]] ArrayXd cos_of_twice() const { return 2 * cos.square() - 1; }
  [[nodiscard]] ArrayXd sin_of_twice() const { return 2 * sin * cos; }
};

/// Two means by the trapezoidal rule to those of the integrals, as slopes are: less a sixth of the
/// second difference, which is all that their errors are up to the fourth order.
ArrayXd as_integrals(const ArrayXd& x) {
  ArrayXd y = x;
  const Index inner = x.size() - 2;
  y.segment(1, inner) -= (x.head(inner) - 2 * x.segment(1, inner) + x.tail(inner)) / 6;
  return y;
}

/// Samples that say something: of a row that is repeated for a while, the first alone.
std::vector<std::size_t> distinct_samples(const joint::Recording& r) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < r.size();) {
    std::size_t end = i + 1;
    while (end < r.size() && r.q_rad[end] == r.q_rad[i] && r.torque_Nm[end] == r.torque_Nm[i]) {
      ++end;
    }
    const bool repeats = end - i > static_cast<std::size_t>(fewest_repeated);
    for (std::size_t k = i; k < (repeats ? i + 1 : end); ++k) kept.push_back(k);
    i = end;
  }
  return kept;
}

/// Samples of `r` from one gap in time to the next, at even distances.
/// @param lag_s of the torque, which is read so much later.
void add_motions(const joint::Recording& r, int index, double n, double lag_s,
                 std::vector<Motion>& motions) {
  const std::vector<std::size_t> kept = distinct_samples(r);
  const auto [least, most] = std::minmax_element(r.torque_Nm.begin(), r.torque_Nm.end());
  if (kept.size() < 20 || *least == *most) return;  // a dead torque says nothing
  std::vector<double> steps;
  for (std::size_t k = 1; k < kept.size(); ++k)
    steps.push_back(r.t_s[kept[k]] - r.t_s[kept[k - 1]]);
  const double usual = statistics::median(steps);
  for (std::size_t first = 0; first < kept.size();) {
    std::size_t last = first;
    while (last + 1 < kept.size() && steps[last] <= gap_intervals * usual) ++last;
    const double from = r.t_s[kept[first]];
    const double length = r.t_s[kept[last]] - from;
    // Stamps of a few at once make the usual step much smaller than the mean one.
    const double dt =
        std::max(usual, 0.5 * length / std::max(1.0, static_cast<double>(last - first)));
    const std::size_t next = last + 1;
    if (last - first < 20 || !(dt > 0)) {
      first = next;
      continue;
    }
    const auto count = static_cast<Index>(length / dt + 1 + 1e-9);
    const Index h = std::clamp<Index>(std::lround(kernel_s / dt), dt < 0.04 ? 3 : 1, 20);
    if (count > 8 * h + 8) {
      Motion m;
      m.recording = index;
      m.is_run = r.role == joint::Role::constant_speed;
      m.interval_s = dt;
      m.half = h;
      m.time_s = ArrayXd::LinSpaced(count, from, from + static_cast<double>(count - 1) * dt);
      const auto at_even_times = [&](const std::vector<double>& values, double later_s = 0) {
        ArrayXd even(count);
        std::size_t k = first;
        for (Index i = 0; i < count; ++i) {
          const double t = m.time_s[i] + later_s;
          while (k + 1 < last && r.t_s[kept[k + 1]] < t) ++k;
          const std::size_t a = kept[k];
          const std::size_t b = kept[std::min(k + 1, last)];
          const double step = r.t_s[b] - r.t_s[a];
          const double share = step > 0 ? std::clamp((t - r.t_s[a]) / step, 0.0, 1.0) : 0;
          even[i] = values[a] + share * (values[b] - values[a]);
        }
        return even;
      };
      m.q = at_even_times(r.q_rad);
      m.torque = at_even_times(r.torque_Nm, lag_s);
      for (const std::vector<double>& other : r.others_q_rad) {
        Motion::Other& one = m.others.emplace_back();
        if (other.empty()) continue;
        one.q = at_even_times(other);
        one.acceleration = slope(slope(one.q, h, dt), h, dt);
      }
      const auto smooth = [h](const ArrayXd& x) {
        return as_integrals(mean_over(mean_over(x, h), h));
      };
      const ArrayXd once = n * slope(m.q, h, dt);
      m.speed = mean_over(once, h);
      m.acceleration = slope(once, h, dt);
      m.jerk = slope(m.acceleration, h, dt);
      m.smooth_torque = smooth(m.torque);
      const Turned joint(m.q);
      m.cos = smooth(joint.cos);
      m.sin = smooth(joint.sin);
      const Turned motor(n * m.q);
      m.motor = {smooth(motor.cos), smooth(motor.sin), smooth(motor.cos_of_twice()),
                 smooth(motor.sin_of_twice())};
      motions.push_back(std::move(m));
    }
    first = next;
  }
}

/// Mean over up to `reach` samples on either side.
ArrayXd mean_about(const ArrayXd& x, Index reach) {
  ArrayXd mean(x.size());
  const double about = x.mean();
  double sum = 0;
  Index from = 0;
  Index end = 0;
  for (Index i = 0; i < x.size(); ++i) {
    for (; end < std::min(x.size(), i + reach + 1); ++end) sum += x[end] - about;
    for (; from < i - reach; ++from) sum -= x[from] - about;
    mean[i] = about + sum / static_cast<double>(end - from);
  }
  return mean;
}

/// Of values along a motion, of which some thousands tell a quantile as well as all.
template <typename Values>
double usual_value(const Eigen::ArrayBase<Values>& values, double share) {
  constexpr Index enough = 4096;
  const Index stride = 1 + (values.size() - 1) / enough;
  std::vector<double> some;
  some.reserve(static_cast<std::size_t>(values.size() / stride + 1));
  for (Index i = 0; i < values.size(); i += stride) some.push_back(values.coeff(i));
  return statistics::value_at_share(std::move(some), share);
}

constexpr double beyond_noise = 3;

/// Of motor speed: below it a sample belongs to no stroke.
double slowest_speed(const Motion& m, double top) {
  const ArrayXd rough = m.speed - mean_about(m.speed, 4 * m.half + 1);
  const double noise = statistics::normal_sd_by_median_size * usual_value(rough.abs(), 0.5);
  return std::max(slowest_share * top, beyond_noise * noise);
}

/// Standard deviation that the angle's noise or steps make, by fourth differences: a motion has
/// next to none between samples, but a few where it jumps.
double acceleration_noise(const Motion& m, double n) {
  const Index inner = m.q.size() - 4;
  const auto at = [&](Index shift) { return m.q.segment(shift, inner); };
  const ArrayXd square = (at(0) - 4 * at(1) + 6 * at(2) - 4 * at(3) + at(4)).square();
  constexpr double all_but_jumps = 0.995;
  const double most = usual_value(square, all_but_jumps);
  const double q_variance = (square <= most).select(square, 0).mean() / 70;
  const double reach = 2 * static_cast<double>(m.half) * m.interval_s;
  return n * std::sqrt(6 * q_variance) / (reach * reach);
}

/// Cell::others
std::vector<double> others_of(const Motion& m, const std::vector<Index>& samples) {
  std::vector<double> means(values_of_other * m.others.size(), 0.0);
  const double share = 1 / static_cast<double>(samples.size());
  for (std::size_t k = 0; k < m.others.size(); ++k) {
    const Motion::Other& other = m.others[k];
    if (other.q.size() == 0) continue;
    double* const mean = means.data() + values_of_other * k;
    for (const Index i : samples) {
      const double q = m.q[i];
      const double its = other.q[i];
      std::size_t at = 0;
      for (const double angle : {its, q + its, q - its}) {
        mean[at++] += share * std::cos(angle);
        mean[at++] += share * std::sin(angle);
      }
      mean[at] += share * other.acceleration[i];
    }
  }
  return means;
}

class CellMaker {
 public:
  CellMaker(double n, double bin_width, bool turning)
      : n_(n), width_(bin_width), turning_(turning) {}

  void add(const Motion& m, double session_s) {
    const double top = usual_value(m.speed.abs(), 0.95);
    const double slowest = slowest_speed(m, top);
    calm_ = beyond_noise * acceleration_noise(m, n_);
    const Index w = 4 * m.half + 1;
    const Index count = m.q.size();
    const ArrayXd step = m.jerk.abs() * (0.5 * static_cast<double>(w - 1) * m.interval_s);
    const double abrupt =
        std::max(0.1 * usual_value(m.acceleration.abs(), 0.98), 6 * usual_value(step, 0.5));
    const auto side = [&](Index i) {
      if (i < w / 2 + 1 || i >= count - w / 2 - 1 || std::abs(m.speed[i]) <= slowest) return 0;
      return m.speed[i] > 0 ? 1 : -1;
    };
    for (Index from = 0; from < count;) {
      Index to = from + 1;
      while (to < count && side(to) == side(from)) ++to;
      if (side(from) != 0 && to - from >= w + 4) {
        add_stroke(m, from + w / 2, to - w / 2, side(from), step, abrupt, session_s);
      }
      from = to;
    }
  }

  std::vector<Cell> cells;

 private:
  void add_stroke(const Motion& m, Index from, Index to, int direction, const ArrayXd& step,
                  double abrupt, double session_s) {
    const double way = std::abs(m.q[to - 1] - m.q[from]);
    if (n_ * way < 0.01) return;
    const double top = usual_value(m.speed.segment(from, to - from).abs(), 0.95);
    const double behind_reversal = 0.05 * std::min(way, 0.5);
    std::vector<Index> used;
    for (Index i = from; i < to; ++i) {
      if (std::abs(m.q[i] - m.q[from]) <= behind_reversal || !(step[i] < abrupt)) continue;
      if (m.is_run && std::abs(m.speed[i]) < slowest_share_of_run * top) continue;
      used.push_back(i);
    }
    if (used.size() < 5) return;
    std::map<std::tuple<long, long, int>, std::vector<Index>> bins;
    for (Index i : used) {
      const double angle = turning_ ? m.q[i] - 2 * pi * std::floor(m.q[i] / (2 * pi)) : m.q[i];
      const double a = m.acceleration[i];
      // Bins by a noise would make that noise an acceleration.
      const int sense = std::abs(a) > std::max(0.5 * top, calm_) ? (a > 0 ? 2 : 1) : 0;
      bins[{static_cast<long>(std::floor(angle / width_)),
            std::lround(std::log(std::abs(m.speed[i])) / std::log(speed_ratio)), sense}]
          .push_back(i);
    }
    const std::size_t fewest = m.interval_s < 0.006 ? 3 : 1;
    for (const auto& [key, samples] : bins) {
      if (samples.size() >= fewest) add_cell(m, samples, direction, session_s);
    }
    ++stroke_;
  }

  void add_cell(const Motion& m, const std::vector<Index>& samples, int direction,
                double session_s) {
    Cell c;
    const auto count = static_cast<double>(samples.size());
    for (Index i : samples) {
      const double rate = m.speed[i] / n_;
      c.torque_Nm += m.smooth_torque[i] / count;
      c.cos_q += m.cos[i] / count;
      c.sin_q += m.sin[i] / count;
      for (std::size_t k = 0; k < c.motor.size(); ++k) c.motor[k] += m.motor[k][i] / count;
      c.q_rad += m.q[i] / count;
      c.speed_rad_s += std::abs(m.speed[i]) / count;
      c.acceleration_rad_s2 += m.acceleration[i] / count;
      c.jerk_rad_s3 += m.jerk[i] / count;
      c.cos_rate -= m.sin[i] * rate / count;
      c.sin_rate += m.cos[i] * rate / count;
      c.time_s += (session_s + m.time_s[i]) / count;
    }
    c.others = others_of(m, samples);
    double tt = 0;
    double ty = 0;
    double yy = 0;
    for (Index i : samples) {
      const double t = session_s + m.time_s[i] - c.time_s;
      const double y = m.torque[i] - c.torque_Nm;
      tt += t * t;
      ty += t * y;
      yy += y * y;
    }
    c.scatter_Nm = samples.size() < 5
                       ? std::numeric_limits<double>::quiet_NaN()
                       : std::sqrt(std::max(0.0, yy - (tt > 0 ? ty * ty / tt : 0)) / count);
    c.count = count;
    c.direction = direction;
    c.is_run = m.is_run ? 1 : 0;
    c.interval_s = m.interval_s;
    c.stroke = stroke_;
    c.recording = m.recording;
    cells.push_back(c);
  }

  double n_;
  double width_;
  bool turning_;
  double calm_{};  // of an acceleration that may be noise
  int stroke_{};
};

/// Those of one file as one stroke: they have no time.
void add_points(const std::vector<joint::FrictionPoints>& points, int stroke, int recording,
                std::vector<Cell>& cells) {
  for (const joint::FrictionPoints& of : points) {
    for (std::size_t i = 0; i < of.size(); ++i) {
      if (of.speed_rad_s[i] == 0) continue;
      Cell c;
      c.direction = of.speed_rad_s[i] > 0 ? 1 : -1;
      c.speed_rad_s = std::abs(of.speed_rad_s[i]);
      c.torque_Nm = of.torque_Nm[i];
      c.count = 1;
      c.is_run = 1;
      c.has_place = 0;
      c.scatter_Nm = std::numeric_limits<double>::quiet_NaN();
      c.stroke = stroke;
      c.recording = recording;
      cells.push_back(c);
    }
    ++stroke;
    ++recording;
  }
}

/// What to add to the time of each recording for that of the session: recordings one after the
/// other, or the log's own clock where it goes on.
std::vector<double> session_shifts(const std::vector<const joint::Recording*>& recordings) {
  constexpr double pause_s = 5;
  std::vector<double> shifts;
  const joint::Recording* last = nullptr;
  double now = 0;
  for (const joint::Recording* r : recordings) {
    if (r->t_s.empty()) {
      shifts.push_back(now);
      continue;
    }
    if (last != nullptr) {
      const double pause = r->t_s.front() - last->t_s.back();
      now += last->name == r->name && pause >= 0 ? pause : pause_s;
    }
    shifts.push_back(now - r->t_s.front());
    now += r->t_s.back() - r->t_s.front();
    last = r;
  }
  return shifts;
}

/// The middle of a recording as a row.
Cell middle_of(const joint::Recording& r, double gear_ratio, double session_s) {
  Cell c;
  const auto count = static_cast<double>(r.size());
  for (const double q : r.q_rad) {
    c.cos_q += std::cos(q) / count;
    c.sin_q += std::sin(q) / count;
    const double motor = gear_ratio * q;
    const std::array turned{std::cos(motor), std::sin(motor), std::cos(2 * motor),
                            std::sin(2 * motor)};
    for (std::size_t k = 0; k < turned.size(); ++k) c.motor[k] += turned[k] / count;
    c.q_rad += q / count;
  }
  c.time_s = session_s + (r.t_s.front() + r.t_s.back()) / 2;
  c.direction = 1;
  return c;
}

/// Larger bins where they are too many. @param session_shifts_s of each recording.
std::vector<Cell> cells_of(const std::vector<Motion>& motions,
                           const std::vector<double>& session_shifts_s, double gear_ratio,
                           double span_rad, bool is_turning) {
  std::vector<Cell> cells;
  for (double coarse = 1; coarse <= 16; coarse *= 2) {
    double width = std::min(span_rad, 2 * pi) / (is_turning ? 24 : 48) * coarse;
    if (gear_ratio > 1.5) {  // whole turns of the motor: ripple of whole orders averages out
      const double turn = 2 * pi / gear_ratio;
      width = std::max(1.0, std::round(width / turn)) * turn;
    }
    CellMaker maker(gear_ratio, std::max(width, 1e-6), is_turning);
    for (const Motion& m : motions) {
      maker.add(m, session_shifts_s[static_cast<std::size_t>(m.recording)]);
    }
    cells = std::move(maker.cells);
    if (cells.size() <= most_cells) break;
  }
  return cells;
}

}  // namespace

double slowest_stated(const Cells& cells) {
  std::map<int, std::vector<double>> sweeps;
  double slowest = std::numeric_limits<double>::infinity();
  for (const Cell& row : cells.rows) {
    if (row.is_run == 0) {
      sweeps[row.recording].push_back(row.speed_rad_s);
    } else {
      slowest = std::min(slowest, row.speed_rad_s);
    }
  }
  for (const auto& [recording, speeds] : sweeps) {
    const double least = *std::min_element(speeds.begin(), speeds.end());
    const double top = statistics::value_at_share(speeds, 0.95);
    slowest = std::min(slowest, std::max(least, steady_share * top));
  }
  return slowest;
}

double value_at_share(const ArrayXd& values, double share) {
  return statistics::value_at_share({values.begin(), values.end()}, share);
}

double median(const ArrayXd& values) { return statistics::median({values.begin(), values.end()}); }

Eigen::MatrixXd plain_columns(const Cells& cells) {
  const ArrayXd s = cells.of(&Cell::direction);
  Eigen::MatrixXd x(cells.size(), 6);
  x << cells.of(&Cell::cos_q).matrix(), cells.of(&Cell::sin_q).matrix(),
      Eigen::VectorXd::Ones(cells.size()), cells.of(&Cell::acceleration_rad_s2).matrix(),
      s.matrix(), (s * cells.of(&Cell::speed_rad_s)).matrix();
  return x;
}

ArrayXd Cells::of(double Cell::* value) const {
  ArrayXd all(size());
  for (Index i = 0; i < size(); ++i) all[i] = rows[static_cast<std::size_t>(i)].*value;
  return all;
}

std::pair<double, double> Cells::session_s() const {
  double first = std::numeric_limits<double>::infinity();
  double last = -first;
  for (const std::vector<Cell>* all : {&rows, &contacts.loops, &contacts.ramps}) {
    for (const Cell& row : *all) {
      first = std::min(first, row.time_s);
      last = std::max(last, row.time_s);
    }
  }
  return {first, last};
}

Cells make_cells(const std::vector<const joint::Recording*>& recordings,
                 const std::vector<joint::FrictionPoints>& points, double gear_ratio,
                 bool has_gravity, double lag_s) {
  std::vector<std::vector<Motion>> of_each(recordings.size());
  parallel_for(recordings.size(), [&](std::size_t i) {
    const joint::Recording& r = *recordings[i];
    const bool is_used = r.role == joint::Role::rough_sweep ||
                         r.role == joint::Role::precise_sweep ||
                         r.role == joint::Role::constant_speed;
    if (is_used && !r.torque_Nm.empty()) {
      add_motions(r, static_cast<int>(i), gear_ratio, lag_s, of_each[i]);
    }
  });
  std::vector<Motion> motions;
  for (std::vector<Motion>& some : of_each)
    std::move(some.begin(), some.end(), std::back_inserter(motions));
  Cells made;
  made.gear_ratio = gear_ratio;
  const std::vector<double> shifts = session_shifts(recordings);
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    const joint::Recording& r = *recordings[i];
    if (r.t_s.empty()) continue;
    if (r.role == joint::Role::oscillation) {
      made.contacts.loops.push_back(middle_of(r, gear_ratio, shifts[i]));
    } else if (r.role == joint::Role::break_away) {
      made.contacts.ramps.push_back(middle_of(r, gear_ratio, shifts[i]));
    }
  }
  if (!motions.empty()) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Motion& m : motions) {
      low = std::min(low, m.q.minCoeff());
      high = std::max(high, m.q.maxCoeff());
    }
    made.is_turning = high - low > 1.3 * 2 * pi && !has_gravity;
    made.rows = cells_of(motions, shifts, gear_ratio, high - low, made.is_turning);
  }
  const int strokes = made.rows.empty() ? 0 : made.rows.back().stroke + 1;
  add_points(points, strokes, static_cast<int>(recordings.size()), made.rows);
  return made;
}

}  // namespace tribolog::method::model
