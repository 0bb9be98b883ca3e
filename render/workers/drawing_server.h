#pragma once
// Where drawing processes come from: one process that has started the graphics stack already.

#include <chrono>
#include <memory>
#include <string>

#include "render/workers/fork_server.h"
#include "render/workers/renderer.h"

namespace tribolog::render {

class DrawingServer {
 public:
  /// The graphics stack starts at once, beside what the caller does next.
  explicit DrawingServer(Prepared prepared);

  /// A process in which DrawingWorker::serve runs. If the server was lost, a new one is started
  /// first. Destroy the workers before this.
  /// @param most how long to wait for the graphics stack
  /// @throw tribolog::FigureError if it takes longer, is lost while it starts, or if the system
  /// gives no process.
  std::unique_ptr<ForkServer::Worker> start_worker(std::chrono::milliseconds most);

 private:
  void start(bool warm);
  void wait_until_ready(std::chrono::milliseconds most);

  Prepared prepared_;
  std::unique_ptr<ForkServer> server_;
  std::string start_error_;  ///< Of a stack that does not start: it is not tried again.
};

}  // namespace tribolog::render
