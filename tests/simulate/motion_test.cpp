#include "simulate/motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace tribolog::motion_test {
namespace {

std::vector<std::unique_ptr<simulate::Motion>> motions() {
  std::vector<std::unique_ptr<simulate::Motion>> all;
  all.push_back(
      std::make_unique<simulate::HarmonicMotion>(simulate::HarmonicMotion::sine(0.4, 0.01, 2)));
  all.push_back(std::make_unique<simulate::HarmonicMotion>(
      0.4, 0.7,
      std::vector<simulate::HarmonicMotion::Harmonic>{{0.1, 0.3}, {0, 0}, {0.02, -0.05}}));
  all.push_back(std::make_unique<simulate::TravelMotion>(
      simulate::TravelMotion::Plan{-1, 0.6, 0.5, 3, true, 0.2}));
  all.push_back(std::make_unique<simulate::TravelMotion>(
      simulate::TravelMotion::Plan{1, -0.3, 0.5, 3, false, 0.1}));
  return all;
}

TEST(Motion, SpeedAndAccelerationAreTheDerivatives) {
  constexpr double h = 1e-5;
  for (const auto& m : motions()) {
    for (double t = 0.05; t < 7; t += 0.0731) {
      EXPECT_NEAR(m->speed(t), (m->angle(t + h) - m->angle(t - h)) / (2 * h), 1e-6) << t;
      EXPECT_NEAR(m->acceleration(t), (m->speed(t + h) - m->speed(t - h)) / (2 * h), 2e-3) << t;
    }
  }
}

TEST(Motion, SpeedsInARowAreTheSpeedsOneByOne) {
  for (const auto& m : motions()) {
    std::vector<double> row(1000);
    m->speeds(0.3, 1.7e-3, row);
    for (std::size_t i = 0; i < row.size(); ++i) {
      EXPECT_NEAR(row[i], m->speed(0.3 + 1.7e-3 * static_cast<double>(i)), 1e-13);
    }
  }
}

TEST(TravelMotion, GoesThereAndBack) {
  const simulate::TravelMotion m({-1, 0.6, 0.5, 3, true, 0.2});
  EXPECT_DOUBLE_EQ(m.angle(0), -1);
  EXPECT_NEAR(m.angle(m.duration_s()), -1, 1e-12);
  double highest = -2;
  double fastest = 0;
  double hardest = 0;
  for (double t = 0; t <= m.duration_s(); t += 1e-3) {
    highest = std::max(highest, m.angle(t));
    fastest = std::max(fastest, std::abs(m.speed(t)));
    hardest = std::max(hardest, std::abs(m.acceleration(t)));
  }
  EXPECT_NEAR(highest, 0.6, 1e-12);
  EXPECT_NEAR(fastest, 0.5, 1e-12);
  EXPECT_NEAR(hardest, 3, 1e-3);
}

TEST(TravelMotion, RefusesAWayTooShortForItsSpeed) {
  EXPECT_THROW(simulate::TravelMotion({0, 0.01, 1, 1, true, 0.1}), std::invalid_argument);
  EXPECT_THROW(simulate::TravelMotion({0, 1, 0, 1, true, 0.1}), std::invalid_argument);
  EXPECT_THROW(simulate::TravelMotion({0, 1, 1, 0, true, 0.1}), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::motion_test
