#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "joint/gravity_load.h"

namespace tribolog::surrogate_mass_test {
namespace {

struct Row {
  char point;
  double torque_Nm;
  double mass_kg;
};

// Table 2 of the paper, as printed.
constexpr Row table_2[] = {{'A', 3.924, 79.999}, {'B', 3.866, 78.811}, {'C', 4.759, 97.023},
                           {'D', 2.993, 61.009}, {'E', 3.703, 75.494}, {'F', 4.061, 82.785}};

constexpr double gear_ratio = 100;
constexpr double gravity_m_s2 = 9.81;
constexpr double distance_m = 0.5;
// Torque and mass are printed to 0.001: half a digit of each is what the row cannot tell.
constexpr double printed_rounding_kg = 0.0005 * gear_ratio / (gravity_m_s2 * distance_m) + 0.0005;

TEST(SurrogateMass, Table2TorquesGiveTable2Masses) {
  for (const Row& row : table_2) {
    EXPECT_NEAR(joint::surrogate_mass_kg(row.torque_Nm, gear_ratio, distance_m, gravity_m_s2, 1.0),
                row.mass_kg, printed_rounding_kg)
        << "point " << row.point;
  }
}

TEST(SurrogateMass, MisprintsOfThePaperDoNotGiveTable2) {
  // r = 500 m, and the cosine of q_c instead of the angle from the peak: both far off.
  EXPECT_GT(std::abs(joint::surrogate_mass_kg(3.924, gear_ratio, 500, gravity_m_s2, 1.0) - 79.999),
            79);
  EXPECT_GT(std::abs(joint::surrogate_mass_kg(3.924, gear_ratio, distance_m, gravity_m_s2, 0.9257) -
                     79.999),
            6);
}

TEST(SurrogateMass, InvertsTheGravityLoad) {
  const joint::GravityLoad load(12.5, distance_m, 0.3);
  for (const double q : {-0.4, 0.0, 0.3, 1.1}) {
    EXPECT_NEAR(joint::surrogate_mass_kg(load.torque_Nm(q) / gear_ratio, gear_ratio, distance_m,
                                         gravity_m_s2, std::cos(q - 0.3)),
                12.5, 1e-12);
  }
}

TEST(GravityLoad, RefusesWhatCannotBe) {
  EXPECT_THROW(joint::GravityLoad(0, 1, 0), std::invalid_argument);
  EXPECT_THROW(joint::GravityLoad(1, -1, 0), std::invalid_argument);
  EXPECT_THROW(joint::GravityLoad(1, 1, std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::surrogate_mass_test
