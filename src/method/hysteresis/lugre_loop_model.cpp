#include "method/hysteresis/lugre_loop_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "friction/dual.h"
#include "friction/exponential_step.h"
#include "simulate/bristle_integrator.h"
#include "simulate/motion.h"
#include "statistics/order_statistics.h"

namespace tribolog::method::hysteresis {
namespace {

using Shared = LuGreShared;

// What z depends on, in the order of its derivatives; at micro-speed the first two alone.
enum DualIndex { by_log_rest, by_start, by_log_share, by_fall };
constexpr int at_micro_speed = 2;
constexpr int at_any_speed = 4;

/// Most halvings of a step between two samples. A Stribeck velocity that a solver tries in passing
/// may be so small that no step is ever short enough; one that a log can show needs fewer.
constexpr int deepest_halving_in_a_fit = 5;

/// g(w) with its derivatives: level * (c + (1 - c) exp(-b w^2)).
template <int N>
struct SteadyDeflection {
  static constexpr bool same_at_all_speeds = N == at_micro_speed;
  double rest_rad, share, fall;

  friction::Dual<N> operator()(double w) const {
    friction::Dual<N> g(rest_rad);
    g.by[by_log_rest] = rest_rad;
    if constexpr (N == at_any_speed) {
      const double e = friction::exp_nonpositive(-fall * w * w);
      g.value = rest_rad * (share + (1 - share) * e);
      g.by[by_log_rest] = g.value;
      g.by[by_log_share] = rest_rad * share * (1 - e);
      g.by[by_fall] = -rest_rad * (1 - share) * w * w * e;
    }
    return g;
  }
};

struct PlainDeflection {
  static constexpr bool same_at_all_speeds = false;
  double rest_rad, share, fall;
  double operator()(double w) const {
    return rest_rad * (share + (1 - share) * friction::exp_nonpositive(-fall * w * w));
  }
};

template <class Deflection>
Deflection deflection_of(const Shared::Vector& p) {
  return {Shared::largest_deflection_rad(p), std::exp(p(Shared::log_share)), p(Shared::fall)};
}

}  // namespace

double LuGreShared::largest_deflection_rad(const Vector& shared) {
  return std::exp(shared(log_static) - shared(log_stiffness));
}

/// Samples that are compared as one row: of the recording from `first` to before `end`.
struct LuGreLoopModel::Together {
  std::size_t first, end;
  double way_rad{};
  bool turns{};
  bool is_smooth{};
};

/// Finds the rows through which the model is smooth, so that one evaluation is enough: not just
/// after a reversal or the start, where the bristle bends over within a short travel, nor next to a
/// reversal or the end.
void LuGreLoopModel::tell_smooth_rows(std::vector<Together>& rows) {
  // Of a torque that bends over as exp(-x / d), no d leaves more than 1e-5 unseen then.
  constexpr double ways_to_bend_over = 5;
  double since_turn = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    Together& row = rows[k];
    const bool goes_on = k + 1 < rows.size() && !rows[k + 1].turns;
    row.is_smooth = goes_on && !row.turns && since_turn > ways_to_bend_over * row.way_rad;
    since_turn = row.turns ? 0 : since_turn + row.way_rad;
  }
}

std::vector<LuGreLoopModel::Together> LuGreLoopModel::rows_of(const joint::Recording& recording,
                                                              const LuGreGrain& grain) const {
  std::vector<Together> rows;
  const std::size_t step = grain.stride * grain.samples_in_row;
  const std::size_t most = grain.most_samples / grain.samples_in_row;
  for (std::size_t i = 0; i < recording.size() && rows.size() < most; i += step) {
    rows.push_back({i, std::min(i + step, recording.size())});
  }
  double before = motion_->speed(0);
  for (Together& row : rows) {
    const std::size_t next = std::min(row.end, recording.size() - 1);
    const double after = motion_->speed(recording.t_s[next] - recording.t_s.front());
    row.turns = before * after <= 0;
    row.way_rad = std::abs(before + after) / 2 * (recording.t_s[next] - recording.t_s[row.first]);
    before = after;
  }
  tell_smooth_rows(rows);
  return rows;
}

/// Each sample is a row. @return the instants of the samples
std::vector<double> LuGreLoopModel::look_at_samples(const joint::Recording& recording,
                                                    const LuGreGrain& grain) {
  std::vector<double> instants;
  const std::size_t samples = std::min(recording.size() / grain.stride + 1, grain.most_samples);
  instants.reserve(samples);
  measured_Nm_.reserve(samples);
  for (std::size_t i = 0; i < recording.size() && instants.size() < grain.most_samples;
       i += grain.stride) {
    instants.push_back(recording.t_s[i] - recording.t_s.front());
    measured_Nm_.push_back(recording.torque_Nm[i]);
  }
  return instants;
}

