#include "method/session/friction_drift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include <Eigen/Core>

#include "statistics/distributions.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::session {
namespace {

// Relative repeatability of a level of friction, beyond what the blocks of a recording show.
constexpr double repeatability = 0.0015;
constexpr double one_speed = 0.03;
constexpr std::size_t fewest_levels_of_law = 9;
constexpr Eigen::Index law_columns = 5;
constexpr double largest_chance_of_drift = 0.01;
constexpr double least_change = 0.01;
// A larger change is not warm-up, but a law that does not describe the levels.
constexpr double largest_change = 1;
constexpr std::array time_constants{0.0, 1.0, 0.6, 0.4, 0.3, 0.22, 0.15, 0.1};

struct Law {
  double stribeck_rad_s, exponent, power;
};

/// Columns of the law at a speed, or of the family.
class Columns {
 public:
  explicit Columns(const std::vector<FrictionLevel>& levels) : levels_(levels) {
    std::vector<double> speeds;
    for (const FrictionLevel& l : levels) {
      if (l.family >= 0) {
        families_.emplace(l.family, 0);
      } else {
        speeds.push_back(l.speed_rad_s);
      }
    }
    std::sort(speeds.begin(), speeds.end());
    for (const double v : speeds) {
      if (distinct_.empty() || v > (1 + one_speed) * distinct_.back()) distinct_.push_back(v);
    }
    has_law_ = distinct_.size() >= fewest_levels_of_law;
    Eigen::Index next = has_law_ ? law_columns : static_cast<Eigen::Index>(distinct_.size());
    for (auto& [family, column] : families_) column = next++;
    count_ = next;
  }

  [[nodiscard]] Eigen::Index count() const { return count_; }

  [[nodiscard]] bool has_law() const { return has_law_; }
  [[nodiscard]] double slowest() const { return distinct_.front(); }
  [[nodiscard]] double fastest() const { return distinct_.back(); }

  void fill(const Law& law, Eigen::MatrixXd& x) const {
    x.leftCols(count_).setZero();
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      const FrictionLevel& l = levels_[i];
      const auto row = static_cast<Eigen::Index>(i);
      if (l.family >= 0) {
        x(row, families_.at(l.family)) = 1;
      } else if (has_law_) {
        x(row, 0) = 1;
        x(row, 1) = std::exp(-std::pow(l.speed_rad_s / law.stribeck_rad_s, law.exponent));
        x(row, 2) = std::pow(l.speed_rad_s / distinct_.back(), law.power);
        const double decades = std::log(l.speed_rad_s / distinct_.front()) /
                               std::log(distinct_.back() / distinct_.front());
        x(row, 3) = 2 * decades - 1;
        x(row, 4) = std::pow(2 * decades - 1, 2);
      } else {
        const auto at = std::upper_bound(distinct_.begin(), distinct_.end(), l.speed_rad_s);
        x(row, std::max<std::ptrdiff_t>(0, at - distinct_.begin() - 1)) = 1;
      }
    }
  }

 private:
  const std::vector<FrictionLevel>& levels_;
  std::vector<double> distinct_;
  std::map<int, Eigen::Index> families_;
  bool has_law_{};
  Eigen::Index count_{};
};

struct Trial {
  double chi2, change, standard_error, time_constant;
};

