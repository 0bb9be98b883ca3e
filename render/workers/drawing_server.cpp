#include "render/workers/drawing_server.h"

#include "base/error.h"
#include "render/workers/drawing_worker.h"

namespace tribolog::render {

DrawingServer::DrawingServer(Prepared prepared) : prepared_(prepared) {
  try {
    start(true);
  } catch (const FigureError&) {
    server_.reset();  // start_worker tries again, and then says why
  }
}

void DrawingServer::start(bool warm) {
  // Made in the new process, and never destroyed there: tearing a graphics stack down takes time.
  auto worker = std::make_shared<DrawingWorker*>(nullptr);
  server_ = std::make_unique<ForkServer>(
      [=, prepared = prepared_] {
        *worker = new DrawingWorker;
        if (warm) (*worker)->warm_up(prepared);
      },
      [=](int socket) { (*worker)->serve(socket); });
}

void DrawingServer::wait_until_ready(std::chrono::milliseconds most) {
  try {
    if (server_->wait(most) == ForkServer::Readiness::has_threads) {
      start(false);
      server_->wait(most);
    }
  } catch (const FigureError& error) {
    start_error_ = error.what();
    throw;
  }
}

std::unique_ptr<ForkServer::Worker> DrawingServer::start_worker(std::chrono::milliseconds most) {
  if (!start_error_.empty()) throw FigureError(start_error_);
  try {
    if (!server_) start(true);
    if (!server_->is_prepared()) wait_until_ready(most);
    return server_->start_worker();
  } catch (const FigureError&) {
    server_.reset();
    throw;
  }
}

}  // namespace tribolog::render
