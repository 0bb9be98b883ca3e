#pragma once
// What a drawing process does: descriptions of figures in, drawn figures out.

#include <memory>

#include "render/figure/figure.h"
#include "render/workers/messages.h"
#include "render/workers/renderer.h"

namespace tribolog::render::workers {

/// The graphics stack of one process, and what it draws with it.
class DrawingWorker {
 public:
  /// Sets the driver up in the environment, where the user has not; starts nothing yet.
  DrawingWorker();
  ~DrawingWorker();
  DrawingWorker(const DrawingWorker&) = delete;
  DrawingWorker& operator=(const DrawingWorker&) = delete;

  /// Starts the graphics stack and draws once what figures of these kinds consist of, so that the
  /// driver has compiled its shaders. A stack that does not start says so again at each figure.
  void warm_up(Prepared prepared);

  /// A figure that cannot be drawn has its `error` set.
  /// @param solid_parts_only see DrawOptions
  DrawnFigure draw(const figure::Figure& figure, bool solid_parts_only = false);

  /// Draws what arrives on the socket until the other side closes it.
  void serve(int socket);

 private:
  struct Stack;
  void start();

  std::unique_ptr<Stack> stack_;
};

/// What DrawingWorker::serve is asked for.
void put_request(Message& message, const figure::Figure& figure, bool solid_parts_only);

/// The answer to one figure, as DrawingWorker::serve sends it.
DrawnFigure read_drawn_figure(Message& message);

/// Starts the graphics stack and sends what it is, or why it does not start.
void serve_info(int socket);

/// The answer of serve_info. @throw tribolog::FigureError with the worker's reason.
figure::RendererInfo read_info(Message& message);

}  // namespace tribolog::render::workers
