#include "stages/student_t.h"

#include <cmath>

#include <gtest/gtest.h>

namespace tribolog {
namespace {

TEST(StudentT, AgreesWithPublishedTables) {
  // 97.5 % quantiles from standard tables.
  EXPECT_NEAR(student_t_975(1), 12.7062, 1e-3);
  EXPECT_NEAR(student_t_975(2), 4.3027, 1e-3);
  EXPECT_NEAR(student_t_975(3), 3.1824, 1e-3);
  EXPECT_NEAR(student_t_975(5), 2.5706, 1e-3);
  EXPECT_NEAR(student_t_975(8), 2.3060, 1e-3);
  EXPECT_NEAR(student_t_975(30), 2.0423, 1e-3);
  EXPECT_NEAR(student_t_975(1e7), 1.95996, 1e-4);
}

TEST(StudentT, SaysNothingWithoutFreedom) {
  EXPECT_TRUE(std::isinf(student_t_975(0)));
  EXPECT_TRUE(std::isinf(student_t_975(std::nan(""))));
}

}  // namespace
}  // namespace tribolog
