#include "ingest/arrays/isolated_reading.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/early_end.h"
#include "base/error.h"
#include "base/file_descriptor.h"
#include "base/input_file.h"
#include "ingest/arrays/array_tables.h"

namespace tribolog::ingest::arrays {

// FileArrays from one process to another through a pipe.

namespace {

/// @return false where the other end is closed.
bool send_arrays(int pipe, const FileArrays& found);
bool send_refusal(int pipe, const std::string& reason);

struct ReceivedArrays {
  bool is_complete{};   ///< Otherwise the sender ended too early, or sent what cannot be.
  std::string refusal;  ///< Empty: `found` holds what was sent.
  FileArrays found;
};
ReceivedArrays receive_arrays(int pipe);

constexpr std::uint8_t arrays_follow = 1;
constexpr std::uint8_t refusal_follows = 2;
/// The sender may have gone mad: more is not believed.
constexpr std::uint64_t longest_text = std::uint64_t{1} << 20;
constexpr std::uint64_t most_entries = std::uint64_t{1} << 20;

class Sender {
 public:
  explicit Sender(int pipe) : pipe_(pipe) {}

  void bytes(const void* data, std::size_t count) {
    const char* next = static_cast<const char*>(data);
    while (ok_ && count > 0) {
      const ssize_t done = ::write(pipe_, next, count);
      if (done < 0 && errno == EINTR) continue;
      ok_ = done > 0;
      if (!ok_) return;
      next += done;
      count -= static_cast<std::size_t>(done);
    }
  }
  void number(std::uint64_t value) { bytes(&value, sizeof value); }
  void text(const std::string& value) {
    const std::uint64_t length = std::min<std::uint64_t>(value.size(), longest_text);
    number(length);
    bytes(value.data(), length);
  }
  [[nodiscard]] bool ok() const { return ok_; }

 private:
  int pipe_;
  bool ok_{true};
};

class Receiver {
 public:
  explicit Receiver(int pipe) : pipe_(pipe) {}

  void bytes(void* data, std::size_t count) {
    char* next = static_cast<char*>(data);
    while (ok_ && count > 0) {
      const ssize_t done = ::read(pipe_, next, count);
      if (done < 0 && errno == EINTR) continue;
      ok_ = done > 0;
      if (!ok_) return;
      next += done;
      count -= static_cast<std::size_t>(done);
    }
  }
  std::uint64_t number(std::uint64_t largest) {
    std::uint64_t value{};
    bytes(&value, sizeof value);
    ok_ = ok_ && value <= largest;
    return ok_ ? value : 0;
  }
  std::string text() {
    std::string value(number(longest_text), '\0');
    bytes(value.data(), value.size());
    return value;
  }
  NamedArray array(std::uint64_t& values_left) {
    NamedArray result;
    result.name = text();
    result.unit = text();
    result.rows = number(most_values);
    result.columns = number(most_values);
    result.by_columns = number(1) == 1;
    result.was_rounded = number(1) == 1;
    const std::uint64_t count = number(values_left);
    ok_ = ok_ && count > 0 && result.rows > 0 && count / result.rows == result.columns &&
          count % result.rows == 0;
    if (!ok_) return result;
    values_left -= count;
    result.values.resize(count);
    bytes(result.values.data(), count * sizeof(double));
    return result;
  }
  [[nodiscard]] bool ok() const { return ok_; }

