#include "base/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace tribolog::parallel_for_test {
namespace {

TEST(ParallelFor, DoesEachPieceOnce) {
  for (const std::size_t threads : {0U, 1U, 2U, 7U}) {
    for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
      std::vector<int> done(count, 0);
      parallel_for(count, [&](std::size_t i) { ++done[i]; }, threads);
      EXPECT_EQ(done, std::vector<int>(count, 1));
    }
  }
}

TEST(ParallelFor, WorksInTheCallersThreadIfOneIsAskedFor) {
  std::set<std::thread::id> seen;
  parallel_for(10, [&](std::size_t) { seen.insert(std::this_thread::get_id()); }, 1);
  EXPECT_EQ(seen, std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST(ParallelFor, UsesAsManyThreadsAsAskedFor) {
  // Each piece waits until the other has begun: with one thread this would never end.
  std::atomic<int> begun{0};
  parallel_for(
      2,
      [&](std::size_t) {
        ++begun;
        while (begun < 2) std::this_thread::yield();
      },
      2);
  EXPECT_EQ(begun, 2);
}

// Work within work shares the cores: no more threads than those are at work at any time.
TEST(ParallelFor, MayBeNested) {
  std::vector<std::atomic<int>> done(40);
  std::atomic<int> at_work{0};
  std::atomic<int> most{0};
  parallel_for(4, [&](std::size_t i) {
    parallel_for(10, [&](std::size_t k) {
      const int now = ++at_work;
      for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ++done[10 * i + k];
      --at_work;
    });
  });
  for (const std::atomic<int>& one : done) EXPECT_EQ(one, 1);
  EXPECT_LE(most, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
}

// Who states a number of threads gets no more of them by what the work calls.
TEST(ParallelFor, StartsNoThreadsWithinACallThatStatesThem) {
  std::set<std::thread::id> seen;
  parallel_for(
      3,
      [&](std::size_t) {
        for (const std::size_t threads : {0U, 2U}) {
          parallel_for(10, [&](std::size_t) { seen.insert(std::this_thread::get_id()); }, threads);
        }
      },
      1);
  EXPECT_EQ(seen, std::set<std::thread::id>{std::this_thread::get_id()});
}

// A thread that is done gives its core back.
TEST(ParallelFor, UsesAllCoresAgainAfterwards) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "one core";
  for (int round = 0; round < 50; ++round) {
    std::atomic<int> begun{0};
    parallel_for(2, [&](std::size_t) {
      ++begun;
      while (begun < 2) std::this_thread::yield();
    });
    ASSERT_EQ(begun, 2);
  }
}

TEST(ParallelFor, ThrowsOnWhatAPieceThrows) {
  for (const std::size_t threads : {1U, 3U}) {
    std::atomic<int> done{0};
    const auto work = [&](std::size_t i) {
      if (i == 5) throw std::runtime_error("piece 5");
      ++done;
    };
    EXPECT_THROW(parallel_for(100, work, threads), std::runtime_error);
    EXPECT_LT(done, 100);
  }
}

}  // namespace
}  // namespace tribolog::parallel_for_test
