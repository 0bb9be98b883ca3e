#include "base/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace tribolog {
namespace {

/// Cores that no piece of work has taken. Work within work takes what is left of them, and the
/// machine is never asked for more threads than it has cores.
std::atomic<std::size_t>& spare_cores() {
  static std::atomic<std::size_t> spare{std::max(1U, std::thread::hardware_concurrency()) - 1};
  return spare;
}

/// Takes up to `wanted` of them. @return how many
std::size_t take_cores(std::size_t wanted) {
  std::size_t spare = spare_cores();
  while (!spare_cores().compare_exchange_weak(spare, spare - std::min(spare, wanted))) {
  }
  return std::min(spare, wanted);
}

/// Whether this thread does a piece of a call that states its threads.
thread_local bool is_limited = false;

class Limit {
 public:
  explicit Limit(bool limits) : before_(std::exchange(is_limited, is_limited || limits)) {}
  ~Limit() { is_limited = before_; }
  Limit(const Limit&) = delete;
  Limit& operator=(const Limit&) = delete;

 private:
  bool before_;
};

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work,
                  std::size_t threads) {
  if (is_limited) threads = 1;
  const std::size_t most = std::min(threads == 0 ? count : threads, count);
  const std::size_t taken = most <= 1 ? 0 : threads == 0 ? take_cores(most - 1) : most - 1;
  if (taken == 0) {
    const Limit limit(threads != 0);
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex guard;
  const auto run = [&] {
    const Limit limit(threads != 0);
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(guard);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> others;
    try {
      while (others.size() < taken) {
        others.emplace_back([&] {
          run();
          if (threads == 0) ++spare_cores();
        });
      }
    } catch (const std::system_error&) {
      // The system gives no more threads: those there are do the work.
      if (threads == 0) spare_cores() += taken - others.size();
    }
    run();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace tribolog