/// @return the instants at which the model is evaluated
std::vector<double> LuGreLoopModel::look_at_rows(const joint::Recording& recording,
                                                 const LuGreGrain& grain) {
  std::vector<double> instants;
  for (const Together& row : rows_of(recording, grain)) {
    const double start = recording.t_s[row.first] - recording.t_s.front();
    double count = 0;
    double mean = 0;  // of the times since `start`: those of a long log would drown the variance
    double square = 0;
    double torque = 0;
    for (std::size_t i = row.first; i < row.end; i += grain.stride) {
      const double t = recording.t_s[i] - recording.t_s[row.first];
      count += 1;
      mean += t;
      square += t * t;
      torque += recording.torque_Nm[i];
      if (!row.is_smooth) instants.push_back(start + t);
    }
    mean /= count;
    measured_Nm_.push_back(torque / count);
    if (row.is_smooth) instants.push_back(start + mean);
    row_of_instant_.resize(instants.size(), static_cast<Eigen::Index>(row_.size()));
    row_.push_back({start + mean, row.is_smooth ? square / count - mean * mean : 0,
                    row.is_smooth ? 1 : static_cast<std::size_t>(count)});
  }
  return instants;
}

LuGreLoopModel::LuGreLoopModel(const joint::Recording& recording,
                               std::shared_ptr<const simulate::Motion> motion, double gear_ratio,
                               double q_peak_rad, const LuGreGrain& grain)
    : motion_(std::move(motion)), samples_in_row_(grain.samples_in_row) {
  const std::vector<double> instants =
      samples_in_row_ == 1 ? look_at_samples(recording, grain) : look_at_rows(recording, grain);
  add_instants(instants, gear_ratio, q_peak_rad);
  add_ways(instants);
  if (!(grain.compared_from_s > 0)) return;
  const std::vector<double> times = row_times_s();
  rows_left_out_ =
      std::lower_bound(times.begin(), times.end(), grain.compared_from_s) - times.begin();
}

void LuGreLoopModel::add_instants(const std::vector<double>& times_s, double gear_ratio,
                                  double q_peak_rad) {
  for (auto* values : {&angle_, &speed_, &acceleration_, &cosine_}) values->reserve(times_s.size());
  time_s_ = times_s;
  for (const double t : times_s) {
    angle_.push_back(motion_->angle(t));
    speed_.push_back(motion_->speed(t));
    acceleration_.push_back(motion_->acceleration(t));
    cosine_.push_back(std::cos(angle_.back() / gear_ratio - q_peak_rad));
  }
}

void LuGreLoopModel::add_ways(const std::vector<double>& instants) {
  start_speed_ = motion_->speed(0);
  starts_at_instant_ = !(instants.front() > 0);
  std::size_t pieces = instants.size() + 1;
  for (std::size_t i = 0; i + 1 < instants.size(); ++i) pieces += speed_[i] * speed_[i + 1] < 0;
  pieces_.reserve(pieces);
  distance_rad_.reserve(pieces);
  if (!starts_at_instant_) add_way(0, instants.front(), start_speed_, speed_.front());
  for (std::size_t i = 0; i + 1 < instants.size(); ++i) {
    add_way(instants[i], instants[i + 1], speed_[i], speed_[i + 1]);
  }
}

Eigen::Index LuGreLoopModel::row_of(Eigen::Index instant) const {
  return samples_in_row_ == 1 ? instant : row_of_instant_[static_cast<std::size_t>(instant)];
}

std::vector<double> LuGreLoopModel::row_times_s() const {
  if (samples_in_row_ == 1) return time_s_;
  std::vector<double> out;
  for (const Row& row : row_) out.push_back(row.time_s);
  return out;
}

Eigen::VectorXd LuGreLoopModel::row_speeds_rad_s() const {
  const std::vector<double> times = row_times_s();
  Eigen::VectorXd speeds(rows());
  for (Eigen::Index k = 0; k < rows(); ++k) {
    speeds(k) = motion_->speed(times[static_cast<std::size_t>(k)]);
  }
  return speeds;
}

Eigen::VectorXd LuGreLoopModel::measured() const {
  return Eigen::Map<const Eigen::VectorXd>(measured_Nm_.data(), rows());
}

void LuGreLoopModel::take_off(const Eigen::VectorXd& torque_Nm) {
  Eigen::Map<Eigen::VectorXd>(measured_Nm_.data(), rows()) -= torque_Nm;
}

