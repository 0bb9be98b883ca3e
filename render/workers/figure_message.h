#pragma once
// A figure's description as a message, for the process that draws it.

#include "render/figure/figure.h"
#include "render/workers/message_channel.h"

namespace tribolog::render {

void put_figure(Message& message, const Figure& figure);

/// @throw std::runtime_error if the message ends before the figure does.
Figure take_figure(Message& message);

}  // namespace tribolog::render
