#include "base/early_end.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <vector>

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

namespace tribolog {
namespace {

struct Outputs {
  std::recursive_mutex guard;
  std::list<std::string> unfinished;
  std::vector<std::string> kept;
  bool are_told{};  ///< By the program that these rooms are; another one that has them inside asks
                    ///< for nothing, and may write files for years.
};

/// Never destroyed: a signal may come at the very end.
Outputs& outputs() {
  static auto& all = *new Outputs;
  return all;
}

sigset_t ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
    struct sigaction action{};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&signals, signal);
  }
  return signals;
}

void tell(int signal) {
  const std::string clear_bar = isatty(STDERR_FILENO) != 0 ? "\r\x1b[K" : "";
  const std::string line = clear_bar + "tribolog: ended by signal " + std::to_string(signal) +
                           " (" + strsignal(signal) + "); " + kept_in_words() + "\n";
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line.data(), line.size());
}

/// What the shell and the caller see is the end by the signal itself.
[[noreturn]] void end_by(int signal) {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  kill(getpid(), signal);
  _exit(128 + signal);  // the first process of a container is not ended by signals
}

void* wait_for_signals(void* /*unused*/) {
  const sigset_t signals = ending_signals();
  int signal = 0;
  while (sigwait(&signals, &signal) != 0) {
  }
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);  // a second one ends the program at once
  outputs().guard.lock();                           // for good: nothing is written any more
  const auto& unfinished = outputs().unfinished;
  for (auto path = unfinished.rbegin(); path != unfinished.rend(); ++path) {
    std::remove(path->c_str());
  }
  tell(signal);
  end_by(signal);
}

/// So that a computer without closed limits and one with little memory have the thread.
bool start_small_thread() {
  constexpr std::size_t stack_bytes = 256 * 1024;
  pthread_attr_t attributes;
  if (pthread_attr_init(&attributes) != 0) return false;
  pthread_attr_setstacksize(&attributes, stack_bytes);
  pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
  pthread_t thread{};
  const bool is_started = pthread_create(&thread, &attributes, wait_for_signals, nullptr) == 0;
  pthread_attr_destroy(&attributes);
  return is_started;
}

/// Where the limit of processor time kills without a warning, the warning comes a second before.
void ask_for_a_warning() {
  rlimit limit{};
  if (getrlimit(RLIMIT_CPU, &limit) != 0 || limit.rlim_max == RLIM_INFINITY) return;
  if (limit.rlim_max < 2 || limit.rlim_cur < limit.rlim_max) return;
  limit.rlim_cur = limit.rlim_max - 1;
  setrlimit(RLIMIT_CPU, &limit);
}

}  // namespace

void end_cleanly_on_signals() {
  std::signal(SIGXFSZ, SIG_IGN);
  ask_for_a_warning();
  outputs().kept.clear();
  outputs().are_told = true;
  const sigset_t signals = ending_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  if (!start_small_thread()) pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

void let_signals_end_this_process() {
  sigset_t none;
  sigemptyset(&none);
  pthread_sigmask(SIG_SETMASK, &none, nullptr);
}

Unfinished::Unfinished(const std::string& path) {
  const Uninterrupted change;
  place_ = outputs().unfinished.insert(outputs().unfinished.end(), path);
}

Unfinished::~Unfinished() {
  const Uninterrupted change;
  outputs().unfinished.erase(place_);
}

Uninterrupted::Uninterrupted() { outputs().guard.lock(); }

Uninterrupted::~Uninterrupted() { outputs().guard.unlock(); }

void note_kept(const std::string& what) {
  const Uninterrupted change;
  if (!outputs().are_told) return;
  auto& kept = outputs().kept;
  if (std::find(kept.begin(), kept.end(), what) == kept.end()) kept.push_back(what);
}

bool is_something_kept() {
  const Uninterrupted reading;
  return !outputs().kept.empty();
}

std::string kept_in_words() {
  const Uninterrupted reading;
  std::string words;
  for (const std::string& what : outputs().kept) words += (words.empty() ? "kept: " : ", ") + what;
  return words.empty() ? "nothing was changed" : words;
}

}  // namespace tribolog
