#include "method/hysteresis/contact_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "base/enum_text.h"
#include "friction/catalogue.h"
#include "statistics/fit_comparison.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::hysteresis {
namespace {

/// The motion of one loop, cut at its reversals.
struct Path {
  std::vector<friction::SpeedStep> steps;
  std::vector<double> angle_rad;          ///< At the start, and at the end of each step.
  std::vector<std::size_t> steps_to_row;  ///< Number of steps before each row.
};

Path path_of(const simulate::Motion& motion, const std::vector<double>& row_times_s) {
  Path path;
  path.angle_rad.push_back(motion.angle(row_times_s.front()));
  const auto go = [&](double from_s, double to_s) {
    // What is cut at a reversal is a hair off it: no speed of the wrong sign.
    const double direction = motion.speed((from_s + to_s) / 2) < 0 ? -1 : 1;
    const auto speed = [&](double t_s) {
      return direction * std::max(0.0, direction * motion.speed(t_s));
    };
    path.steps.push_back({speed(from_s), speed((from_s + to_s) / 2), speed(to_s), to_s - from_s});
    path.angle_rad.push_back(motion.angle(to_s));
  };
  for (std::size_t i = 0; i < row_times_s.size(); ++i) {
    if (i > 0) {
      const double from_s = row_times_s[i - 1];
      const double to_s = row_times_s[i];
      const double before = motion.speed(from_s);
      const double after = motion.speed(to_s);
      if (before * after < 0) {
        const double turn_s = from_s + (to_s - from_s) * before / (before - after);
        go(from_s, turn_s);
        go(turn_s, to_s);
      } else {
        go(from_s, to_s);
      }
    }
    path.steps_to_row.push_back(path.steps.size());
  }
  return path;
}

/// How friction in sliding falls with the speed, as a share of that at rest.
struct Fall {
  double share{1};
  double stribeck_rad_s{1};
  [[nodiscard]] double operator()(double speed_rad_s) const {
    const double x = speed_rad_s / stribeck_rad_s;
    return share + (1 - share) * std::exp(-x * x);
  }
};

/// A law at the rows that are compared.
struct Fitted {
  ContactCandidate candidate;
  Eigen::VectorXd residuals;
};

class Comparison {
 public:
  Comparison(const std::vector<LuGreInput>& loops, const LuGreProblem& problem,
             const std::vector<std::size_t>& block_of_row, const LuGrePoint& lugre,
             double gear_ratio, double q_peak_rad)
      : lugre_(lugre) {
    std::vector<double> lugre_residuals;
    std::size_t top = 0;
    std::vector<double> measured;
    for (std::size_t r = 0; r < loops.size(); ++r) {
      const LuGreLoopModel& model = problem.models()[r];
      const std::shared_ptr<const simulate::Motion> motion = loops[r].motor_motion(gear_ratio);
      const std::vector<double> times = model.row_times_s();
      paths_.push_back(path_of(*motion, times));
      amplitude_rad_ = std::max(amplitude_rad_, model.motor_amplitude_rad());
      peak_speed_rad_s_ = std::max(peak_speed_rad_s_, model.peak_speed_rad_s());
      const Eigen::VectorXd torque = model.measured();
      const Eigen::VectorXd residuals = model.residuals(lugre.shared, lugre.locals[r]);
      double way = 0;
      for (std::size_t i = 0; i < times.size(); ++i) {
        if (i > 0) way += std::abs(motion->angle(times[i]) - motion->angle(times[i - 1]));
        const auto k = static_cast<Eigen::Index>(i);
        if (k < model.rows_left_out() || way < 4 * model.motor_amplitude_rad()) continue;
        rows_.push_back({r, i, motion->speed(times[i]), motion->acceleration(times[i]),
                         std::cos(motion->angle(times[i]) / gear_ratio - q_peak_rad)});
        measured.push_back(torque(k));
        lugre_residuals.push_back(residuals(k));
        blocks_.push_back(block_of_row[top + i]);
      }
      top += times.size();
    }
    measured_ = Eigen::Map<const Eigen::VectorXd>(measured.data(),
                                                  static_cast<Eigen::Index>(measured.size()));
    lugre_residuals_ = Eigen::Map<const Eigen::VectorXd>(lugre_residuals.data(), measured_.size());
  }

  [[nodiscard]] bool is_possible() const { return rows_.size() > 200; }
  [[nodiscard]] const std::vector<std::size_t>& blocks() const { return blocks_; }