/// Adds one piece, or two where the motion reverses within it.
void LuGreLoopModel::add_way(double from_s, double to_s, double start_speed, double end_speed) {
  const auto add = [&](double a, double b, double wa, double wb, bool ends_at_instant) {
    const double wm = motion_->speed((a + b) / 2);
    const double way = (b - a) / 6 * (wa + 4 * wm + wb);
    pieces_.push_back({b, wm, wb, way < 0, ends_at_instant});
    distance_rad_.push_back(std::abs(way));
  };
  if (start_speed * end_speed < 0) {
    const double turn = simulate::reversal_time(*motion_, from_s, to_s, start_speed < 0);
    add(from_s, turn, start_speed, 0.0, false);
    add(turn, to_s, 0.0, end_speed, true);
  } else {
    add(from_s, to_s, start_speed, end_speed, true);
  }
}

template <class Scalar, class Deflection, class Visit>
void LuGreLoopModel::run(const Deflection& g, const Scalar& start, Visit visit) const {
  Scalar z = start;
  std::size_t instant = 0;
  const auto visit_instant = [&](const Scalar& inverse_g) {
    const double w = speed_[instant];
    const Scalar rate = w - (std::abs(w) * z) * inverse_g;
    visit(static_cast<Eigen::Index>(instant), z, rate);
    ++instant;
  };
  Scalar g0 = g(start_speed_);
  Scalar inverse0 = Scalar(1.0 / g0);
  if (starts_at_instant_) visit_instant(inverse0);
  if constexpr (Deflection::same_at_all_speeds) {
    const Scalar backward = -g0;
    // They depend on no z: all exponentials at once, in a loop that vectorises.
    std::vector<double> decays(pieces_.size());
    const double scale = -friction::value_of(inverse0);
    for (std::size_t k = 0; k < decays.size(); ++k) {
      decays[k] = friction::exp_nonpositive(scale * distance_rad_[k]);
    }
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      const Scalar length = distance_rad_[k] * inverse0;
      z = friction::relaxed_to<Scalar>(pieces_[k].backward ? backward : g0,
                                       friction::chained(decays[k], -decays[k], length), z);
      if (pieces_[k].ends_at_instant) visit_instant(inverse0);
    }
    return;
  }
  double from_s = 0;
  double start_speed = start_speed_;
  for (const Piece& p : pieces_) {
    const Scalar gm = g(p.middle_speed);
    const Scalar g1 = g(p.end_speed);
    const Scalar inverse1 = Scalar(1.0 / g1);
    const friction::StepShape<Scalar> shape =
        friction::step_shape<Scalar>(start_speed, p.middle_speed, p.end_speed, g0, gm, g1, inverse0,
                                     Scalar(1.0 / gm), inverse1, p.end_s - from_s);
    const bool rough =
        std::abs(friction::value_of(shape.c2)) > simulate::roughest_step * friction::value_of(gm) ||
        simulate::reverses(start_speed, p.middle_speed, p.end_speed);
    z = rough ? simulate::careful_step<Scalar>(g, *motion_, from_s, p.end_s, start_speed,
                                               p.end_speed, z, deepest_halving_in_a_fit)
              : friction::relaxed(shape, z);
    from_s = p.end_s;
    start_speed = p.end_speed;
    g0 = g1;
    inverse0 = inverse1;
    if (p.ends_at_instant) visit_instant(inverse1);
  }
}

template <int N>
void LuGreLoopModel::evaluate_with(const Shared::Vector& p, const LuGreLocal& local,
                                   Eigen::VectorXd& residuals, Rows& derivatives) const {
  const double s0 = std::exp(p(Shared::log_stiffness));
  const double s1 = p(Shared::damping);
  const double s2 = p(Shared::viscous);
  const double inertia = p(Shared::inertia);
  run<friction::Dual<N>>(
      deflection_of<SteadyDeflection<N>>(p),
      friction::Dual<N>::parameter(local.start_rad, by_start),
      [&](Eigen::Index instant, const friction::Dual<N>& z, const friction::Dual<N>& dz) {
        const auto i = static_cast<std::size_t>(instant);
        const Eigen::Index row = row_of(instant);
        residuals(row) += local.gravity_Nm * cosine_[i] + s0 * z.value + s1 * dz.value +
                          s2 * speed_[i] + inertia * acceleration_[i];
        const auto by = [&](int k) {
          const auto at = static_cast<std::size_t>(k);
          return s0 * z.by[at] + s1 * dz.by[at];
        };
        const auto shared = [&](Shared::Index k) -> double& {
          return derivatives(row, local_count + k);
        };
        derivatives(row, 0) += cosine_[i];
        derivatives(row, 1) += by(by_start);
        shared(Shared::log_stiffness) += s0 * z.value - by(by_log_rest);
        shared(Shared::log_static) += by(by_log_rest);
        if constexpr (N == at_any_speed) {
          shared(Shared::log_share) += by(by_log_share);
          shared(Shared::fall) += by(by_fall);
        }
        shared(Shared::damping) += dz.value;
        shared(Shared::viscous) += speed_[i];
        shared(Shared::inertia) += acceleration_[i];
      });
  if (samples_in_row_ > 1) {
    average_over_rows(residuals);
    for (int k = 0; k < columns; ++k) average_over_rows(derivatives.col(k));
  }
  for (Eigen::Index row = 0; row < residuals.size(); ++row) {
    residuals(row) -= measured_Nm_[static_cast<std::size_t>(row)];
  }
  residuals.head(rows_left_out_).setZero();
  derivatives.topRows(rows_left_out_).setZero();
}

