#include "render/workers/renderer.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <exception>
#include <memory>
#include <numeric>
#include <string>

#include <poll.h>

#include "base/error.h"
#include "render/text/font.h"
#include "render/workers/drawing_worker.h"
#include "render/workers/messages.h"
#include "render/workers/worker_process.h"

namespace tribolog::render::workers {

// Where drawing processes come from: one process that has started the graphics stack already.

namespace {

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
  Statement start_error_;  ///< Of a stack that does not start: it is not tried again.
};

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
    start_error_ = error.statement();
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

using Clock = std::chrono::steady_clock;

/// Hands figures out to workers one by one, and replaces a worker that is lost.
class DrawingCrew {
 public:
  DrawingCrew(DrawingServer& server, int processes, const std::vector<figure::Figure>& figures,
              const DrawOptions& options)
      : server_(server),
        figures_(figures),
        options_(options),
        drawn_(figures.size()),
        order_(figures.size()) {
    for (std::size_t i = 0; i < figures.size(); ++i) {
      drawn_[i].id = figures[i].id;
      drawn_[i].width_px = figures[i].width_px;
      drawn_[i].height_px = figures[i].height_px;
    }
    // Scenes take longest: begun last, one would keep a worker busy while the others wait.
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_partition(order_.begin(), order_.end(),
                          [&](std::size_t i) { return figures[i].scene.has_value(); });
    const auto wanted = static_cast<std::size_t>(std::max(1, processes));
    members_.resize(std::min(wanted, figures.size()));
  }

  std::vector<DrawnFigure> run() {
    for (Member& member : members_) give_next(member);
    while (std::any_of(members_.begin(), members_.end(), is_busy)) wait_and_collect();
    return std::move(drawn_);
  }

 private:
  struct Member {
    std::unique_ptr<ForkServer::Worker> worker;
    MessageReader reader;
    std::size_t figure{};
    Clock::time_point deadline;
    bool busy{false};
  };
  static bool is_busy(const Member& member) { return member.busy; }

  void give_next(Member& member) {
    member.busy = false;
    while (next_ < figures_.size() && !member.busy) {
      member.figure = order_[next_++];
      try {
        if (!member.worker) {
          member.reader = MessageReader();
          member.worker = server_.start_worker(options_.most_per_figure);
        }
        Message request;
        put_request(request, figures_[member.figure], options_.solid_parts_only);
        member.deadline = Clock::now() + options_.most_per_figure;
        member.busy = true;
        // A worker that has gone is noticed when its answer is awaited.
        send_message(member.worker->socket(), request);
      } catch (const std::exception& problem) {
        finish(member.figure, stated_by(problem));
      }
    }
    if (!member.busy) member.worker.reset();
  }

  void wait_and_collect() {
    std::vector<pollfd> sockets;
    std::vector<Member*> owners;
    Clock::time_point first = Clock::time_point::max();
    for (Member& member : members_) {
      if (!member.busy) continue;
      sockets.push_back({member.worker->socket(), POLLIN, 0});
      owners.push_back(&member);
      first = std::min(first, member.deadline);
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(first - Clock::now());
    const int timeout = static_cast<int>(std::clamp<long long>(left.count(), 0, 60'000));
    if (poll(sockets.data(), sockets.size(), timeout) < 0 && errno != EINTR) {
      throw FigureError({"drawing.not_waited_for"});
    }
    for (std::size_t i = 0; i < sockets.size(); ++i) {
      if (sockets[i].revents != 0) {
        collect(*owners[i]);
      } else if (Clock::now() >= owners[i]->deadline) {
        owners[i]->worker->end_and_explain();
        lose(*owners[i], {"drawing.took_too_long"});
      }
    }
  }

  void collect(Member& member) {
    switch (member.reader.read_some(member.worker->socket())) {
      case MessageReader::State::incomplete:
        return;
      case MessageReader::State::closed:
        lose(member, {"drawing.process_lost", {{"end", member.worker->end_and_explain()}}});
        return;
      case MessageReader::State::complete:
        break;
    }
    try {
      Message answer = member.reader.take();
      DrawnFigure received = read_drawn_figure(answer);
      drawn_[member.figure].png = std::move(received.png);
      drawn_[member.figure].warnings = std::move(received.warnings);
      drawn_[member.figure].drawn_by = std::move(received.drawn_by);
      finish(member.figure, received.error);
    } catch (const std::runtime_error& problem) {
      lose(member, stated_by(problem));
      return;
    }
    give_next(member);
  }

  void lose(Member& member, const Statement& why) {
    member.worker.reset();
    finish(member.figure, why);
    give_next(member);
  }

  void finish(std::size_t figure, const Statement& error) {
    drawn_[figure].error = error;
    if (!error.empty()) drawn_[figure].png.clear();
    ++done_;
    if (options_.progress) options_.progress(done_, figures_.size());
  }

  DrawingServer& server_;
  const std::vector<figure::Figure>& figures_;
  const DrawOptions& options_;
  std::vector<DrawnFigure> drawn_;
  std::vector<Member> members_;
  std::vector<std::size_t> order_;  ///< In which figures are begun.
  std::size_t next_{0};
  std::size_t done_{0};
};

}  // namespace

struct FigureRenderer::Parts {
  Parts(int at_once, Prepared prepared) : server(prepared), processes(at_once) {}
  DrawingServer server;
  int processes;
};

FigureRenderer::FigureRenderer(int processes, Prepared prepared)
    : parts_(std::make_unique<Parts>(processes, prepared)) {}

FigureRenderer::~FigureRenderer() = default;

std::vector<DrawnFigure> FigureRenderer::draw(const std::vector<figure::Figure>& figures,
                                              const DrawOptions& options) {
  return DrawingCrew(parts_->server, parts_->processes, figures, options).run();
}

figure::RendererInfo built_renderer() {
  figure::RendererInfo info;
  info.vtk_version = TRIBOLOG_VTK_VERSION;
  info.back_end = TRIBOLOG_GL_NAME;
  info.font = text::Font().file(text::Weight::regular);
  info.freetype_version = text::Font::freetype_version();
  return info;
}

figure::RendererInfo renderer_info() {
  WorkerProcess worker([](int socket) { serve_info(socket); });
  auto answer = receive_message(worker.socket());
  if (!answer) {
    throw FigureError({"drawing.stack_does_not_start", {{"end", worker.end_and_explain()}}});
  }
  return read_info(*answer);
}

}  // namespace tribolog::render::workers