  [[nodiscard]] Fitted lugre() const {
    using Shared = LuGreShared;
    return {{ContactLaw::lugre, std::exp(lugre_.shared(Shared::log_stiffness)),
             std::exp(lugre_.shared(Shared::log_static)), rms(lugre_residuals_)},
            lugre_residuals_};
  }

  [[nodiscard]] std::optional<Fitted> elasto_plastic() const {
    std::optional<Fitted> best;
    for (const double times : {0.5, 1.0, 2.0}) {
      Eigen::VectorXd start(2);
      start << std::log(times * level_rad()), 0;
      keep_better(solved(start), best);
    }
    if (!best || !(lugre_.shared(LuGreShared::fall) > 0)) return best;
    const double level = std::log(best->candidate.static_Nm / best->candidate.stiffness_Nm_rad);
    for (const double of_peak : {0.3, 1.0}) {
      Eigen::VectorXd start(4);
      start << level, 0, 1.5, std::log(of_peak * peak_speed_rad_s_);
      keep_better(solved(start), best);
    }
    return best;
  }

  [[nodiscard]] std::optional<Fitted> maxwell_slip() const {
    std::optional<Fitted> best;
    keep_better(maxwell_slip({}), best);
    const double fall = lugre_.shared(LuGreShared::fall);
    if (fall > 0) {
      keep_better(
          maxwell_slip({std::exp(lugre_.shared(LuGreShared::log_share)), 1 / std::sqrt(fall)}),
          best);
    }
    return best;
  }

 private:
  struct Row {
    std::size_t loop, row;
    double speed, acceleration, cosine;
  };

