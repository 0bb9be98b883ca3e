#pragma once
// A forked process on the other end of a socket.

#include <chrono>
#include <functional>

#include <sys/types.h>

#include "base/statement.h"

namespace tribolog::render::workers {

/// Ends and reaps its process when it goes, so that none outlives its owner. The process prints
/// nothing: its standard output goes nowhere, what it writes to standard error is kept.
class WorkerProcess {
 public:
  /// Forks and runs `work(socket)` in the new process, which ends when that returns. The new
  /// process dies with its parent and does not inherit signal handlers.
  /// @throw tribolog::FigureError if the system gives no process.
  explicit WorkerProcess(const std::function<void(int socket)>& work);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  [[nodiscard]] int socket() const { return socket_; }
  /// The process sees its other end closed.
  void close_socket();

  /// Closes the socket and gives the process this long to end by itself.
  void end_gently(std::chrono::milliseconds most);

  /// Ends it at once and says how it had ended: "it was stopped by signal 11 (Segmentation fault)"
  /// with the last line that it wrote to standard error, if any.
  Statement end_and_explain();

 private:
  void end();
  void wait_for_end(std::chrono::milliseconds most);

  pid_t process_{-1};
  int socket_{-1};
  int errors_{-1};
  int status_{0};
};

}  // namespace tribolog::render::workers
