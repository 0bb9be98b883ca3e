#include "render/workers/worker_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"

namespace tribolog::render::workers {
namespace {

void take_default_signals() {
  for (const int signal : {SIGTERM, SIGPIPE, SIGCHLD, SIGALRM, SIGUSR1, SIGUSR2, SIGSEGV, SIGBUS,
                           SIGFPE, SIGILL, SIGABRT, SIGXCPU}) {
    std::signal(signal, SIG_DFL);
  }
  // A terminal sends these to all processes; the owner decides, and its end is theirs.
  for (const int signal : {SIGINT, SIGHUP, SIGQUIT}) std::signal(signal, SIG_IGN);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

void redirect_output(int errors) {
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nowhere >= 0) {
    dup2(nowhere, STDIN_FILENO);
    dup2(nowhere, STDOUT_FILENO);
  }
  dup2(errors >= 0 ? errors : nowhere, STDERR_FILENO);
}

[[noreturn]] void run(const std::function<void(int)>& work, int socket, int errors, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(0);
  take_default_signals();
  redirect_output(errors);
  try {
    work(socket);
  } catch (...) {
    _exit(1);
  }
  _exit(0);  // no destructor of the parent's objects runs, no buffer is flushed twice
}

std::string last_line(int file) {
  constexpr off_t most = 300;
  const off_t size = lseek(file, 0, SEEK_END);
  if (size <= 0) return {};
  std::array<char, most> buffer{};
  const ssize_t got = pread(file, buffer.data(), buffer.size(), std::max<off_t>(0, size - most));
  std::string text(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(0, got)));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  text = text.substr(text.rfind('\n') + 1);
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
  return text;
}

}  // namespace

WorkerProcess::WorkerProcess(const std::function<void(int socket)>& work) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw FigureError({"drawing.no_socket", {{"reason", std::strerror(errno)}}});
  }
  errors_ = memfd_create("tribolog-worker-errors", MFD_CLOEXEC);
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) {
    close(ends[0]);
    run(work, ends[1], errors_, parent);
  }
  const int reason = errno;
  close(ends[1]);
  socket_ = ends[0];
  if (process_ < 0) {
    close(socket_);
    if (errors_ >= 0) close(errors_);
    throw FigureError({"drawing.no_process", {{"reason", std::strerror(reason)}}});
  }
}

WorkerProcess::~WorkerProcess() {
  end();
  close_socket();
  if (errors_ >= 0) close(errors_);
}

void WorkerProcess::close_socket() {
  if (socket_ >= 0) close(std::exchange(socket_, -1));
}

void WorkerProcess::end_gently(std::chrono::milliseconds most) {
  close_socket();
  wait_for_end(most);
  end();
}

void WorkerProcess::wait_for_end(std::chrono::milliseconds most) {
  const auto deadline = std::chrono::steady_clock::now() + most;
  while (process_ >= 0) {
    if (waitpid(process_, &status_, WNOHANG) == process_) process_ = -1;
    if (process_ < 0 || std::chrono::steady_clock::now() >= deadline) return;
    usleep(1'000);
  }
}

void WorkerProcess::end() {
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  while (waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
}

Statement WorkerProcess::end_and_explain() {
  // One that is ending by itself gets the time to, so that its own status is seen.
  wait_for_end(std::chrono::milliseconds(200));
  end();
  Statement end{"drawing.ended_with_status", {{"status", WEXITSTATUS(status_)}}};
  if (WIFSIGNALED(status_)) {
    const int signal = WTERMSIG(status_);
    end = {"drawing.stopped_by_signal", {{"signal", signal}, {"name", strsignal(signal)}}};
  }
  const std::string said = errors_ >= 0 ? last_line(errors_) : std::string();
  if (said.empty()) return end;
  return {"drawing.last_words", {{"end", end}, {"words", said}}};
}

}  // namespace tribolog::render::workers
