#include "method/model/quantity_value.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace tribolog::method::model {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;
using joint::Quantity;

bool is_of_friction(const Wanted& wanted) {
  if (wanted.row.size() > 0) return false;
  return !wanted.quantity || *wanted.quantity == Quantity::coulomb_torque ||
         *wanted.quantity == Quantity::viscous_coefficient;
}

namespace {

/// What the torque has of the direction, whatever its sign there: offset and asymmetry.
void add_direction(const JointModel& m, const VectorXd& theta, const Wanted& wanted, Value& v) {
  const auto add = [&](const joint::Effect& effect, const VectorXd& row) {
    const std::size_t e = m.find(effect.key);
    if (e == m.effects.size()) return;
    v.gradient.segment(m.first[e], row.size()) = wanted.direction * row;
    v.value += wanted.direction * row.dot(theta.segment(m.first[e], row.size()));
  };
  add(joint::effect::offset, VectorXd::Ones(1));
  add(joint::effect::asymmetry,
      m.point.asymmetry_at(wanted.speed_rad_s, m.cells.of(&Cell::speed_rad_s).minCoeff())
          .transpose());
}

}  // namespace

Value value_of(const JointModel& m, const LawPosterior& p, const VectorXd& theta,
               const Wanted& wanted, const Meaning& meaning) {
  const Index effects = m.first.back();
  Value v{0, VectorXd::Zero(theta.size())};
  if (wanted.row.size() > 0) {
    v.gradient.head(effects) = wanted.row;
    v.value = wanted.row.dot(theta.head(effects));
    return v;
  }
  const auto law = theta.tail(theta.size() - effects);
  const auto of_law = [&](const Eigen::RowVectorXd& weights) {
    v.gradient.tail(weights.size()) = weights.transpose();
    v.value = weights * law;
  };
  if (!wanted.quantity) {
    Eigen::RowVectorXd weights(law.size());
    for (Index k = 0; k < law.size(); ++k) {
      const LawColumn& column =
          m.laws.columns[static_cast<std::size_t>(p.law.index[static_cast<std::size_t>(k)])];
      weights[k] = column.at(wanted.speed_rad_s, m.laws.fastest_rad_s);
    }
    of_law(weights);
    for (const char* key : {"law_misfit", "law_at_its_ends"}) {
      const std::size_t e = m.find(key);
      if (e == m.effects.size()) continue;
      const Eigen::RowVectorXd hats = key == std::string_view("law_misfit")
                                          ? m.hats.bent(wanted.speed_rad_s)
                                          : m.hats.whole(wanted.speed_rad_s);
      v.gradient.segment(m.first[e], hats.size()) = hats.transpose();
      v.value += hats * theta.segment(m.first[e], hats.size());
    }
    if (wanted.direction != 0) add_direction(m, theta, wanted, v);
    const std::size_t session = m.find(joint::effect::friction_of_session.key);
    if (wanted.of_this_session && session < m.effects.size()) {
      v.gradient[m.first[session]] = m.point.friction_at(wanted.speed_rad_s);
      v.value += v.gradient[m.first[session]] * theta[m.first[session]];
    }
  } else if (*wanted.quantity == Quantity::gravity_torque ||
             *wanted.quantity == Quantity::cog_angle) {
    const Index i = m.first[m.find("gravity")];
    const double c = theta[i];
    const double s = theta[i + 1];
    const double size = std::hypot(c, s);
    if (*wanted.quantity == Quantity::gravity_torque) {
      v.value = size;
      v.gradient[i] = c / size;
      v.gradient[i + 1] = s / size;
    } else {
      v.value = std::atan2(s, c);
      v.gradient[i] = -s / (size * size);
      v.gradient[i + 1] = c / (size * size);
      return v;
    }
  } else if (*wanted.quantity == Quantity::inertia) {
    const Index i = m.first[m.find("inertia")];
    v.value = theta[i];
    v.gradient[i] = 1;
  } else {
    const Index row = *wanted.quantity == Quantity::coulomb_torque ? 0 : 1;
    of_law(p.law.meanings[meaning.of_law].row(row));
  }
  if (is_of_friction(wanted)) {
    v.value *= 1 + meaning.friction_change;
    v.gradient *= 1 + meaning.friction_change;
  }
  const std::size_t gain = m.find("gain_drift");
  if (gain < m.effects.size() && meaning.moment != 0) {
    const double change = meaning.moment * theta[m.first[gain]];
    const double before = v.value;
    v.value *= 1 + change;
    v.gradient *= 1 + change;
    v.gradient[m.first[gain]] += meaning.moment * before;
  }
  return v;
}

std::array<double, 3> moments_of(const Cells& cells) {
  const ArrayXd t = cells.of(&Cell::time_s);
  const ArrayXd run = cells.of(&Cell::is_run);
  const ArrayXd share = cells.of(&Cell::count) * ((run > 0).any() ? run : ArrayXd::Ones(t.size()));
  const auto [first, last] = cells.session_s();
  const double span = std::max(last - first, 1e-9);
  const double there = 2 * ((share * t).sum() / share.sum() - first) / span - 1;
  return {-1 - there, 0, 1 - there};
}

std::array<double, 3> friction_changes(const JointModel& m, const VectorXd& theta) {
  const std::size_t drift = m.find("drift");
  if (drift == m.effects.size()) return {0, 0, 0};
  const ArrayXd changed =
      (m.effects[drift].columns * theta.segment(m.first[drift], m.width(drift))).array() *
      m.cells.of(&Cell::direction) / m.point.friction_Nm;
  Index begin = 0;
  Index end = 0;
  const ArrayXd t = m.cells.of(&Cell::time_s);
  t.minCoeff(&begin);
  t.maxCoeff(&end);
  return {changed[begin], 0, changed[end]};
}

}  // namespace tribolog::method::model