  /// Deflection in sliding, by LuGre.
  [[nodiscard]] double level_rad() const {
    return LuGreShared::largest_deflection_rad(lugre_.shared);
  }
  static double rms(const Eigen::VectorXd& residuals) {
    return std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size()));
  }
  static void keep_better(std::optional<Fitted> one, std::optional<Fitted>& best) {
    if (one && (!best || one->candidate.residual_Nm < best->candidate.residual_Nm))
      best = std::move(one);
  }

  /// Columns of what acts besides the contact, behind `before` others that are left open.
  [[nodiscard]] Eigen::MatrixXd columns_behind(Eigen::Index before) const {
    const auto rows = static_cast<Eigen::Index>(rows_.size());
    Eigen::MatrixXd columns =
        Eigen::MatrixXd::Zero(rows, before + 2 + static_cast<Eigen::Index>(paths_.size()));
    for (Eigen::Index i = 0; i < rows; ++i) {
      const Row& row = rows_[static_cast<std::size_t>(i)];
      columns(i, before) = row.speed;
      columns(i, before + 1) = row.acceleration;
      columns(i, before + 2 + static_cast<Eigen::Index>(row.loop)) = row.cosine;
    }
    return columns;
  }

  // Elasto-plastic: deflection by its parameters, all else linear.

  /// @param p ln of the deflection in sliding, the logit of the share of it that is elastic, and
  /// perhaps the logit of Coulomb over static torque and ln of the Stribeck velocity.
  [[nodiscard]] std::optional<Fitted> at(const Eigen::VectorXd& p) const {
    const auto share_of = [](double logit) { return 1 / (1 + std::exp(-logit)); };
    const double deflection_rad = std::exp(p(0));
    const double coulomb_rad = deflection_rad * (p.size() > 2 ? share_of(p(2)) : 1);
    const double elastic_rad = coulomb_rad * std::clamp(share_of(p(1)), 0.01, 0.99);
    const double stribeck_rad_s = p.size() > 2 ? std::exp(p(3)) : 1;
    // What a solver tries in passing may be too small for any step of the motion.
    const auto is_within = [](double value, double factor, double about) {
      return value > about / factor && value < about * factor;
    };
    if (!is_within(deflection_rad, 30, level_rad()) ||
        !is_within(deflection_rad, 300, amplitude_rad_) ||
        !is_within(stribeck_rad_s, 100, p.size() > 2 ? peak_speed_rad_s_ : 1) ||
        !(coulomb_rad > 0.05 * deflection_rad)) {
      return std::nullopt;
    }
    const std::unique_ptr<friction::DynamicFriction> contact =
        friction::dynamic_friction_model("elasto_plastic")
            .make({{"bristle_stiffness_Nm_rad", false, 1.0},
                   {"bristle_damping_Nms_rad", false, 0.0},
                   {"viscous_Nms_rad", false, 0.0},
                   {"coulomb_Nm", false, coulomb_rad},
                   {"static_Nm", false, deflection_rad},
                   {"stribeck_speed_rad_s", false, stribeck_rad_s},
                   {"break_away_deflection_rad", false, elastic_rad}});
    Eigen::MatrixXd columns = columns_behind(2);
    std::size_t loop = paths_.size();
    std::vector<double> z;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Path& path = paths_[rows_[i].loop];
      if (rows_[i].loop != loop) {
        loop = rows_[i].loop;
        std::vector<double> state = contact->unloaded();
        z.assign(path.steps.size() + 1, 0);
        contact->respond(state, path.steps, std::span(z).subspan(1));
      }
      const double state = z[path.steps_to_row[rows_[i].row]];
      double rate = 0;
      contact->rates({&state, 1}, rows_[i].speed, {&rate, 1});
      const auto k = static_cast<Eigen::Index>(i);
      columns(k, 0) = state;
      columns(k, 1) = rate;
    }
    const Eigen::VectorXd found = statistics::least_squares(columns, measured_);
    if (!(found(0) > 0)) return std::nullopt;
    Fitted out{{ContactLaw::elasto_plastic, found(0), found(0) * deflection_rad, 0},
               columns * found - measured_};
    out.candidate.residual_Nm = rms(out.residuals);
    return out;
  }

  [[nodiscard]] std::optional<Fitted> solved(const Eigen::VectorXd& start) const {
    const statistics::LeastSquaresProblem problem{
        measured_.size(), [&](const Eigen::VectorXd& p, Eigen::VectorXd& r, Eigen::MatrixXd* j) {
          const auto residuals = [&](const Eigen::VectorXd& at_p) -> Eigen::VectorXd {
            const std::optional<Fitted> one = at(at_p);
            return one ? one->residuals : measured_;
          };
          r = residuals(p);
          if (j == nullptr) return;
          constexpr double nearby = 1e-4;
          for (Eigen::Index k = 0; k < p.size(); ++k) {
            Eigen::VectorXd beside = p;
            beside(k) += nearby;
            j->col(k) = (residuals(beside) - r) / nearby;
          }
        }};
    constexpr statistics::LeastSquaresLimits rough{1e-5, 1e-4, 25};
    return at(statistics::solve_least_squares(problem, start, rough).parameters);
  }

  // Maxwell-slip: all linear, none below zero.

  [[nodiscard]] std::optional<Fitted> maxwell_slip(const Fall& fall) const {
    constexpr Eigen::Index elements = 12;
    constexpr double finest = 0.1;  // of the deflection at which LuGre slides
    constexpr double widest = 4;
    constexpr double within = 0.95;  // of the loops' half travel: what slips at more does not slip
    const double last_rad = std::min(widest * level_rad(), within * amplitude_rad_);
    const double first_rad = std::min(finest * level_rad(), last_rad / 10);
    std::vector<double> slips_at;
    for (Eigen::Index k = 0; k < elements; ++k) {
      const double along = static_cast<double>(k) / static_cast<double>(elements - 1);
      slips_at.push_back(first_rad * std::pow(last_rad / first_rad, along));
    }
    Eigen::MatrixXd columns = columns_behind(elements + 1);
    for (Eigen::Index k = 0; k <= elements; ++k) {
      const double limit = k < elements ? slips_at[static_cast<std::size_t>(k)]
                                        : std::numeric_limits<double>::infinity();
      columns.col(k) = stop_operator(limit, fall);
    }
    const Eigen::VectorXd found = nearest_not_negative(columns, elements + 1);
    Fitted out{{ContactLaw::maxwell_slip, found.head(elements + 1).sum(), 0, 0},
               columns * found - measured_};
    for (Eigen::Index k = 0; k < elements; ++k) {
      out.candidate.static_Nm += found(k) * slips_at[static_cast<std::size_t>(k)];
    }
    out.candidate.residual_Nm = rms(out.residuals);
    return out;
  }

  /// Deflection of a spring that slips beyond a limit, at the rows.
  [[nodiscard]] Eigen::VectorXd stop_operator(double limit_rad, const Fall& fall) const {
    Eigen::VectorXd out(static_cast<Eigen::Index>(rows_.size()));
    std::vector<double> deflection;
    std::size_t loop = paths_.size();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Path& path = paths_[rows_[i].loop];
      if (rows_[i].loop != loop) {
        loop = rows_[i].loop;
        deflection.assign(1, 0);
        for (std::size_t s = 0; s < path.steps.size(); ++s) {
          const double limit = limit_rad * fall(path.steps[s].end_rad_s);
          const double moved = path.angle_rad[s + 1] - path.angle_rad[s];
          deflection.push_back(std::clamp(deflection.back() + moved, -limit, limit));
        }
      }
      out(static_cast<Eigen::Index>(i)) = deflection[path.steps_to_row[rows_[i].row]];
    }
    return out;
  }

  /// Least squares with the first coefficients at least zero, by descent along each in turn.
  [[nodiscard]] Eigen::VectorXd nearest_not_negative(const Eigen::MatrixXd& columns,
                                                     Eigen::Index not_negative) const {
    const Eigen::VectorXd norms =
        columns.colwise().norm().transpose().unaryExpr([](double n) { return n > 0 ? n : 1.0; });
    const Eigen::MatrixXd scaled = columns * norms.cwiseInverse().asDiagonal();
    const Eigen::MatrixXd square = scaled.transpose() * scaled;
    const Eigen::VectorXd right = scaled.transpose() * measured_;
    Eigen::VectorXd found = Eigen::VectorXd::Zero(columns.cols());
    constexpr int most_rounds = 20'000;
    constexpr double last_step = 1e-9;
    for (int round = 0; round < most_rounds; ++round) {
      double largest = 0;
      for (Eigen::Index k = 0; k < found.size(); ++k) {
        double next = found(k) + (right(k) - square.row(k).dot(found)) / square(k, k);
        if (k < not_negative) next = std::max(0.0, next);
        largest = std::max(largest, std::abs(next - found(k)));
        found(k) = next;
      }
      if (largest < last_step * found.cwiseAbs().maxCoeff()) break;
    }
    return found.cwiseQuotient(norms);
  }

  const LuGrePoint& lugre_;
  std::vector<Path> paths_;
  std::vector<Row> rows_;
  std::vector<std::size_t> blocks_;
  Eigen::VectorXd measured_, lugre_residuals_;
  double amplitude_rad_{0}, peak_speed_rad_s_{0};
};

}  // namespace