/// Turns values at the instants of evaluation into means over the rows' samples. For a row
/// evaluated only at its middle, half the variance of its times, times the second derivative, is
/// added.
void LuGreLoopModel::average_over_rows(Eigen::Ref<Eigen::VectorXd> column) const {
  const Eigen::Index n = column.size();
  const auto row = [&](Eigen::Index k) -> const Row& { return row_[static_cast<std::size_t>(k)]; };
  for (Eigen::Index k = 0; k < n; ++k) column(k) /= static_cast<double>(row(k).instants);
  const auto slope_behind = [&](Eigen::Index k) {
    return (column(k + 1) - column(k)) / (row(k + 1).time_s - row(k).time_s);
  };
  if (n < 3) return;
  double before = slope_behind(0);
  double second = 0;
  for (Eigen::Index k = 1; k + 1 < n; ++k) {
    const double behind = slope_behind(k);
    second = 2 * (behind - before) / (row(k + 1).time_s - row(k - 1).time_s);
    column(k) += row(k).variance_s2 / 2 * second;
    before = behind;
  }
  column(n - 1) += row(n - 1).variance_s2 / 2 * second;
}

void LuGreLoopModel::evaluate(const Shared::Vector& shared, const LuGreLocal& local, bool bends,
                              Eigen::VectorXd& residuals, Rows& derivatives) const {
  residuals.setZero(rows());
  derivatives.setZero(rows(), columns);
  if (bends) {
    evaluate_with<at_any_speed>(shared, local, residuals, derivatives);
  } else {
    evaluate_with<at_micro_speed>(shared, local, residuals, derivatives);
  }
}

Eigen::VectorXd LuGreLoopModel::residuals(const Shared::Vector& p, const LuGreLocal& local) const {
  Eigen::VectorXd out(rows());
  run<double>(deflection_of<PlainDeflection>(p), local.start_rad,
              [&](Eigen::Index row, double z, double dz) {
                const auto i = static_cast<std::size_t>(row);
                out(row) = local.gravity_Nm * cosine_[i] + std::exp(p(Shared::log_stiffness)) * z +
                           p(Shared::damping) * dz + p(Shared::viscous) * speed_[i] +
                           p(Shared::inertia) * acceleration_[i];
              });
  return out - measured();
}

void LuGreLoopModel::bristle(const Shared::Vector& shared, double start_rad,
                             std::vector<double>& z_rad, std::vector<double>& dz_rad_s) const {
  z_rad.resize(speed_.size());
  dz_rad_s.resize(speed_.size());
  run<double>(deflection_of<PlainDeflection>(shared), start_rad,
              [&](Eigen::Index row, double z, double dz) {
                z_rad[static_cast<std::size_t>(row)] = z;
                dz_rad_s[static_cast<std::size_t>(row)] = dz;
              });
}

double LuGreLoopModel::peak_speed_rad_s() const {
  double peak = 0;
  for (const double w : speed_) peak = std::max(peak, std::abs(w));
  return peak;
}

double LuGreLoopModel::middle_rad() const {
  const auto [low, high] = std::minmax_element(angle_.begin(), angle_.end());
  return (*high + *low) / 2;
}

double LuGreLoopModel::motor_amplitude_rad() const {
  const auto [low, high] = std::minmax_element(angle_.begin(), angle_.end());
  return (*high - *low) / 2;
}

double LuGreLoopModel::height_Nm() const {
  return statistics::range_without_ends(
      {measured_Nm_.begin() + rows_left_out_, measured_Nm_.end()});
}

double LuGreLoopModel::mean_torque_Nm() const {
  return measured().tail(rows() - rows_left_out_).mean();
}

}  // namespace tribolog::method::hysteresis
