// Samples that stand in several rows are found, and nothing else.

#include "ingest/dataset/held_rows.h"

#include <numeric>

#include <gtest/gtest.h>

namespace tribolog::held_rows_test {
namespace {

std::vector<std::size_t> all_rows(std::size_t n) {
  std::vector<std::size_t> rows(n);
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

std::vector<double> held(std::size_t n, std::size_t each, double step) {
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) values.push_back(step * static_cast<double>(i / each));
  return values;
}

TEST(HeldRows, AreThoseInWhichAllSignalsRepeat) {
  const std::vector<double> q = held(600, 5, 0.01);
  const std::vector<double> tau = held(600, 5, -0.3);
  const auto found = ingest::dataset::find_held_rows(all_rows(600), {&q, &tau});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->rows_per_sample, 5U);
  ASSERT_EQ(found->kept.size(), 120U);
  for (std::size_t k = 0; k < found->kept.size(); ++k) EXPECT_EQ(found->kept[k], 5 * k);
}

TEST(HeldRows, MayComeEveryFourthOrFifthRow) {
  std::vector<double> q;
  std::vector<double> tau;
  std::vector<std::size_t> begins;
  for (std::size_t sample = 0; sample < 200; ++sample) {
    begins.push_back(q.size());
    q.insert(q.end(), 4 + sample % 2, 0.01 * static_cast<double>(sample));
    tau.insert(tau.end(), 4 + sample % 2, 1 - 0.02 * static_cast<double>(sample));
  }
  const auto found = ingest::dataset::find_held_rows(all_rows(q.size()), {&q, &tau});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kept, begins);
}

TEST(HeldRows, OfAJointAtRestAreThinnedAsTheOthersAre) {
  std::vector<double> q = held(1000, 5, 0.01);
  std::vector<double> tau = held(1000, 5, -0.3);
  for (std::size_t i = 500; i < 600; ++i) {
    q[i] = q[500];
    tau[i] = tau[500];
  }
  const auto found = ingest::dataset::find_held_rows(all_rows(1000), {&q, &tau});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kept.size(), 200U);
  for (std::size_t k = 0; k < found->kept.size(); ++k) EXPECT_EQ(found->kept[k], 5 * k);
}

TEST(HeldRows, AreNoneOfOneSignalOrOfSignalsThatChangeApart) {
  const std::vector<double> q = held(600, 5, 0.01);
  std::vector<double> shifted = held(600, 5, 0.02);
  shifted.insert(shifted.begin(), 2, -1.0);
  const std::vector<double> noisy = held(600, 1, 0.1);
  const auto rows = all_rows(600);
  EXPECT_FALSE(ingest::dataset::find_held_rows(rows, {&q}));
  EXPECT_FALSE(ingest::dataset::find_held_rows(rows, {&q, &shifted}));
  EXPECT_FALSE(ingest::dataset::find_held_rows(rows, {&q, &noisy}));
  EXPECT_FALSE(ingest::dataset::find_held_rows(rows, {&noisy, &noisy})) << "a sample in each row";
  EXPECT_FALSE(ingest::dataset::find_held_rows(all_rows(200), {&q, &q})) << "too few to tell";
}

}  // namespace
}  // namespace tribolog::held_rows_test
