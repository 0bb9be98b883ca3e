#include <memory>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "base/requirements.h"

namespace tribolog::present_test {
namespace {

TEST(Present, IsTheValueItself) {
  std::optional<std::string> name = "tau";
  present(name) += "_Nm";
  EXPECT_EQ(name, "tau_Nm");
  const std::optional<std::string>& same = name;
  EXPECT_EQ(&present(same), &*same);
  EXPECT_EQ(*present(std::optional(std::make_unique<int>(7))), 7);
}

TEST(Present, IsAFaultOfTheProgramWhereThereIsNone) {
  std::optional<double> torque_Nm;
  const std::optional<double>& same = torque_Nm;
  EXPECT_THROW((void)present(torque_Nm), std::logic_error);
  EXPECT_THROW((void)present(same), std::logic_error);
  EXPECT_THROW((void)present(std::optional<double>()), std::logic_error);
}

}  // namespace
}  // namespace tribolog::present_test