 private:
  int pipe_;
  bool ok_{true};
};

using Pairs = std::vector<std::pair<std::string, std::string>>;

void send_pairs(Sender& sender, const Pairs& pairs) {
  sender.number(pairs.size());
  for (const auto& [name, text] : pairs) {
    sender.text(name);
    sender.text(text);
  }
}

Pairs receive_pairs(Receiver& receiver) {
  Pairs pairs;
  const std::uint64_t count = receiver.number(most_entries);
  for (std::uint64_t i = 0; i < count && receiver.ok(); ++i) {
    std::string name = receiver.text();
    pairs.emplace_back(std::move(name), receiver.text());
  }
  return pairs;
}

bool send_arrays(int pipe, const FileArrays& found) {
  Sender sender(pipe);
  sender.bytes(&arrays_follow, 1);
  sender.number(found.arrays.size());
  for (const NamedArray& array : found.arrays) {
    sender.text(array.name);
    sender.text(array.unit);
    sender.number(array.rows);
    sender.number(array.columns);
    sender.number(array.by_columns ? 1 : 0);
    sender.number(array.was_rounded ? 1 : 0);
    sender.number(array.values.size());
    sender.bytes(array.values.data(), array.values.size() * sizeof(double));
  }
  send_pairs(sender, found.texts);
  send_pairs(sender, found.left_out);
  return sender.ok();
}

bool send_refusal(int pipe, const std::string& reason) {
  Sender sender(pipe);
  sender.bytes(&refusal_follows, 1);
  sender.text(reason);
  return sender.ok();
}

ReceivedArrays receive_arrays(int pipe) {
  Receiver receiver(pipe);
  ReceivedArrays received;
  std::uint8_t kind{};
  receiver.bytes(&kind, 1);
  if (kind == refusal_follows) {
    received.refusal = receiver.text();
  } else if (kind == arrays_follow) {
    std::uint64_t values_left = most_values;
    const std::uint64_t count = receiver.number(most_entries);
    for (std::uint64_t i = 0; i < count && receiver.ok(); ++i) {
      received.found.arrays.push_back(receiver.array(values_left));
    }
    received.found.texts = receive_pairs(receiver);
    received.found.left_out = receive_pairs(receiver);
  }
  received.is_complete = receiver.ok() && (kind == arrays_follow || !received.refusal.empty());
  return received;
}

[[noreturn]] void refuse(const std::string& path, const std::string& what,
                         const std::string& hint = {}) {
  throw InputError({path, 0, 0}, {what, "", "", hint});
}

void set_limit(decltype(RLIMIT_CPU) resource, std::uint64_t value) {
  const rlimit limit{value, value};
  ::setrlimit(resource, &limit);
}

/// What this process has mapped already counts as well.
std::uint64_t mapped_bytes() {
  const FileDescriptor file(::open("/proc/self/statm", O_RDONLY | O_CLOEXEC));
  char text[64] = {};
  if (!file.is_open() || ::read(file.get(), text, sizeof text - 1) <= 0) return 0;
  return std::strtoull(text, nullptr, 10) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void bound_resources(std::uint64_t file_bytes) {
  constexpr std::uint64_t largest_ratio = 1032;  // of deflate, the densest filter in use
  constexpr std::uint64_t gibibyte = std::uint64_t{1} << 30;
  set_limit(RLIMIT_CORE, 0);
  set_limit(RLIMIT_CPU, 60 + (file_bytes >> 20));
#ifndef __SANITIZE_ADDRESS__  // which maps terabytes
  // Twice: the library's copy and ours.
  const std::uint64_t unpacked = std::min(2 * largest_ratio * file_bytes, 23 * gibibyte);
  set_limit(RLIMIT_AS, mapped_bytes() + gibibyte + unpacked);
#endif
}

void silence() {
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nowhere < 0) return;
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
}

/// Never returns: the child must not run what its parent would have run afterwards.
[[noreturn]] void read_and_send(int pipe, std::uint64_t file_bytes,
                                const std::function<FileArrays()>& read, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGXCPU, SIGINT, SIGTERM}) {
    std::signal(signal, SIG_DFL);
  }
  let_signals_end_this_process();
  silence();
  bound_resources(file_bytes);
  bool sent = false;
  try {
    sent = send_arrays(pipe, read());
  } catch (const UnreadableFile& error) {
    sent = send_refusal(pipe, error.what());
  } catch (const std::bad_alloc&) {
    sent = send_refusal(pipe, "damaged file: it claims more memory than it can fill");
  } catch (...) {
  }
  ::_exit(sent ? 0 : 1);
}

int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

FileArrays read_isolated(const std::string& path, const std::function<FileArrays()>& read) {
  const std::uint64_t file_bytes = size_of_file(path);
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) refuse(path, std::string("cannot read: ") + strerror(errno));
  FileDescriptor receiving(ends[0]);
  FileDescriptor sending(ends[1]);
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) refuse(path, std::string("cannot read: ") + strerror(errno));
  if (child == 0) read_and_send(sending.get(), file_bytes, read, parent);
  (void)sending.close();
  ReceivedArrays received;
  try {
    received = receive_arrays(receiving.get());
  } catch (...) {  // no memory
    ::kill(child, SIGKILL);
    wait_for(child);
    throw;
  }
  (void)receiving.close();
  const int status = wait_for(child);
  if (!received.is_complete) {
    const bool ran_too_long =
        WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
    refuse(path,
           ran_too_long ? "damaged file: reading it does not end"
                        : "damaged file: the library that reads it failed",
           "copy or record it again");
  }
  if (!received.refusal.empty()) refuse(path, received.refusal);
  return std::move(received.found);
}

}  // namespace tribolog::ingest::arrays