std::string to_string(ContactLaw law) { return own_name(law); }

const ContactCandidate* ContactComparison::find(ContactLaw law) const {
  const auto it = std::find_if(candidates.begin(), candidates.end(),
                               [&](const ContactCandidate& one) { return one.law == law; });
  return it == candidates.end() ? nullptr : &*it;
}

ContactComparison compare_contacts(const std::vector<LuGreInput>& loops,
                                   const LuGreProblem& problem,
                                   const std::vector<std::size_t>& block_of_row,
                                   const LuGrePoint& lugre, double systematic_Nm, double gear_ratio,
                                   double q_peak_rad) {
  ContactComparison out;
  const Comparison comparison(loops, problem, block_of_row, lugre, gear_ratio, q_peak_rad);
  if (!comparison.is_possible()) return out;
  std::vector<Fitted> all{comparison.lugre()};
  for (std::optional<Fitted> fitted : {comparison.elasto_plastic(), comparison.maxwell_slip()}) {
    if (fitted) all.push_back(std::move(*fitted));
  }
  constexpr double least_gain = 0.005;  // noise is most of what they leave
  constexpr double least_share = 0.5;
  const double lugre_leaves = std::pow(all.front().candidate.residual_Nm, 2);
  const auto takes_it_up = [&](const ContactCandidate& candidate) {
    return candidate.law == ContactLaw::lugre || lugre_leaves - std::pow(candidate.residual_Nm, 2) >
                                                     least_share * std::pow(systematic_Nm, 2);
  };
  for (const Fitted& one : all) {
    out.candidates.push_back(one.candidate);
    const bool wins = std::all_of(all.begin(), all.end(), [&](const Fitted& other) {
      return &other == &one || statistics::leaves_less(one.residuals, other.residuals,
                                                       comparison.blocks(), least_gain);
    });
    if (wins && all.size() > 1 && takes_it_up(one.candidate)) out.winner = one.candidate.law;
  }
  return out;
}

}  // namespace tribolog::method::hysteresis
