#include "ingest/log/register.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

namespace tribolog::register_test {
namespace {

using ingest::log::Register;

/// A sine of this amplitude as whole numbers.
std::vector<double> sine(double amplitude) {
  std::vector<double> values;
  for (int i = 0; i < 2000; ++i) values.push_back(std::round(amplitude * std::sin(0.01 * i)));
  return values;
}

TEST(Register, IsFoundByTheJumpsBetweenItsEnds) {
  for (const char* name :
       {"unsigned 8", "unsigned 16", "unsigned 32", "sign bit 15", "sign bit 10", "sign bit 11"}) {
    const auto of = ingest::log::register_named(name);
    ASSERT_TRUE(of.has_value()) << name;
    const std::vector<double> meant = sine(0.3 * of->modulus / 2);
    std::vector<double> logged;
    for (const double value : meant) {
      logged.push_back(
          value >= 0 ? value : (of->has_sign_bit ? of->modulus / 2 - value : of->modulus + value));
    }
    const auto found = ingest::log::find_register(logged);
    ASSERT_TRUE(found.has_value()) << name;
    EXPECT_EQ(ingest::log::to_string(*found), name);
    for (std::size_t i = 0; i < meant.size(); ++i) {
      ASSERT_EQ(found->value_of(logged[i]), meant[i]) << name << " " << i;
    }
  }
}

TEST(Register, IsNoneWhereNumbersAreSignedOrDoNotJump) {
  EXPECT_FALSE(ingest::log::find_register(sine(20000)));
  std::vector<double> rising;
  for (int i = 0; i < 65536; i += 16) rising.push_back(i);
  EXPECT_FALSE(ingest::log::find_register(rising));
  std::vector<double> fractions = sine(20000);
  for (double& value : fractions) value = std::fmod(value + 65536, 65536) + 0.5;
  EXPECT_FALSE(ingest::log::find_register(fractions));
  // An angle that wraps round jumps too, but goes over all numbers between.
  std::vector<double> angle;
  for (int i = 0; i < 40000; ++i) angle.push_back((i * 13) % 65536);
  const auto found = ingest::log::find_register(angle);
  EXPECT_FALSE(found.has_value());
}

TEST(Register, NamesAreThoseOfAManifest) {
  EXPECT_FALSE(ingest::log::register_named("unsigned 17"));
  EXPECT_NE(ingest::log::register_names().find("sign bit 15"), std::string::npos);
}

}  // namespace
}  // namespace tribolog::register_test
