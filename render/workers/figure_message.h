#pragma once
// A figure's description as a message, for the process that draws it.

#include "render/figure/figure.h"
#include "render/workers/message_channel.h"

namespace tribolog::render::workers {

void put_figure(Message& message, const figure::Figure& figure);

/// @throw tribolog::FigureError if the message ends before the figure does.
figure::Figure take_figure(Message& message);

}  // namespace tribolog::render::workers
