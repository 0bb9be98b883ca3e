#pragma once
// What a drawing process does: numbers of figures in, drawn figures out.

#include <vector>

#include "render/figure.h"
#include "render/renderer.h"
#include "render/workers/message_channel.h"

namespace tribolog::render {

/// Serves figure numbers from the socket until the other side closes it. The graphics stack starts
/// with the first one. `alone`: no other worker draws at the same time, so the driver may use
/// threads. `foreign_sockets` are those of other workers, inherited by the fork, to be closed.
void serve_figures(int socket, const std::vector<Figure>& figures, bool alone,
                   const std::vector<int>& foreign_sockets);

/// Starts the graphics stack and sends what it is, or why it does not start.
void serve_info(int socket);

/// The answer to one figure number, as serve_figures sends it.
DrawnFigure read_drawn_figure(Message& message);

/// The answer of serve_info. @throw tribolog::FigureError with the worker's reason.
RendererInfo read_info(Message& message);

}  // namespace tribolog::render
