// Recordings of any size with anything in them: no crash, and no number without an interval.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "joint/quantity.h"
#include "method/model/joint_log.h"
#include "statistics/random_stream.h"
#include "support/breadth.h"

namespace tribolog::odd_recordings_test {
namespace {

using joint::Recording;
using method::model::ModelEffect;
using method::model::ModelQuantity;
using method::model::ModelResult;
using method::model::VarianceShare;
using statistics::RandomStream;
using test::JointLog;

void expect_numbers(const ModelResult& result, const std::string& what) {
  for (const ModelQuantity& q : result.quantities) {
    const std::string name =
        what + ", " + (q.quantity ? to_string(*q.quantity) : std::to_string(q.speed_rad_s));
    EXPECT_TRUE(std::isfinite(q.estimate)) << name;
    EXPECT_TRUE(std::isfinite(q.low)) << name;
    EXPECT_TRUE(std::isfinite(q.high)) << name;
    EXPECT_LE(q.low, q.high) << name;
    for (const VarianceShare& share : q.shares) {
      EXPECT_TRUE(std::isfinite(share.share)) << name << ", " << share.effect;
    }
  }
  for (const ModelEffect& effect : result.effects) {
    EXPECT_TRUE(std::isfinite(effect.torque_Nm)) << what << ", " << effect.key;
    EXPECT_TRUE(std::isfinite(effect.size_of_cap)) << what << ", " << effect.key;
    EXPECT_FALSE(std::isinf(effect.chi2)) << what << ", " << effect.key;
  }
  EXPECT_TRUE(std::isfinite(result.cells_far_off)) << what;
  EXPECT_TRUE(std::isfinite(result.samples_per_independent)) << what;
}

std::size_t any_index(RandomStream& random, std::size_t size) {
  return std::min(size - 1, static_cast<std::size_t>(random.uniform() * static_cast<double>(size)));
}

/// A wave of any speed and length, of torque that may have to do with it or not.
Recording any_recording(RandomStream& random) {
  Recording r;
  r.name = random.uniform() < 0.5 ? "one" : "other";
  r.role = random.uniform() < 0.5 ? joint::Role::rough_sweep : joint::Role::constant_speed;
  const auto count = static_cast<std::size_t>(std::pow(10, 3.2 * random.uniform())) - 1;
  const double dt = std::pow(10, -3 + 2 * random.uniform());
  const double way = std::pow(10, -2 + 4 * random.uniform());
  const double omega = std::pow(10, -1 + 2 * random.uniform());
  const double noise = std::pow(10, -6 + 6 * random.uniform());
  const double friction = random.uniform();
  for (std::size_t i = 0; i < count; ++i) {
    const double t = dt * static_cast<double>(i);
    r.t_s.push_back(t);
    r.q_rad.push_back(way * std::sin(omega * t) + noise * random.normal() * way);
    r.torque_Nm.push_back(std::cos(r.q_rad.back()) + std::copysign(friction, std::cos(omega * t)) +
                          noise * random.normal());
  }
  return r;
}

void damage(Recording& r, RandomStream& random) {
  if (r.size() < 2) return;
  switch (static_cast<int>(random.uniform() * 9)) {
    case 0:  // stamps twice
      for (int k = 0; k < 5; ++k) {
        const std::size_t at = 1 + any_index(random, r.size() - 1);
        r.t_s[at] = r.t_s[at - 1];
      }
      break;
    case 1: {  // a gap in time
      const std::size_t at = any_index(random, r.size());
      for (std::size_t i = at; i < r.size(); ++i) r.t_s[i] += 1000;
      break;
    }
    case 2: {  // a jump of the angle
      const std::size_t at = any_index(random, r.size());
      for (std::size_t i = at; i < r.size(); ++i) r.q_rad[i] += 6;
      break;
    }
    case 3:  // one stamp for all
      std::fill(r.t_s.begin(), r.t_s.end(), 1.0);
      break;
    case 4:  // no torque but once
      std::fill(r.torque_Nm.begin(), r.torque_Nm.end(), 0.0);
      r.torque_Nm[any_index(random, r.size())] = 1;
      break;
    case 5:  // the torque is the angle
      r.torque_Nm = r.q_rad;
      break;
    case 6:  // a huge outlier
      r.torque_Nm[any_index(random, r.size())] = 1e12;
      break;
    case 7:  // stamps in packets
      for (std::size_t i = 0; i < r.size(); ++i) {
        r.t_s[i] = r.t_s[i / 8 * 8] + 1e-9 * static_cast<double>(i % 8);
      }
      break;
    default:
      break;
  }
}

TEST(OddRecordings, GiveNumbersOrNone) {
  const std::size_t seeds = test::seeds_of(300, 3000);
  std::size_t answered = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    RandomStream random(seed, 0);
    JointLog log;
    const auto count = static_cast<int>(4 * random.uniform());
    for (int k = 0; k < count; ++k) {
      log.recordings.push_back(any_recording(random));
      damage(log.recordings.back(), random);
    }
    std::vector<joint::FrictionPoints> points;
    if (random.uniform() < 0.3) {
      joint::FrictionPoints p;
      const auto size = static_cast<int>(20 * random.uniform());
      const double scale = random.uniform() < 0.3 ? 0 : std::pow(10, -5 + 8 * random.uniform());
      for (int k = 0; k < size; ++k) {
        p.speed_rad_s.push_back(random.normal());
        p.torque_Nm.push_back(scale * random.normal());
      }
      points.push_back(std::move(p));
    }
    const double n = random.uniform() < 0.5 ? 1 : 100 * random.uniform() + 0.01;
    const ModelResult result =
        method::model::identify_joint(log.all(), points, n, random.uniform() < 0.5);
    answered += result.empty() ? 0 : 1;
    expect_numbers(result, "seed " + std::to_string(seed));
    if (HasFailure()) return;
  }
  EXPECT_GT(answered, seeds / 5) << "most say nothing: this looks at little";
}

TEST(OddRecordings, DamagedOnesOfASoundJointGiveNumbers) {
  const std::size_t seeds = test::seeds_of(30, 300);
  test::Session session;
  session.dt_s = 0.02;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    RandomStream random(seed, 1);
    JointLog log = test::record({}, session, seed);
    for (Recording& r : log.recordings) {
      if (random.uniform() < 0.5) damage(r, random);
    }
    expect_numbers(log.identified(50), "seed " + std::to_string(seed));
    if (HasFailure()) return;
  }
}

TEST(OddRecordings, PointsWithoutTorqueGiveNumbersOrNone) {
  for (const double torque : {0.0, 1e-300, 1.0, 1e200}) {
    joint::FrictionPoints p;
    for (int k = 0; k < 30; ++k) {
      p.speed_rad_s.push_back((k % 2 == 0 ? 1 : -1) * (1 + k));
      p.torque_Nm.push_back(k % 2 == 0 ? torque : -torque);
    }
    expect_numbers(method::model::identify_joint({}, {p}, 1, true), std::to_string(torque));
  }
}

}  // namespace
}  // namespace tribolog::odd_recordings_test
