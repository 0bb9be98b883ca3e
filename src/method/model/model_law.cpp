#include "method/model/model_law.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace tribolog::method::model {
namespace {

constexpr double beyond_doubt = 0.95;

/// Values with their probabilities.
using Weighed = std::map<double, double>;

/// Below which that share of their probability lies: each value stands for what is nearer to it
/// than to the next. @param step of the outermost ones.
double quantile(const Weighed& all, double share, double step) {
  double total = 0;
  for (const auto& [value, weight] : all) total += weight;
  double below = 0;
  double from = all.begin()->first - step / 2;
  for (auto at = all.begin(); at != all.end(); ++at) {
    const auto next = std::next(at);
    const double to = next == all.end() ? at->first + step / 2 : (at->first + next->first) / 2;
    const double here = at->second / total;
    if (below + here >= share) return from + (share - below) / here * (to - from);
    below += here;
    from = to;
  }
  return from;
}

}  // namespace

double SpeedLaw::friction_Nm(double speed_rad_s) const {
  const double share = speed_rad_s / fastest_rad_s;
  const double dip =
      dip_rad_s == 0 ? 0 : excess_Nm * std::exp(-std::pow(speed_rad_s / dip_rad_s, dip_power));
  return level_Nm + rise_Nm * std::pow(share, power) + bend_Nm * share * share + dip;
}

std::vector<double> SpeedLaw::friction_Nm(const std::vector<double>& speed_rad_s) const {
  std::vector<double> all;
  all.reserve(speed_rad_s.size());
  for (const double speed : speed_rad_s) all.push_back(friction_Nm(speed));
  return all;
}

bool ModelLaw::bends() const { return bend_probability > beyond_doubt; }

bool ModelLaw::carries_waiboer() const { return dip_probability > beyond_doubt && bends(); }

std::vector<double> ModelLaw::speeds_rad_s(int count) const {
  std::vector<double> all;
  const double steps = count - 1;
  for (int i = 0; i < count; ++i) {
    all.push_back(slowest_rad_s * std::pow(fastest_rad_s / slowest_rad_s, i / steps));
  }
  return all;
}

Statement described(const SpeedLaw& law) {
  const bool has_dip = law.dip_rad_s > 0;
  if (law.family == "line") return has_dip ? Code{"law.line_with_dip"} : Code{"law.line"};
  if (law.family == "parabola") {
    return has_dip ? Code{"law.parabola_with_dip"} : Code{"law.parabola"};
  }
  return {has_dip ? Code{"law.power_with_dip"} : Code{"law.power"}, {{"power", law.power}}};
}

namespace {

SpeedLaw in_numbers(const JointModel& model, const LawPosterior& posterior) {
  const Eigen::VectorXd friction = posterior.friction();
  SpeedLaw law;
  law.family = posterior.law.family;
  law.fastest_rad_s = model.laws.fastest_rad_s;
  law.level_Nm = friction[0];
  for (std::size_t k = 1; k < posterior.law.index.size(); ++k) {
    const double torque_Nm = friction[static_cast<Eigen::Index>(k)];
    const LawColumn& column = model.laws.columns[static_cast<std::size_t>(posterior.law.index[k])];
    if (column.dip_speed > 0) {
      law.excess_Nm = torque_Nm;
      law.dip_rad_s = column.dip_speed;
      law.dip_power = column.dip_power;
    } else if (k > 1) {
      law.bend_Nm = torque_Nm;
    } else {
      law.rise_Nm = torque_Nm;
      law.power = column.power;
    }
  }
  return law;
}

/// The likeliest of each form, and how likely the form is.
std::vector<CandidateLaw> candidates_of(const JointModel& model) {
  std::vector<CandidateLaw> all;
  // Sorted by weight: the first of a form is its likeliest.
  for (const LawPosterior& one : model.posteriors) {
    const auto known = std::find_if(all.begin(), all.end(), [&](const CandidateLaw& c) {
      return c.law.family == one.law.family && (c.law.dip_rad_s > 0) == one.law.has_dip;
    });
    if (known != all.end()) {
      known->probability += one.weight;
    } else {
      all.push_back({in_numbers(model, one), one.weight});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const CandidateLaw& a, const CandidateLaw& b) {
    return a.probability > b.probability;
  });
  return all;
}

}  // namespace

ModelLaw law_of(const JointModel& model) {
  ModelLaw law;
  static_cast<SpeedLaw&>(law) = in_numbers(model, model.posteriors.front());
  law.candidates = candidates_of(model);
  law.slowest_rad_s = slowest_stated(model.cells);
  Weighed speeds;  // logarithms
  Weighed powers;
  for (const LawPosterior& one : model.posteriors) {
    if (one.law.family != "line") law.bend_probability += one.weight;
    if (!one.law.has_dip) continue;
    law.dip_probability += one.weight;
    speeds[std::log(one.law.dip.dip_speed)] += one.weight;
    powers[one.law.dip.dip_power] += one.weight;
  }
  if (law.dip_probability < beyond_doubt || law.excess_Nm <= 0) return law;
  constexpr double speed_step = 0.05;  // of the logarithm
  constexpr double power_step = 0.3;
  const auto speed_at = [&](double share) { return std::exp(quantile(speeds, share, speed_step)); };
  law.stribeck_speed_rad_s =
      statistics::Estimate{speed_at(0.5), speed_at(0.025), speed_at(0.975), {"interval.of_model"}};
  law.lowest_power = quantile(powers, 0.025, power_step);
  law.highest_power = quantile(powers, 0.975, power_step);
  return law;
}

}  // namespace tribolog::method::model