class Fitter {
 public:
  explicit Fitter(const std::vector<FrictionLevel>& levels) : levels_(levels), columns_(levels) {
    const auto n = static_cast<Eigen::Index>(levels.size());
    y_.resize(n);
    weight_.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const FrictionLevel& l = levels[static_cast<std::size_t>(i)];
      y_(i) = l.friction_Nm;
      weight_(i) = 1 / std::hypot(l.standard_error_Nm, repeatability * l.friction_Nm);
    }
  }

  /// Residual degrees of freedom with the change; the searched parameters of the law and the time
  /// constant count.
  [[nodiscard]] double freedom() const {
    return static_cast<double>(y_.size() - columns_.count() - 1) - (columns_.has_law() ? 2 : 0);
  }

  double chi2_without() const {
    Eigen::MatrixXd x(y_.size(), columns_.count());
    double best = std::numeric_limits<double>::infinity();
    for (const Trial& trial : over_laws([&](const Law& law) {
           columns_.fill(law, x);
           return Trial{solve(x).first, 0, 0, 0};
         })) {
      best = std::min(best, trial.chi2);
    }
    return best;
  }

  /// Every law with every time constant.
  std::vector<Trial> trials() const {
    std::vector<Trial> all;
    Eigen::MatrixXd x(y_.size(), columns_.count() + 1);
    for (const double tau : time_constants) {
      Eigen::VectorXd passed(y_.size());
      for (Eigen::Index i = 0; i < y_.size(); ++i) {
        const FrictionLevel& l = levels_[static_cast<std::size_t>(i)];
        double g = 0;
        for (const double share : l.session_share) g += progress(share, tau);
        passed(i) = g / static_cast<double>(l.session_share.size());
      }
      const std::vector<Trial> of_tau = over_laws([&](const Law& law) {
        columns_.fill(law, x);
        return with_change(passed, tau, x);
      });
      all.insert(all.end(), of_tau.begin(), of_tau.end());
    }
    return all;
  }

 private:
  /// One trial for each law of a grid, which is refined about the best speed of the dip.
  template <class Try>
  std::vector<Trial> over_laws(Try attempt) const {
    if (!columns_.has_law()) return {attempt(Law{1, 1, 1})};
    constexpr int coarse = 10;
    constexpr int halvings = 4;
    std::vector<Trial> all;
    const double low = std::log(0.7 * columns_.slowest());
    const double high = std::log(0.7 * columns_.fastest());
    for (const double d : {0.7, 1.0, 2.0}) {
      for (const double p : {1.0, 0.6}) {
        double best_at = low;
        double least = std::numeric_limits<double>::infinity();
        const auto at = [&](double log_speed) {
          all.push_back(attempt(Law{std::exp(log_speed), d, p}));
          if (all.back().chi2 < least) {
            least = all.back().chi2;
            best_at = log_speed;
          }
        };
        double step = (high - low) / (coarse - 1);
        for (int k = 0; k < coarse; ++k) at(low + k * step);
        for (int k = 0; k < halvings; ++k) {
          step /= 2;
          const double middle = best_at;
          at(middle - step);
          at(middle + step);
        }
      }
    }
    return all;
  }

  /// The change is relative to the friction at the start, of which the level is only an estimate:
  /// fits a second time with that of the first.
  Trial with_change(const Eigen::VectorXd& passed, double tau, Eigen::MatrixXd& x) const {
    Trial trial{};
    for (int round = 0; round < 2; ++round) {
      x.col(columns_.count()) =
          passed.cwiseProduct(y_.cwiseQuotient((1 + trial.change * passed.array()).matrix()));
      const auto [chi2, c] = solve(x);
      // The first fit took the level for the friction at the start.
      const double w = round == 0 ? c(columns_.count()) / (1 - std::min(c(columns_.count()), 0.9))
                                  : c(columns_.count());
      trial = {chi2, std::clamp(w, -0.9, 9.0), 0, tau};
    }
    trial.standard_error = error_of_last(x);
    return trial;
  }

  [[nodiscard]] std::pair<double, Eigen::VectorXd> solve(const Eigen::MatrixXd& x) const {
    const Eigen::MatrixXd weighted = weight_.asDiagonal() * x;
    const Eigen::VectorXd y = weight_.cwiseProduct(y_);
    const Eigen::VectorXd c = statistics::least_squares(weighted, y);
    return {(y - weighted * c).squaredNorm(), c};
  }

  /// Standard error of the last coefficient, taking the errors as given.
  [[nodiscard]] double error_of_last(const Eigen::MatrixXd& x) const {
    const Eigen::MatrixXd weighted = weight_.asDiagonal() * x;
    const Eigen::Index last = x.cols() - 1;
    const Eigen::VectorXd column = weighted.col(last);
    const Eigen::VectorXd rest = statistics::left_by_columns(weighted.leftCols(last), column);
    return 1 / std::max(rest.norm(), 1e-300);
  }

  const std::vector<FrictionLevel>& levels_;
  Columns columns_;
  Eigen::VectorXd y_, weight_;
};

}  // namespace

double progress(double share, double time_constant) {
  if (!(time_constant > 0)) return share;
  return std::expm1(-share / time_constant) / std::expm1(-1 / time_constant);
}

FrictionDrift fit_friction_drift(const std::vector<FrictionLevel>& levels) {
  FrictionDrift out;
  out.levels = levels.size();
  if (levels.size() < 3) return out;
  const Fitter fitter(levels);
  const double freedom = fitter.freedom();
  if (freedom < 1) return out;
  const std::vector<Trial> trials = fitter.trials();
  const auto best = std::min_element(
      trials.begin(), trials.end(), [](const Trial& a, const Trial& b) { return a.chi2 < b.chi2; });
  // What is left may be more than the levels' own errors: all errors are larger then.
  const double scale = std::max(1.0, best->chi2 / freedom);
  constexpr double looked_at = 2;  // the change, and its time constant
  out.chance = statistics::f_upper_tail(
      std::max(0.0, fitter.chi2_without() - best->chi2) / looked_at / scale, looked_at, freedom);
  const double t = statistics::student_t_975(freedom);
  out.examined = true;
  out.change = out.low = out.high = best->change;
  out.time_constant = best->time_constant;
  std::map<double, const Trial*> best_of;
  std::map<double, bool> is_as_good;
  for (const Trial& trial : trials) {
    const Trial*& one = best_of[trial.time_constant];
    if (one == nullptr || trial.chi2 < one->chi2) one = &trial;
    if (trial.chi2 > best->chi2 + t * t * scale) continue;
    const double half_width = t * std::sqrt(scale) * trial.standard_error;
    out.low = std::min(out.low, trial.change - half_width);
    out.high = std::max(out.high, trial.change + half_width);
    is_as_good[trial.time_constant] = true;
  }
  for (std::size_t k = 0; k < time_constants.size(); ++k) {
    const double tau = time_constants[k];
    // The next ones of the grid too: what lies between was not tried.
    const bool is_next =
        (k > 0 && time_constants[k - 1] == best->time_constant) ||
        (k + 1 < time_constants.size() && time_constants[k + 1] == best->time_constant);
    if (!is_next && !is_as_good[tau]) continue;
    out.other_time_constants.push_back(tau);
    out.other_changes.push_back(best_of[tau]->change);
  }
  out.found = out.chance < largest_chance_of_drift && std::abs(out.change) > least_change &&
              std::abs(out.change) < largest_change && out.low * out.high > 0;
  return out;
}

}  // namespace tribolog::method::session
