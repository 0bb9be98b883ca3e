#pragma once
// Processes on the other end of a socket: one that is forked for its work, and a server that
// prepares something expensive once and then forks workers that have it already.

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>

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

/// Starting a graphics stack costs a quarter of a second, most of it for compiling shaders. The
/// server does that while its owner computes; the workers share what it made, page by page, until
/// they change it. Only a process with a single thread can be forked like this: a driver with
/// threads of its own says so by Readiness::has_threads, and then a server that prepares nothing
/// serves as well, each of its workers starting the stack for itself.
class ForkServer {
 public:
  enum class Readiness { ready, has_threads };

  /// Forks at once. In the server `prepare` runs once; in each worker `serve(socket)`, and the
  /// worker ends when that returns.
  /// @throw tribolog::FigureError if the system gives no process.
  ForkServer(const std::function<void()>& prepare, const std::function<void(int)>& serve);
  /// Ends and reaps the server and its workers.
  ~ForkServer();
  ForkServer(const ForkServer&) = delete;
  ForkServer& operator=(const ForkServer&) = delete;

  /// Waits until `prepare` is done. To be called once, before the first start_worker().
  /// @throw tribolog::FigureError if it takes longer than `most`, or if the server was lost.
  Readiness wait(std::chrono::milliseconds most);
  /// Has wait() returned?
  [[nodiscard]] bool is_prepared() const { return is_prepared_; }

  /// A worker forked off the server. It ends when its owner goes and closes the socket, at the
  /// latest with the server.
  class Worker {
   public:
    Worker(ForkServer& server, std::uint32_t number, int socket);
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    [[nodiscard]] int socket() const { return socket_; }
    /// Gives it a moment to end by itself, then ends it, and says how it had ended, as
    /// WorkerProcess does.
    Statement end_and_explain();

   private:
    ForkServer& server_;
    std::uint32_t number_;
    int socket_;
  };

  /// @throw tribolog::FigureError if the server was lost or the system gives no process.
  std::unique_ptr<Worker> start_worker();

 private:
  Statement end_worker(std::uint32_t number);
  [[noreturn]] void lost();

  WorkerProcess process_;
  bool is_prepared_{false};
  std::uint32_t started_{0};
};

}  // namespace tribolog::render::workers
