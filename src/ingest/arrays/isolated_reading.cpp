#include "ingest/arrays/isolated_reading.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/early_end.h"
#include "base/error.h"
#include "base/file_contents.h"
#include "base/file_descriptor.h"
#include "ingest/arrays/array_stream.h"

namespace tribolog {
namespace {

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

}  // namespace tribolog
